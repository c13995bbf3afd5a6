// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/plane_hull.h"

#include <algorithm>
#include <array>

namespace sidestep::importer {
namespace {

constexpr int kPlaces = 60;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Least and greatest y of the polygon at x.
std::array<double, 2> Across(const std::vector<Eigen::Vector2d>& hull, double x) {
  std::array<double, 2> y{1e300, -1e300};
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d& a = hull[i];
    const Eigen::Vector2d& b = hull[(i + 1) % hull.size()];
    if (x < std::min(a.x(), b.x()) || x > std::max(a.x(), b.x())) continue;
    const double run = b.x() - a.x();
    for (const double at : {run == 0.0 ? a.y() : a.y() + (x - a.x()) / run * (b.y() - a.y()),
                            run == 0.0 ? b.y() : a.y() + (x - a.x()) / run * (b.y() - a.y())}) {
      y = {std::min(y[0], at), std::max(y[1], at)};
    }
  }
  return y;
}

}  // namespace

double Area(const std::vector<Eigen::Vector2d>& hull) {
  double twice = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i)
    twice += Cross(hull[i], hull[(i + 1) % hull.size()]);
  return 0.5 * twice;
}

Rectangle InscribedRectangle(const std::vector<Eigen::Vector2d>& hull) {
  Rectangle best;
  if (hull.size() < 3) return best;
  double least = 1e300, greatest = -1e300;
  for (const Eigen::Vector2d& corner : hull) {
    least = std::min(least, corner.x());
    greatest = std::max(greatest, corner.x());
  }
  std::vector<double> x(kPlaces + 1);
  std::vector<std::array<double, 2>> y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = i == kPlaces ? greatest : least + (greatest - least) * static_cast<double>(i) / kPlaces;
    y[i] = Across(hull, x[i]);
  }
  double most = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t k = i + 1; k < x.size(); ++k) {  // convex: the ends are the narrowest
      const double lower = std::max(y[i][0], y[k][0]), upper = std::min(y[i][1], y[k][1]);
      const double area = (x[k] - x[i]) * (upper - lower);
      if (upper <= lower || area <= most) continue;
      most = area;
      best = {{x[i], lower}, {x[k], upper}};
    }
  }
  return best;
}

}  // namespace sidestep::importer
