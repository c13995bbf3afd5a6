// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "models/robot_description/robot_figures.h"
#include "models/support/config_node.h"
#include "sim/scenario/check_parts.h"

namespace sidestep {
namespace {

std::string Short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

bool HasServos(const Scenario& scenario) {
  return scenario.plant == Plant::kMujoco && scenario.control.mode == ControlMode::kPosition;
}

std::string WhyUnstable(const ServoFigures& servo, double step_s) {
  const std::string inertia = Short(servo.inertia_kgm2) + " kg m^2";
  if (servo.damping_share(step_s) >= 1.0) {
    return "servo damping x step = " + Short(servo.damping_Nms_per_rad * step_s) +
           " must stay below the armature, " + Short(servo.armature_kgm2) +
           " kg m^2 (with the links that the joint moves " + inertia + ")";
  }
  return "2 x servo damping x step + stiffness x step^2 = " +
         Short(2.0 * servo.damping_Nms_per_rad * step_s +
               servo.stiffness_Nm_per_rad * step_s * step_s) +
         " must stay below four times the inertia that the joint moves, " + inertia;
}

}  // namespace

void CheckServos(const Scenario& scenario, const ConfigTree& root) {
  if (!HasServos(scenario)) return;
  const double step_s = scenario.world.step_s;
  std::vector<ServoFigures> servos = FiguresOf(scenario.robot).servos;
  std::erase_if(servos, [&](const ServoFigures& servo) { return servo.is_stable(step_s); });
  if (servos.empty()) return;
  const ServoFigures& worst =
      *std::max_element(servos.begin(), servos.end(), [&](const auto& left, const auto& right) {
        return left.damping_share(step_s) < right.damping_share(step_s);
      });
  const std::string others =
      servos.size() > 1 ? "; so are " + std::to_string(servos.size() - 1) + " other servos" : "";
  FailAtEither(root, "world.step_s", "robot",
               "= " + NumberText(step_s) + " is too long for '" + worst.joint + "' of '" +
                   scenario.robot_name + "', which is unstable: " + WhyUnstable(worst, step_s) +
                   others);
}

void WarnOfServos(const Scenario& scenario, const NoteSink& note) {
  if (!note || !HasServos(scenario)) return;
  const std::vector<std::string> warnings = ServoWarnings(scenario.robot);
  if (warnings.empty()) return;
  const ConfigTree robot = ReadConfigFile(scenario.robot.file);
  const ConfigTree* joints = FindPath(robot, "joints");
  for (const std::string& warning : warnings) {
    note(MessageAt(joints != nullptr ? joints->place : robot.place, "warning", warning));
  }
}

}  // namespace sidestep
