// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plane_hull: the area of a convex polygon and the largest rectangle in it.

#include <Eigen/Core>
#include <vector>

namespace sidestep::importer {

/// Of a convex polygon, anticlockwise.
double Area(const std::vector<Eigen::Vector2d>& hull);

struct Rectangle {
  Eigen::Vector2d lower{Eigen::Vector2d::Zero()};
  Eigen::Vector2d upper{Eigen::Vector2d::Zero()};
};

/// The largest rectangle with sides along x and y in a convex polygon, its ends found on a grid of
/// 60 places along x. Of size 0 where the polygon has no area.
Rectangle InscribedRectangle(const std::vector<Eigen::Vector2d>& hull);

}  // namespace sidestep::importer
