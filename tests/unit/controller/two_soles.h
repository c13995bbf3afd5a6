// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// two_soles: a robot as the controller's upper rooms know it: mass, height and two soles.

#include "models/robot_description/robot_description.h"

namespace sidestep {

/// Feet "left" and "right", soles of 0.2 m x 0.1 m about their frames.
inline RobotDescription TwoSoles(double mass_kg, double com_height_m) {
  RobotDescription robot;
  robot.mass_kg = mass_kg;
  robot.com_height_m = com_height_m;
  Eigen::Matrix3Xd corners_m(3, 4);
  corners_m << 0.1, 0.1, -0.1, -0.1, 0.05, -0.05, -0.05, 0.05, 0, 0, 0, 0;
  for (const char* name : {"left", "right"}) {
    FootDescription foot;
    foot.name = name;
    foot.vertices_m = corners_m;
    robot.feet.push_back(foot);
  }
  return robot;
}

}  // namespace sidestep
