// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/check_scenario.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "models/support/config_node.h"
#include "models/support/nearest_name.h"
#include "sim/scenario/check_parts.h"

namespace sidestep {
namespace {

// Decimal periods are not exact in binary; 1e-6 of a step is far above their rounding.
constexpr double kRatioTolerance = 1e-6;
constexpr double kTimeTolerance_s = 1e-9;
// Of a physics step: what is shorter is no push, but a slip of the pen or rounded to nothing.
constexpr double kShortestPush = 1e-3;

bool IsWholeNumberOf(double unit_s, double period_s) {
  const double ratio = period_s / unit_s;
  return std::round(ratio) >= 1.0 && std::abs(ratio - std::round(ratio)) < kRatioTolerance;
}

void CheckRates(const Scenario& scenario, const ConfigTree& root) {
  const double step_s = scenario.world.step_s;
  const double control_hz = scenario.control.rate_hz;
  const double mpc_hz = scenario.control.mpc.rate_hz;
  const double knot_s = scenario.control.mpc.step_s;
  const std::string steps = "physics steps (world.step_s = " + NumberText(step_s) + ")";
  if (!IsWholeNumberOf(step_s, 1.0 / control_hz)) {
    FailAtEither(
        root, "control.rate_hz", "world.step_s",
        "= " + NumberText(control_hz) + " has a period that is no whole number of " + steps);
  }
  if (!IsWholeNumberOf(1.0 / control_hz, 1.0 / mpc_hz)) {
    FailAtEither(root, "control.mpc.rate_hz", "control.rate_hz",
                 "= " + NumberText(mpc_hz) + " has a period that is no whole number of control " +
                     "periods (control.rate_hz = " + NumberText(control_hz) + ")");
  }
  if (!IsWholeNumberOf(step_s, knot_s)) {
    FailAtEither(root, "control.mpc.step_s", "world.step_s",
                 "= " + NumberText(knot_s) + " is no whole number of " + steps);
  }
}

void CheckMpc(const MpcParams& mpc, const ConfigTree& root) {
  for (int axis = 0; axis < 3; ++axis) {
    if (mpc.box_lower_m[axis] <= mpc.box_upper_m[axis]) continue;
    const std::string index = "." + std::to_string(axis);
    FailAtEither(root, "control.mpc.box_lower_m" + index, "control.mpc.box_upper_m" + index,
                 "= " + NumberText(mpc.box_lower_m[axis]) + " is above box_upper_m" + index +
                     " = " + NumberText(mpc.box_upper_m[axis]));
  }
}

void CheckPlant(const Scenario& scenario, const ConfigTree& root) {
  if (scenario.plant == Plant::kMujoco && !scenario.robot.model) {
    FailAtEither(root, "plant", "robot",
                 "= mujoco needs a robot with an MJCF, which '" + scenario.robot_name +
                     "' lacks; write plant: centroidal");
  }
  if (scenario.plant == Plant::kCentroidal && scenario.robot.mass_kg <= 0.0) {
    FailAtEither(root, "plant", "robot",
                 "= centroidal needs a robot whose robot.yaml tells its mass_kg, which '" +
                     scenario.robot_name + "' does not; write plant: mujoco");
  }
}

/// Whether the robot can be moved in the mode that the control block asks for. On the centroidal
/// plant the MPC's forces act: a mode that moves joints means nothing there, and one is only
/// refused that the scenario itself asks for, for `torque` is every scenario's default.
void CheckMode(const Scenario& scenario, const ConfigTree& root) {
  const RobotDescription& robot = scenario.robot;
  const ControlMode mode = scenario.control.mode;
  const bool has_servos = !robot.joints.empty();
  if (scenario.plant == Plant::kCentroidal) {
    if (mode != ControlMode::kPosition) return;
    FailAtEither(root, "control.mode", "plant",
                 "= position means nothing on the centroidal plant, which has no joints; leave it "
                 "out");
  }
  if (mode == ControlMode::kPosition && !has_servos) {
    FailAtEither(root, "control.mode", "robot",
                 "= position needs a robot with servos, which '" + scenario.robot_name +
                     "' lacks; write mode: torque");
  }
  if (mode == ControlMode::kPassive || !robot.model) return;
  for (const UnfitMotor& motor : NamesIn(robot).unfit_motors) {
    if (mode == ControlMode::kPosition && motor.lacks_a_limit) continue;
    FailAtEither(
        root, "control.mode", "robot",
        "= " + std::string(EnumName(mode)) + " needs each joint's <motor> to have gear 1" +
            (mode == ControlMode::kTorque ? " and a ctrlrange of -limit to limit" : "") +
            ", and that of '" + motor.joint + "' of '" + scenario.robot_name + "' " + motor.what +
            (motor.lacks_a_limit ? ""
                                 : "; sidestep robots import FILE.xml -o DIR makes motors of it"));
  }
}

/// Whether the baselines, which know a pendulum on two soles, can do what the scenario asks.
void CheckStepping(const Scenario& scenario, const ConfigTree& root) {
  const ControlParams& control = scenario.control;
  if (control.stepping == Stepping::kMpc || control.mode == ControlMode::kPassive) return;
  const bool can_walk =
      scenario.robot.feet.size() == 2 && scenario.robot.base_freedom == BaseFreedom::kFree;
  const bool walks = std::all_of(scenario.gait.begin(), scenario.gait.end(), [](const auto& gait) {
    return gait.type == GaitType::kStand || gait.type == GaitType::kWalk;
  });
  if (can_walk && walks) return;
  FailAtEither(root, "control.stepping", "robot",
               "= " + std::string(EnumName(control.stepping)) +
                   " needs a robot with two feet that moves freely, and gaits that stand or walk; "
                   "write stepping: mpc");
}

/// Whether the robot can feel what the control block asks of it.
void CheckSenses(const Scenario& scenario, const ConfigTree& root) {
  const RobotDescription& robot = scenario.robot;
  const bool has_body = scenario.plant == Plant::kMujoco;
  const bool estimates = scenario.control.external_wrench == ExternalWrenchKnowledge::kEstimated;
  const bool feels_pushes =
      !robot.arm_force_torque.empty() || scenario.control.estimation.push_cutoff_hz > 0.0;
  if (estimates && (!has_body || !feels_pushes)) {
    FailAtEither(root, "control.external_wrench", "robot",
                 "= estimated needs force/torque sensors in the arms, which " +
                     (has_body ? "'" + scenario.robot_name + "'" : "the centroidal plant") +
                     " lacks; write external_wrench: unknown or known" +
                     (has_body ? ", or estimation.push_cutoff_hz above 0" : ""));
  }
  const bool feels_the_ground =
      std::all_of(robot.feet.begin(), robot.feet.end(),
                  [](const FootDescription& foot) { return !foot.force_torque.empty(); });
  if (scenario.control.estimation.push_cutoff_hz > 0.0 && !feels_the_ground) {
    FailAtEither(root, "control.estimation.push_cutoff_hz", "robot",
                 "> 0 needs force/torque sensors in the feet, which '" + scenario.robot_name +
                     "' lacks; write push_cutoff_hz: 0");
  }
}

void CheckGaits(const Scenario& scenario, const ConfigTree& root) {
  const std::size_t feet = scenario.robot.feet.size();
  const bool is_list = root.Find("gait") != nullptr && root.Find("gait")->kind == ConfigKind::kList;
  for (std::size_t i = 0; i < scenario.gait.size(); ++i) {
    const GaitParams& gait = scenario.gait[i];
    const std::string path = is_list ? "gait." + std::to_string(i) : "gait";
    const bool is_late = i == 0 && gait.start_s != 0.0;
    const bool is_early = i > 0 && gait.start_s <= scenario.gait[i - 1].start_s;
    if (is_late) FailAtPath(root, path + ".start_s", "must be 0 for the first gait");
    if (is_early) {
      FailAtPath(root, path + ".start_s",
                 "= " + NumberText(gait.start_s) + " must be after the gait before it, at " +
                     NumberText(scenario.gait[i - 1].start_s));
    }
    const bool needs_two = gait.type == GaitType::kWalk || gait.type == GaitType::kRun;
    const bool needs_one = gait.type == GaitType::kHop;
    if ((needs_two && feet != 2) || (needs_one && feet != 1)) {
      FailAtPath(root, path + ".type",
                 "= " + std::string(EnumName(gait.type)) + " needs a robot of " +
                     (needs_two ? "2 feet" : "1 foot") + "; '" + scenario.robot_name + "' has " +
                     std::to_string(feet));
    }
    if (feet == 1 && gait.step_width_m != 0.0) {
      FailAtPath(root, path + ".step_width_m",
                 "= " + NumberText(gait.step_width_m) + " must be 0 for a robot of 1 foot");
    }
  }
}

/// Parts that a push may name: the MJCF's, or the reduced model's on the centroidal plant.
std::vector<std::string> PushableParts(const Scenario& scenario) {
  RobotDescription robot = scenario.robot;
  if (scenario.plant == Plant::kCentroidal) robot.model.reset();
  RobotNames names = NamesIn(robot);
  names.bodies.insert(names.bodies.end(), names.frames.begin(), names.frames.end());
  return std::move(names.bodies);
}

void CheckPushes(const Scenario& scenario, const ConfigTree& root) {
  if (scenario.pushes.empty()) return;
  const std::vector<std::string> parts = PushableParts(scenario);
  for (std::size_t i = 0; i < scenario.pushes.size(); ++i) {
    const Push& push = scenario.pushes[i];
    const std::string path = "pushes." + std::to_string(i);
    if (std::find(parts.begin(), parts.end(), push.body) == parts.end()) {
      FailAtPath(root, path + ".body",
                 "= '" + push.body + "' is no body or frame of '" + scenario.robot_name + "'; " +
                     DidYouMean(push.body, parts, "known ones"));
    }
    if (push.duration_s < kShortestPush * scenario.world.step_s) {
      FailAtPath(root, path + ".duration_s",
                 "= " + NumberText(push.duration_s) +
                     " is less than a thousandth of a physics step (world.step_s = " +
                     NumberText(scenario.world.step_s) + ")");
    }
    const double end_s = push.start_s + push.duration_s;
    if (end_s > scenario.duration_s + kTimeTolerance_s) {
      FailAtPath(root, path,
                 "ends at " + NumberText(end_s) +
                     " s, after the scenario's duration_s = " + NumberText(scenario.duration_s));
    }
  }
}

}  // namespace

void FailAtEither(const ConfigTree& root, const std::string& path, const std::string& other,
                  const std::string& what) {
  const ConfigTree* culprit = FindPath(root, path);
  if (culprit == nullptr) culprit = FindPath(root, other);
  if (culprit == nullptr) FailAtPath(root, path, what);
  FailAt(culprit->place, path + " " + what);
}

void CheckMotion(const Scenario& scenario, const ConfigTree& root) {
  CheckPlant(scenario, root);
  CheckMode(scenario, root);
  CheckServos(scenario, root);
  CheckStepping(scenario, root);
  CheckSenses(scenario, root);
  CheckRates(scenario, root);
  CheckMpc(scenario.control.mpc, root);
  CheckGaits(scenario, root);
}

void CheckSurroundings(const Scenario& scenario, const ConfigTree& root) {
  CheckGround(scenario, root);
  CheckPushes(scenario, root);
  CheckPlane(scenario, root);
}

void CheckScenario(const Scenario& scenario, const ConfigTree& root) {
  CheckMotion(scenario, root);
  CheckSurroundings(scenario, root);
}

}  // namespace sidestep
