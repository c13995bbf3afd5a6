// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// convex_hull: the outline of points in a plane.

#include <Eigen/Core>
#include <vector>

namespace sidestep {

/// Corners of the convex hull of points, counter-clockwise from the leftmost one, none on a side;
/// fewer than three where all lie on a line or are one.
std::vector<Eigen::Vector2d> ConvexHull(std::vector<Eigen::Vector2d> points);

}  // namespace sidestep
