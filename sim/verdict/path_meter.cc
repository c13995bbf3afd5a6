// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/path_meter.h"

#include <algorithm>
#include <cmath>

#include "models/support/require.h"

namespace sidestep {
namespace {

constexpr double kStandCycle_s = 1.0;  // long against a sway, short against a run

}  // namespace

double GaitCycle_s(const GaitParams& gait, std::size_t num_feet) {
  switch (gait.type) {
    case GaitType::kStand:
      return kStandCycle_s;
    case GaitType::kWalk:
      return static_cast<double>(num_feet) * (gait.swing_s + gait.double_support_s);
    case GaitType::kRun:
      return static_cast<double>(num_feet) * (gait.stance_s + gait.flight_s);
    case GaitType::kHop:
      return gait.stance_s + gait.flight_s;
  }
  return kStandCycle_s;
}

PathMeter::PathMeter(const NominalMotion& nominal, const AskedGait& asked, double rate_hz)
    : tick_s_(nominal.tick_s()),
      period_(std::max<Tick>(1, TickAt(1.0 / rate_hz, tick_s_))),
      gait_(asked.segments),
      num_feet_(nominal.num_feet()),
      line_(nominal) {}

const PathSample& PathMeter::Add(Tick tick, const WorldTruth& truth) {
  SIDESTEP_REQUIRE(Samples(tick), tick);
  const std::size_t cycle = CycleSamples(static_cast<double>(tick));
  const auto period = static_cast<double>(period_);
  const double was_at = past_.empty() ? static_cast<double>(tick) : on_line_tick_ + period;
  const Eigen::Vector2d p_WC = truth.p_WC.head<2>();
  const PathLine::Point nearest =
      line_.NearestTo(p_WC, was_at, static_cast<double>(cycle) * period, tick);
  on_line_tick_ = nearest.tick;
  const Eigen::Vector2d offset_m = p_WC - nearest.p_WC;
  last_.tick = tick;
  MeasureOffset(offset_m, cycle);
  MeasureSpeed(truth, cycle);
  MeasurePace(truth);
  const Eigen::Vector2d sum_m =
      past_.empty() ? Eigen::Vector2d::Zero().eval() : past_.back().offset_sum_m;
  past_.push_back({p_WC, sum_m + offset_m});
  return last_;
}

std::size_t PathMeter::CycleSamples(double tick) const {
  const double now_s = tick * tick_s_;
  double cycle_s = kStandCycle_s;
  for (const GaitParams& gait : gait_) {
    if (gait.start_s <= now_s) cycle_s = GaitCycle_s(gait, num_feet_);
  }
  return static_cast<std::size_t>(std::max<Tick>(1, TickAt(cycle_s, tick_s_) / period_));
}

// Over `cycle` samples with the present one, or as many as there are.
void PathMeter::MeasureOffset(const Eigen::Vector2d& offset_m, std::size_t cycle) {
  const std::size_t at = past_.size();
  Eigen::Vector2d sum_m = offset_m;
  if (at > 0) sum_m += past_.back().offset_sum_m;
  if (at >= cycle) sum_m -= past_[at - cycle].offset_sum_m;
  const Eigen::Vector2d mean_m = sum_m / static_cast<double>(std::min(cycle, at + 1));
  last_.error_m = offset_m.norm();
  last_.drift_m = mean_m.norm();
  last_.wander_m = (offset_m - mean_m).norm();
  max_error_m_ = std::fmax(max_error_m_, last_.error_m);  // fmax drops the first NaN
}

// From the place `cycle` samples ago, or the first, to the present one.
void PathMeter::MeasureSpeed(const WorldTruth& truth, std::size_t cycle) {
  const std::size_t back = std::min(cycle, past_.size());
  const Eigen::Vector2d velocity_mps = MeanVelocity_mps(truth, back);
  const Eigen::Vector2d nominal_mps = NominalVelocity_mps(static_cast<double>(last_.tick), back);
  last_.speed_mps = velocity_mps.norm();
  last_.speed_error_mps = (velocity_mps - nominal_mps).norm();
}

void PathMeter::MeasurePace(const WorldTruth& truth) {
  const std::size_t back = std::min(CycleSamples(on_line_tick_), past_.size());
  last_.pace_error_mps =
      (MeanVelocity_mps(truth, back) - NominalVelocity_mps(on_line_tick_, back)).norm();
}

// Over the last `back` samples.
Eigen::Vector2d PathMeter::MeanVelocity_mps(const WorldTruth& truth, std::size_t back) const {
  if (back == 0) return truth.v_WC.head<2>();
  const double back_s = static_cast<double>(back) * static_cast<double>(period_) * tick_s_;
  return (truth.p_WC.head<2>() - past_[past_.size() - back].p_WC) / back_s;
}

// Over as long a time, ending at `end_tick`.
Eigen::Vector2d PathMeter::NominalVelocity_mps(double end_tick, std::size_t back) const {
  if (back == 0) return Eigen::Vector2d::Zero();  // it starts at rest
  const double back_ticks = static_cast<double>(back) * static_cast<double>(period_);
  return (line_.At(end_tick) - line_.At(end_tick - back_ticks)) / (back_ticks * tick_s_);
}

}  // namespace sidestep
