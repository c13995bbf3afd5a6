// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/control_text.h"

#include <sstream>

#include "models/import/text.h"

namespace sidestep::importer {
namespace {

// How far a foot on a point may go from where the gait has it, over the leg's length.
constexpr double kReach = 0.7;
constexpr double kReachInwards = 0.1;

std::string Sized(const ImportedRobot& it) {
  return ", scaled to " + Figure(it.mass_kg, 3) + " kg and " + Figure(it.start.com_height_m, 3) +
         " m.\ncontrol:\n  mode: " + it.mode;
}

std::string OnSoles(const ImportedRobot& it) {
  const ControlFigures& c = it.control;
  std::ostringstream out;
  out << "\n# Defaults of a scenario's `control`: those of generic_humanoid" << Sized(it) << R"(
  rate_hz: 200
  external_wrench: estimated
  planner: {com_sway: 0.8, follow: capture_point, swing_speed_mps: 1.2, swing_acceleration_mps2: 30}
  mpc:
    rate_hz: 20
    step_s: 0.05
    knots: 30
    friction: 0.33
    box_lower_m: [-0.4, -0.02, 0.0]
    box_upper_m: [0.4, 0.3, 0.0]
    plan_memory_s: 0.2
    external_wrench_hold_s: 0.5
    foot_load_ratio: 1.5
    weights:
      com: [)"
      << Figure(c.com_weight) << ", " << Figure(c.com_weight) << ", " << Figure(c.height_weight)
      << "]\n      angular_momentum: [" << Figure(c.momentum_weight) << ", "
      << Figure(c.momentum_weight) << ", " << Figure(c.momentum_weight) << R"(]
      force_rate: [0.01, 0.01, 0.01]
      leg_length: 1.0e+6
      foot_load: 30
  inverse_kinematics:
    zmp_feedback_per_s: 1.0
    foot_moment_compliance_radps_per_Nm: )"
      << Figure(c.foot_moment_compliance_radps_per_Nm) << R"(
    foot_load_compliance_mps_per_N: )"
      << Figure(c.foot_load_compliance_mps_per_N) << R"(
    swing_attitude_weight: 1.0
  estimation:
    contact_threshold_N: )"
      << Figure(c.contact_threshold_N) << R"(
    push_deadband_N: )"
      << Figure(c.push_deadband_N) << R"(
    accelerometer_noise_mps2: 1.0
    foot_velocity_noise_mps: 0.02
    push_cutoff_hz: 3.0

# What changes where a scenario sets `mode: torque`.
control_torque:
  rate_hz: 500
  planner:
    sway: pendulum
    timing: {error_m: 0.04}
  mpc:
    friction: 0.5
    plan_memory_s: 0
    external_wrench_hold_s: 0
    external_wrench_decay_s: 0.1
)";
  return out.str();
}

std::string OnPoints(const ImportedRobot& it) {
  const ControlFigures& c = it.control;
  const double reach_m = Rounded(kReach * it.start.leg_length_m, 2);
  std::ostringstream out;
  out << "\n# Defaults of a scenario's `control`: those that Bolt walks with on its points"
      << Sized(it) << R"(
  rate_hz: 500
  planner: {follow: capture_point, path_return_m: 0.1}
  mpc:
    rate_hz: 20
    step_s: 0.05
    knots: 20
    friction: 0.5
    box_lower_m: [)"
      << -reach_m << ", " << -Rounded(kReachInwards * it.start.leg_length_m, 2) << R"(, 0.0]
    box_upper_m: [)"
      << reach_m << ", " << reach_m << R"(, 0.0]
    attitude_rate_radps: 5.0
    weights:
      com: [)"
      << Figure(c.com_weight) << ", " << Figure(c.com_weight) << ", " << Figure(c.height_weight)
      << "]\n      angular_momentum: [" << Figure(c.momentum_weight) << ", "
      << Figure(c.momentum_weight) << ", " << Figure(c.momentum_weight) << R"(]
      contact_position: [50, 50, 50]
      force_rate: [0.001, 0.001, 0.001]
  inverse_dynamics: {friction: 0.6}
  estimation:
    contact_threshold_N: )"
      << Figure(c.contact_threshold_N) << "\n";
  return out.str();
}

}  // namespace

std::string ControlText(const ImportedRobot& imported) {
  return imported.plan.stands_on_points() ? OnPoints(imported) : OnSoles(imported);
}

}  // namespace sidestep::importer
