// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// foot_shape: the part of a foot's collision shapes that a level floor would touch.

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace sidestep {

/// Where a foot meets the floor, in the sole's frame F (m).
struct FootShape {
  double lowest_z_m{0.0};             ///< Of the shapes.
  std::vector<Eigen::Vector2d> hull;  ///< Around what is near the lowest; counter-clockwise.
};

/// Of the shapes of the foot that carries the site: its body's and those welded to it, as far as
/// the floor may touch them. Empty if there are none. `data` has the kinematics of some
/// configuration.
std::optional<FootShape> FootShapeOf(const mjModel& model, const mjData& data, int site);

/// How far `point` is from the hull's inside (m); 0 within it and on its border. The hull is not
/// empty.
double DistanceOutside(const std::vector<Eigen::Vector2d>& hull, const Eigen::Vector2d& point);

}  // namespace sidestep
