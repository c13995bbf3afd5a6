// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// support_area: what the soles on the ground can do for a pendulum: where its pressure may be, and
// how they share its force.

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include "controller/types/robot_state.h"

namespace sidestep::dcm {

/// Vertices of the soles that stand, horizontal, in W. A value of fixed size.
class SupportArea {
 public:
  static constexpr std::size_t kMost = 32;

  void Clear() { size_ = 0; }
  /// A vertex, and how much of the force it would like: all together 1. No more than kMost.
  void Add(const Eigen::Vector2d& p_m, double liked_share);

  std::size_t size() const { return size_; }
  bool is_empty() const { return size_ == 0; }

  const Eigen::Vector2d& vertex(std::size_t at) const { return points_[at].p_m; }

  /// The point of the vertices' convex hull that is nearest to `p_m`. Not empty.
  Eigen::Vector2d Nearest(const Eigen::Vector2d& p_m) const;

  /// Shares of the vertical force, of sum 1 and none below 0, as near as may be to those that are
  /// liked, by which the pressure is at `p_m`: exactly so where no share meets 0.
  void ShareOut(const Eigen::Vector2d& p_m);
  double share(std::size_t vertex) const { return points_[vertex].share; }

 private:
  struct Point {
    Eigen::Vector2d p_m{Eigen::Vector2d::Zero()};
    double liked{0.0};
    double share{0.0};
  };

  bool IsEdge(std::size_t from, std::size_t to) const;

  std::array<Point, kMost> points_;
  std::size_t size_{0};
};

/// Adds the vertices (in F) of a sole at `foot`, drawn in to `share` of their distance from its
/// middle; none of them likes a force.
void AddInnerSole(const FootState& foot, const Eigen::Matrix3Xd& vertices_m, double share,
                  SupportArea* area);

}  // namespace sidestep::dcm
