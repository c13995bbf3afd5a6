// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Core>
#include <cmath>
#include <string>

#include "models/robot_description/home_pose.h"
#include "models/support/config_node.h"
#include "sim/scenario/check_parts.h"

namespace sidestep {
namespace {

constexpr double kLengthTolerance_m = 1e-6;
// Of a force, the share across the plane that an angle of five digits may leave, such as 3.1416.
constexpr double kForceTolerance = 1e-5;

/// Whether gaits, planner and MPC have nothing sideways.
void CheckSteps(const Scenario& scenario, const ConfigTree& root) {
  const RobotDescription& robot = scenario.robot;
  const auto require = [&](bool holds, const std::string& path, double value, double wanted) {
    if (holds) return;
    FailAtEither(root, path, "robot",
                 "= " + NumberText(value) + " must be " + NumberText(wanted) + ": '" +
                     scenario.robot_name + "' moves in a plane" +
                     (wanted > 0.0 ? ", its feet so far apart" : ""));
  };
  const bool is_list = root.Find("gait") != nullptr && root.Find("gait")->kind == ConfigKind::kList;
  const double width_m = 2.0 * robot.feet.front().lateral_m;
  for (std::size_t i = 0; i < scenario.gait.size(); ++i) {
    const GaitParams& gait = scenario.gait[i];
    const std::string path = is_list ? "gait." + std::to_string(i) : "gait";
    require(std::abs(gait.step_width_m - width_m) < kLengthTolerance_m, path + ".step_width_m",
            gait.step_width_m, width_m);
    require(gait.step_side_m == 0.0, path + ".step_side_m", gait.step_side_m, 0.0);
  }
  const MpcParams& mpc = scenario.control.mpc;
  const PlannerParams& planner = scenario.control.planner;
  require(mpc.box_lower_m.y() == 0.0, "control.mpc.box_lower_m.1", mpc.box_lower_m.y(), 0.0);
  require(mpc.box_upper_m.y() == 0.0, "control.mpc.box_upper_m.1", mpc.box_upper_m.y(), 0.0);
  if (planner.sway.mode != SwayMode::kShare) {
    FailAtEither(root, "control.planner.sway", "robot",
                 "= pendulum must be share: '" + scenario.robot_name + "' moves in a plane");
  }
  require(planner.sway.share == 0.0, "control.planner.com_sway", planner.sway.share, 0.0);
  require(planner.min_step_width_m == 0.0, "control.planner.min_step_width_m",
          planner.min_step_width_m, 0.0);
}

/// Whether pushes act in the plane: what they do across it, the plane's guide would bear.
void CheckPushPlane(const Scenario& scenario, const ConfigTree& root) {
  if (scenario.pushes.empty()) return;
  const HomePose home(scenario.robot);  // what turns in the plane keeps its axes' y
  for (std::size_t i = 0; i < scenario.pushes.size(); ++i) {
    const Push& push = scenario.pushes[i];
    const bool is_of_body = push.frame == PushFrame::kBody;
    const double lateral_N =
        is_of_body ? (home.X_WO(push.body).linear() * push.force_N).y() : push.force_N.y();
    if (std::abs(lateral_N) <= kForceTolerance * push.force_N.norm()) continue;
    const std::string path = "pushes." + std::to_string(i);
    const bool has_angle = FindPath(root, path + ".direction_rad") != nullptr;
    FailAtPath(root, path + (has_angle ? ".direction_rad" : ".force_N"),
               "pushes sideways, by " + NumberText(lateral_N) + " N, and '" + scenario.robot_name +
                   "' moves in a plane: it would not feel it");
  }
}

}  // namespace

void CheckPlane(const Scenario& scenario, const ConfigTree& root) {
  const bool is_planar =
      scenario.plant == Plant::kMujoco && scenario.robot.base_freedom == BaseFreedom::kSagittal;
  if (!is_planar) return;
  CheckSteps(scenario, root);
  CheckPushPlane(scenario, root);
}

}  // namespace sidestep
