// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/sole_outline.h"

#include <algorithm>

namespace sidestep::plot {
namespace {

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Andrew's monotone chain: the lower half of the hull of points that are sorted by x.
template <typename Iterator>
std::vector<Eigen::Vector2d> LowerChain(Iterator begin, Iterator end) {
  std::vector<Eigen::Vector2d> chain;
  for (Iterator point = begin; point != end; ++point) {
    while (chain.size() > 1 &&
           Cross(chain.back() - chain[chain.size() - 2], *point - chain[chain.size() - 2]) <= 0.0) {
      chain.pop_back();
    }
    chain.push_back(*point);
  }
  return chain;
}

}  // namespace

std::vector<Eigen::Vector2d> ConvexHull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Eigen::Vector2d> hull = LowerChain(points.begin(), points.end());
  const std::vector<Eigen::Vector2d> upper = LowerChain(points.rbegin(), points.rend());
  hull.insert(hull.end(), upper.begin() + 1, upper.end() - 1);
  return hull;
}

}  // namespace sidestep::plot
