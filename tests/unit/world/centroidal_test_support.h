// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// centroidal_test_support: a small body on two feet of four vertices each.

#include "sim/scenario/scenario.h"

namespace sidestep {

inline Scenario TwoFeetScenario() {
  Scenario scenario;
  scenario.plant = Plant::kCentroidal;
  scenario.duration_s = 1.0;
  scenario.world.friction = 0.5;
  scenario.world.step_s = 0.001;
  RobotDescription& robot = scenario.robot;
  robot.name = "two_feet";
  robot.file = "two_feet.yaml";
  robot.mass_kg = 2.0;
  robot.com_height_m = 0.5;
  Eigen::Matrix3Xd vertices_m(3, 4);
  vertices_m << 0.1, 0.1, -0.1, -0.1, 0.05, -0.05, -0.05, 0.05, 0.0, 0.0, 0.0, 0.0;
  robot.feet = {{"left", "left_sole", {}, vertices_m, 0.0},
                {"right", "right_sole", {}, vertices_m, 0.0}};
  GaitParams gait;
  gait.step_width_m = 0.2;
  scenario.gait = {gait};
  return scenario;
}

}  // namespace sidestep
