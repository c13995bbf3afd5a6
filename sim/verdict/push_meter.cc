// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/push_meter.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "sim/scenario/push_ticks.h"

namespace sidestep {
namespace {

// Of the definition; README.md quotes them.
constexpr double kPath_m = 0.05;
constexpr double kSpeed_mps = 0.1;
constexpr double kUpright_rad = 0.2;
constexpr double kHold_s = 1.0;

bool IsCalm(const PathSample& sample, double tilt_rad) {
  const bool goes_on = sample.pace_error_mps < kSpeed_mps || sample.speed_mps < kSpeed_mps;
  return sample.wander_m < kPath_m && goes_on && tilt_rad < kUpright_rad;
}

}  // namespace

PushMeter::PushMeter(const std::vector<Push>& pushes, double tick_s)
    : tick_s_(tick_s), disturbance_of_push_(pushes.size()) {
  std::vector<std::size_t> by_start(pushes.size());
  std::iota(by_start.begin(), by_start.end(), std::size_t{0});
  std::stable_sort(by_start.begin(), by_start.end(), [&](std::size_t left, std::size_t right) {
    return pushes[left].start_s < pushes[right].start_s;
  });
  const Tick hold = TickAt(kHold_s, tick_s);
  for (const std::size_t push : by_start) {
    const PushTicks ticks = TicksOf(pushes[push], tick_s);
    const Tick start = ticks.first;
    const Tick end = ticks.beyond;
    if (disturbances_.empty() || start - disturbances_.back().end > hold) {
      if (!disturbances_.empty()) disturbances_.back().window_end = start;
      disturbances_.emplace_back().start = start;
    }
    disturbances_.back().end = std::max(disturbances_.back().end, end);
    disturbance_of_push_[push] = disturbances_.size() - 1;
  }
}

void PushMeter::ReplacePushes(const std::vector<Push>& pushes) {
  PushMeter other(pushes, tick_s_);
  disturbances_ = std::move(other.disturbances_);
  disturbance_of_push_ = std::move(other.disturbance_of_push_);
}

// The disturbance in whose window `tick` is, or null.
PushMeter::Disturbance* PushMeter::At(Tick tick) {
  const auto found = std::find_if(disturbances_.begin(), disturbances_.end(), [&](const auto& one) {
    return tick >= one.start && tick < one.window_end;
  });
  return found == disturbances_.end() ? nullptr : &*found;
}

void PushMeter::AddTilt(Tick tick, double tilt_rad) {
  tilt_rad_ = tilt_rad;
  Disturbance* const one = At(tick);
  if (one == nullptr) return;
  double& peak_rad = one->figures.peak_tilt_rad;
  peak_rad = std::fmax(peak_rad, tilt_rad);  // fmax drops the first NaN
}

void PushMeter::AddPath(const PathSample& sample) {
  is_calm_ = IsCalm(sample, tilt_rad_);
  Disturbance* const one = At(sample.tick);
  if (one == nullptr) return;
  one->figures.drift_m = sample.drift_m;
  if (sample.tick < one->end || one->figures.recovered || has_fallen_) return;
  if (!is_calm_) {
    one->calm_since.reset();
    return;
  }
  if (!one->calm_since) one->calm_since = sample.tick;
  if (sample.tick - *one->calm_since < TickAt(kHold_s, tick_s_)) return;
  one->figures.recovered = true;
  one->figures.recovery_time_s = SecondsAt(*one->calm_since - one->end, tick_s_);
}

void PushMeter::AddStep(Tick tick, std::optional<double> adjustment_m) {
  Disturbance* const one = At(tick);
  if (one == nullptr) return;
  ++one->figures.steps_taken;
  double& largest_m = one->figures.max_step_adjustment_m;
  if (adjustment_m) largest_m = std::max(largest_m, *adjustment_m);
}

void PushMeter::AddFall(Tick tick) {
  has_fallen_ = true;
  Disturbance* const one = At(tick);
  if (one == nullptr) return;
  one->figures.recovered = false;
  one->figures.recovery_time_s = std::numeric_limits<double>::infinity();
}

const PushFigures& PushMeter::figures(std::size_t push) const {
  return disturbances_.at(disturbance_of_push_.at(push)).figures;
}

double PushMeter::worst_recovery_time_s() const {
  double worst_s = std::numeric_limits<double>::quiet_NaN();
  for (const Disturbance& one : disturbances_) {
    worst_s = std::fmax(worst_s, one.figures.recovery_time_s);
  }
  return worst_s;
}

bool PushMeter::all_recovered() const {
  return std::all_of(disturbances_.begin(), disturbances_.end(),
                     [](const Disturbance& one) { return one.figures.recovered; });
}

}  // namespace sidestep
