// SPDX-License-Identifier: BSD-3-Clause
#include "controller/dcm/support_area.h"

#include <Eigen/QR>
#include <algorithm>
#include <limits>

#include "models/support/require.h"

namespace sidestep::dcm {
namespace {

constexpr double kOnTheLine_m2 = 1e-12;  // twice the area of a triangle that is none

// Twice the area of a, b, p; positive if p is to the left of a -> b.
double Left(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
  return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
}

Eigen::Vector2d NearestOn(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                          const Eigen::Vector2d& p) {
  const Eigen::Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  if (length2 == 0.0) return a;
  return a + std::clamp((p - a).dot(along) / length2, 0.0, 1.0) * along;
}

}  // namespace

void SupportArea::Add(const Eigen::Vector2d& p_m, double liked_share) {
  SIDESTEP_REQUIRE(size_ < kMost, size_);
  points_[size_++] = {p_m, liked_share, 0.0};
}

// Of the hull, run through anticlockwise: no vertex is to its right.
bool SupportArea::IsEdge(std::size_t from, std::size_t to) const {
  for (std::size_t i = 0; i < size_; ++i) {
    if (Left(points_[from].p_m, points_[to].p_m, points_[i].p_m) < -kOnTheLine_m2) return false;
  }
  return true;
}

Eigen::Vector2d SupportArea::Nearest(const Eigen::Vector2d& p_m) const {
  bool is_inside = true;
  Eigen::Vector2d nearest = points_[0].p_m;
  double least2 = (nearest - p_m).squaredNorm();
  for (std::size_t from = 0; from < size_; ++from) {
    for (std::size_t to = 0; to < size_; ++to) {
      if (from == to || !IsEdge(from, to)) continue;
      const Eigen::Vector2d &a = points_[from].p_m, &b = points_[to].p_m;
      if (Left(a, b, p_m) < 0.0) is_inside = false;
      const Eigen::Vector2d on = NearestOn(a, b, p_m);
      if ((on - p_m).squaredNorm() >= least2) continue;
      least2 = (on - p_m).squaredNorm();
      nearest = on;
    }
  }
  return is_inside && size_ > 2 ? p_m : nearest;
}

// Least squares under three equalities: share = liked + A' (A A')^+ (target - A liked), where A has
// the rows 1, x, y. Of vertices in a line the pseudo-inverse asks nothing across it.
void SupportArea::ShareOut(const Eigen::Vector2d& p_m) {
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  Eigen::Vector3d missing(1.0, 0.0, 0.0);
  for (std::size_t i = 0; i < size_; ++i) {
    const Eigen::Vector3d row(1.0, points_[i].p_m.x() - p_m.x(), points_[i].p_m.y() - p_m.y());
    gram += row * row.transpose();
    missing -= points_[i].liked * row;
  }
  const Eigen::Vector3d force =
      Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d>(gram).solve(missing);
  double sum = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    Point& point = points_[i];
    const Eigen::Vector3d row(1.0, point.p_m.x() - p_m.x(), point.p_m.y() - p_m.y());
    point.share = std::max(0.0, point.liked + row.dot(force));
    sum += point.share;
  }
  for (std::size_t i = 0; i < size_; ++i) points_[i].share /= sum;
}

void AddInnerSole(const FootState& foot, const Eigen::Matrix3Xd& vertices_m, double share,
                  SupportArea* area) {
  const Eigen::Vector3d middle_m = vertices_m.rowwise().mean();
  for (const auto& vertex_m : vertices_m.colwise()) {
    const Eigen::Vector3d inner_m = middle_m + share * (vertex_m - middle_m);
    area->Add((foot.p_WF + foot.R_WF * inner_m).head<2>(), 0.0);
  }
}

}  // namespace sidestep::dcm
