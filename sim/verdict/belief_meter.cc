// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/belief_meter.h"

#include <algorithm>
#include <cmath>

#include "sim/scenario/push_ticks.h"

namespace sidestep {
namespace {

constexpr double kAfterPush_s = 1.0;  // of the definition: a belief gone wrong shows by then

}  // namespace

void ErrorFigures::Add(double error) {
  max_ = std::fmax(max_, error);  // fmax drops the first NaN
  sum_of_squares_ += error * error;
  ++count_;
}

double ErrorFigures::rms() const {
  if (count_ == 0) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(sum_of_squares_ / count_);
}

BeliefMeter::BeliefMeter(const std::vector<Push>& pushes, double tick_s) : tick_s_(tick_s) {
  ReplacePushes(pushes);
}

void BeliefMeter::ReplacePushes(const std::vector<Push>& pushes) {
  windows_.clear();
  for (const Push& push : pushes) {
    const PushTicks ticks = TicksOf(push, tick_s_);
    windows_.push_back({ticks.first, ticks.beyond + TickAt(kAfterPush_s, tick_s_)});
  }
}

void BeliefMeter::Add(Tick tick, const WorldTruth& truth, const RobotState& belief) {
  if (belief.feet.empty()) return;
  const double error_mps = (belief.v_WC - truth.v_WC).norm();
  com_velocity_mps_.Add(error_mps);
  const bool is_pushed = std::any_of(windows_.begin(), windows_.end(), [&](const Window& window) {
    return tick >= window.start && tick <= window.end;
  });
  if (is_pushed) pushed_com_velocity_mps_.Add(error_mps);
  Eigen::Vector2d error_N = belief.external_wrench.force_N.head<2>();
  for (const PushTruth& push : truth.pushes) error_N -= push.force_W_N.head<2>();
  push_N_.Add(error_N.norm());
}

}  // namespace sidestep
