// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/path_meter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sidestep {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRecoveredPath_m = 0.05;    // of the metric's definition
constexpr double kRecoveredSpeed_mps = 0.1;  // of the metric's definition
constexpr double kStandCycle_s = 1.0;        // long against a sway, short against a run

// The nominal line is looked at through this many chords each way: over a cycle of a walk with
// 0.1 m of sway they are within 0.05 mm of it.
constexpr std::size_t kChords = 100;

double DistanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& a,
                         const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double squared_m2 = ab.squaredNorm();
  const double share =
      squared_m2 > 0.0 ? std::clamp((point - a).dot(ab) / squared_m2, 0.0, 1.0) : 0.0;
  return (point - a - share * ab).norm();
}

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

PathMeter::PathMeter(const Scenario& scenario)
    : tick_s_(scenario.world.step_s),
      period_s_(1.0 / scenario.control.rate_hz),
      follows_robot_(scenario.control.planner.follow == FollowMode::kCapturePoint),
      gait_(scenario.gait),
      num_feet_(scenario.description_of_robot.feet.size()) {}

void PathMeter::Add(Tick tick, const WorldTruth& truth, const ComReference& reference) {
  const Eigen::Vector2d before_m =
      samples_.empty() ? Eigen::Vector2d::Zero().eval() : samples_.back().drift_m;
  const Eigen::Vector2d error_mps = (truth.v_WC - reference.v_WC).head<2>();
  samples_.push_back(
      {tick, truth.p_WC.head<2>(), reference.p_WC.head<2>(), before_m + period_s_ * error_mps});
}

std::size_t PathMeter::CycleSamples(std::size_t at) const {
  const double now_s = SecondsAt(samples_[at].tick, tick_s_);
  double cycle_s = kStandCycle_s;
  for (const GaitParams& gait : gait_) {
    if (gait.start_s <= now_s) cycle_s = GaitCycle_s(gait, num_feet_);
  }
  return static_cast<std::size_t>(std::max<long>(1, std::lround(cycle_s / period_s_)));
}

double PathMeter::PathError(std::size_t at) const {
  const Sample& now = samples_[at];
  double error_m = (now.p_WC - now.reference_p_WC).norm();
  if (follows_robot_) return error_m;
  const std::size_t reach = CycleSamples(at);
  const std::size_t stride = std::max<std::size_t>(1, reach / kChords);
  const std::size_t first = at - std::min(at, reach) / stride * stride;
  const std::size_t last = std::min(samples_.size() - 1, at + reach);
  for (std::size_t i = first; i + stride <= last; i += stride) {
    error_m = std::min(error_m, DistanceToSegment(now.p_WC, samples_[i].reference_p_WC,
                                                  samples_[i + stride].reference_p_WC));
  }
  return error_m;
}

double PathMeter::SpeedError(std::size_t at) const {
  const std::size_t cycle = std::min(CycleSamples(at), at + 1);
  const Eigen::Vector2d before_m =
      cycle == at + 1 ? Eigen::Vector2d::Zero().eval() : samples_[at - cycle].drift_m;
  return (samples_[at].drift_m - before_m).norm() / (static_cast<double>(cycle) * period_s_);
}

PathFigures PathMeter::Conclude(std::optional<Tick> push_end) const {
  PathFigures figures{kNaN, kNaN, kNaN, push_end ? kInfinity : kNaN};
  if (samples_.empty()) return figures;
  figures.max_path_error_m = 0.0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const double path_error_m = PathError(i);
    const double speed_error_mps = SpeedError(i);
    figures.final_path_error_m = path_error_m;
    figures.final_speed_error_mps = speed_error_mps;
    figures.max_path_error_m = std::max(figures.max_path_error_m, path_error_m);
    if (!push_end || samples_[i].tick < *push_end) continue;
    const bool is_back = path_error_m < kRecoveredPath_m && speed_error_mps < kRecoveredSpeed_mps;
    if (!is_back) {
      figures.recovery_time_s = kInfinity;
    } else if (!std::isfinite(figures.recovery_time_s)) {
      figures.recovery_time_s = SecondsAt(samples_[i].tick - *push_end, tick_s_);
    }
  }
  return figures;
}

}  // namespace sidestep
