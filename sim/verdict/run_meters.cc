// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/run_meters.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "models/support/gravity.h"
#include "models/support/require.h"
#include "sim/scenario/push_ticks.h"
#include "sim/verdict/footsteps.h"

namespace sidestep {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kLoadedShare = 0.05;  // of the weight: a foot with less on it does not stand.

double MeanOrNaN(const std::vector<double>& values) {
  if (values.empty()) return kNaN;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double LargestOrZero(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

}  // namespace

RunMeters::RunMeters(const MeterSetup& setup)
    : pushes_(setup.pushes),
      tick_s_(setup.gait.tick_s),
      slip_bound_m_(setup.bounds.max_slip_m),
      nominal_(setup.robot, setup.gait),
      fall_(setup.robot, setup.plant, setup.bounds, setup.ground),
      stances_(setup.robot.feet.size(),
               StanceMeter(tick_s_, kLoadedShare * setup.mass_kg * kGravity_mps2)),
      slip_(stances_.size()),
      sole_(setup.robot.feet),
      steps_(setup.robot.feet, tick_s_, setup.ground),
      gait_(setup.gait.segments, {stances_.size(), setup.mass_kg, !setup.joints.empty()}, tick_s_),
      joints_(setup.joints, setup.robot.joints, tick_s_),
      flight_(tick_s_),
      path_(nominal_, setup.gait, setup.control_rate_hz),
      push_(setup.pushes, tick_s_),
      impulse_W_Ns_(setup.pushes.size(), Eigen::Vector3d::Zero()),
      solver_(setup.plan_friction),
      plan_(stances_.size()),
      belief_(setup.pushes, tick_s_) {
  SIDESTEP_REQUIRE(setup.mass_kg > 0.0, setup.mass_kg);
}

void RunMeters::Add(Tick tick, const WorldTruth& truth, const ControlTick* control) {
  SIDESTEP_REQUIRE(!last_tick_ || tick > *last_tick_, tick);
  Integrate(tick, truth);
  const bool had_fallen = fall_.has_fallen();
  fall_.Add(tick, truth);
  if (fall_.has_fallen() && !had_fallen) push_.AddFall(tick);
  if (!fall_.has_fallen()) AddBeforeFall(tick, truth, control);
  push_.AddTilt(tick, fall_.tilt_rad());
  if (path_.Samples(tick)) push_.AddPath(path_.Add(tick, truth));
}

// Adds up what acted from the last tick to this one.
void RunMeters::Integrate(Tick tick, const WorldTruth& truth) {
  if (!last_tick_) {
    first_tick_ = tick;
    first_x_m_ = truth.p_WC.x();
  } else {
    const double dt_s = SecondsAt(tick - *last_tick_, tick_s_);
    for (std::size_t i = 0; i < push_force_W_N_.size(); ++i) {
      impulse_W_Ns_[i] += push_force_W_N_[i] * dt_s;
    }
    energy_J_ += truth.actuator_power_W * dt_s;
  }
  SIDESTEP_REQUIRE(truth.pushes.size() == impulse_W_Ns_.size(), truth.pushes.size());
  push_force_W_N_.clear();
  for (const PushTruth& push : truth.pushes) push_force_W_N_.push_back(push.force_W_N);
  last_tick_ = tick;
  last_x_m_ = truth.p_WC.x();
  max_angular_momentum_kgm2ps_ =
      std::max(max_angular_momentum_kgm2ps_, truth.angular_momentum.norm());
}

void RunMeters::AddBeforeFall(Tick tick, const WorldTruth& truth, const ControlTick* control) {
  last_standing_tick_ = tick;
  if (control) {
    solver_.Add(tick, *control);
    plan_.Add(*control);
    belief_.Add(tick, truth, control->state);
  }
  AddFeet(tick, truth);
  flight_.Add(truth, nominal_.ComAt(tick).p_WC.z());
  joints_.Add(truth);
  max_self_penetration_m_ = std::max(max_self_penetration_m_, truth.self_contact_depth_m);
  if (!slip_tick_ && max_slip_m() > slip_bound_m_) slip_tick_ = tick;
}

void RunMeters::AddFeet(Tick tick, const WorldTruth& truth) {
  SIDESTEP_REQUIRE(truth.feet.size() == slip_.size(), truth.feet.size());
  std::vector<double> stance_slip_m;
  for (std::size_t i = 0; i < slip_.size(); ++i) {
    stances_[i].Add(tick, truth.feet[i]);
    slip_[i].Add(truth.feet[i], stances_[i]);
    stance_slip_m.push_back(slip_[i].stance_slip_m());
  }
  sole_.Add(truth, stances_);
  const std::size_t before = steps_.touch_downs().size();
  steps_.Add(tick, truth, stances_, stance_slip_m, nominal_);
  const auto touch_downs = std::span(steps_.touch_downs()).subspan(before);
  gait_.Add(tick, truth, stances_, touch_downs);
  for (const TouchDown& touch_down : touch_downs) {
    if (touch_down.is_step) push_.AddStep(touch_down.tick, touch_down.adjustment_m);
  }
}

void RunMeters::ReplacePushes(const std::vector<Push>& pushes) {
  pushes_ = pushes;
  push_.ReplacePushes(pushes);
  belief_.ReplacePushes(pushes);
  impulse_W_Ns_.assign(pushes.size(), Eigen::Vector3d::Zero());
  push_force_W_N_.assign(last_tick_ ? pushes.size() : 0, Eigen::Vector3d::Zero());
}

double RunMeters::max_slip_m() const {
  double max_slip_m = 0.0;
  for (const SlipMeter& meter : slip_) max_slip_m = std::max(max_slip_m, meter.max_slip_m());
  return max_slip_m;
}

Tick RunMeters::FirstPushStart() const {
  std::optional<Tick> first;
  for (const Push& push : pushes_) {
    const Tick start = TicksOf(push, tick_s_).first;
    first = std::min(first.value_or(start), start);
  }
  return first.value_or(0);
}

Metrics RunMeters::Measure() const {
  Metrics metrics;
  AddTruthMetrics(metrics);
  AddGaitMetrics(metrics);
  AddControllerMetrics(metrics);
  return metrics;
}

void RunMeters::AddTruthMetrics(Metrics& metrics) const {
  const bool has_fallen = fall_.has_fallen();
  const double duration_s = last_tick_ ? SecondsAt(*last_tick_ - *first_tick_, tick_s_) : 0.0;
  const std::vector<double> adjustments_m = steps_.AdjustmentsFrom(FirstPushStart());
  metrics.insert({
      {"fall", has_fallen},
      {"slip", slip_tick_.has_value()},
      {"recovered", !has_fallen && push_.all_recovered()},
      {"recovery_time_s", push_.worst_recovery_time_s()},
      {"fall_time_s", has_fallen ? SecondsAt(*fall_.fall_tick(), tick_s_) : kNaN},
      {"min_base_height_m", first_tick_ ? fall_.min_height_m() : kNaN},
      {"max_base_height_m", first_tick_ ? fall_.max_height_m() : kNaN},
      {"min_base_height_ratio",
       first_tick_ ? fall_.min_height_m() / fall_.nominal_height_m() : kNaN},
      {"max_base_height_ratio",
       first_tick_ ? fall_.max_height_m() / fall_.nominal_height_m() : kNaN},
      {"max_tilt_rad", fall_.max_tilt_rad()},
      {"max_angular_momentum_kgm2ps", max_angular_momentum_kgm2ps_},
      {"max_slip_m", max_slip_m()},
      {"final_path_error_m", path_.last().error_m},
      {"max_path_error_m", path_.max_error_m()},
      {"final_speed_error_mps", path_.last().speed_error_mps},
      {"drift_m", path_.last().drift_m},
      {"mean_step_adjustment_m", MeanOrNaN(adjustments_m)},
      {"max_step_adjustment_m", LargestOrZero(adjustments_m)},
      {"mean_forward_speed_mps", duration_s > 0.0 ? (last_x_m_ - first_x_m_) / duration_s : kNaN},
      {"apex_height_error_m", flight_.max_apex_error_m()},
      {"min_swing_clearance_m", steps_.min_swing_clearance_m()},
      {"max_sole_tilt_rad", sole_.max_tilt_rad()},
      {"max_self_penetration_m", max_self_penetration_m_},
      {"min_joint_margin_rad", joints_.min_margin_rad()},
      {"max_torque_ratio", joints_.max_torque_ratio()},
      {"max_joint_speed_ratio", joints_.max_speed_ratio()},
      {"torque_saturation_s", joints_.saturation_s()},
      {"energy_J", energy_J_},
  });
}

void RunMeters::AddGaitMetrics(Metrics& metrics) const {
  const GaitFigures figures = gait_.LastMoving();
  metrics.insert({
      {"gait_speed_mps", figures.speed_mps},
      {"step_length_m", figures.step_length_m},
      {"step_frequency_hz", figures.step_frequency_hz},
      {"duty_factor", figures.duty_factor},
      {"walk_flight_fraction", gait_.WalkFlightFraction()},
      {"run_flight_fraction", gait_.RunFlightFraction()},
      {"cost_of_transport", figures.cost_of_transport},
      {"max_ground_force_ratio", figures.max_ground_force_ratio},
  });
}

void RunMeters::AddControllerMetrics(Metrics& metrics) const {
  const std::vector<double> adjustments_m = plan_.AdjustmentsFrom(FirstPushStart());
  metrics.insert({
      {"planned_mean_step_adjustment_m", MeanOrNaN(adjustments_m)},
      {"planned_max_step_adjustment_m", LargestOrZero(adjustments_m)},
      {"mpc_failures", static_cast<double>(solver_.count(Solver::kMpc).failures)},
      {"wbc_failures", static_cast<double>(solver_.count(Solver::kWholeBody).failures)},
      {"step_failures", static_cast<double>(solver_.count(Solver::kStep).failures)},
      {"max_solver_failure_ratio", solver_.max_failure_ratio()},
      {"solver_fallbacks", static_cast<double>(solver_.fallbacks())},
      {"max_cone_violation_N", solver_.max_cone_violation_N()},
      {"max_box_violation_m", plan_.max_box_violation_m()},
      {"rms_com_velocity_error_mps", belief_.com_velocity_mps().rms()},
      {"max_com_velocity_error_mps", belief_.com_velocity_mps().max()},
      {"rms_pushed_com_velocity_error_mps", belief_.pushed_com_velocity_mps().rms()},
      {"max_pushed_com_velocity_error_mps", belief_.pushed_com_velocity_mps().max()},
      {"rms_push_estimate_error_N", belief_.push_N().rms()},
      {"max_push_estimate_error_N", belief_.push_N().max()},
  });
}

std::vector<FootstepRecord> RunMeters::Footsteps() const {
  return MakeFootsteps(nominal_, steps_, plan_, last_standing_tick_);
}

std::vector<PushRecord> RunMeters::Pushes() const {
  std::vector<PushRecord> records;
  for (std::size_t i = 0; i < pushes_.size(); ++i) {
    records.push_back({pushes_[i], impulse_W_Ns_[i], push_.figures(i)});
  }
  return records;
}

}  // namespace sidestep
