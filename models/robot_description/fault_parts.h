// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// fault_parts: the parts of RobotFaults() that have files of their own. Each adds what it finds.

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <string>
#include <vector>

#include "models/robot_description/robot_faults.h"

namespace sidestep {

/// A robot's model at home, with the positions of everything in it.
struct RobotAtHome {
  const RobotDescription& robot;
  const mjModel& model;
  const mjData& data;
};

/// A sole tilted by more is no start that is off, but another axis for its z.
inline constexpr double kUpsideDown_rad = 0.8;

/// A foot that stands with a sole, not on a point or an edge.
inline bool IsFlat(const FootDescription& foot) { return foot.vertices_m.cols() > 2; }

/// `feet.0.frame` and the like.
inline std::string FootKey(std::size_t foot, const std::string& key) {
  return "feet." + std::to_string(foot) + "." + key;
}

/// A length or an angle in words: four digits after the point, no more than it has.
std::string FigureText(double value);

/// Of each foot: shape and sole frame, the vertices within the shape, which way it faces; and that
/// the first foot is the left one.
void AddFootFaults(const RobotAtHome& at_home, std::vector<RobotFault>* faults);

/// Legs that can't hold a sole's six coordinates, and sensors that feel the same force twice.
void AddLegFaults(const RobotAtHome& at_home, std::vector<RobotFault>* faults);
void AddSensorFaults(const RobotAtHome& at_home, std::vector<RobotFault>* faults);

}  // namespace sidestep
