// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sole_outline: the shape of a foot on the ground.

#include <Eigen/Core>
#include <vector>

namespace sidestep::plot {

/// The convex hull of points, counter-clockwise from the leftmost one: the outline of a sole by its
/// vertices. Two corners for points in a line, one for a single point; points between corners are
/// none.
std::vector<Eigen::Vector2d> ConvexHull(std::vector<Eigen::Vector2d> points);

}  // namespace sidestep::plot
