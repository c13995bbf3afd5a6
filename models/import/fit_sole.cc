// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/fit_sole.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/import/plane_hull.h"
#include "models/support/convex_hull.h"

namespace sidestep::importer {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kTouch_m = 0.003;      // what lies within this of the lowest point touches
constexpr double kWideTouch_m = 0.006;  // the same while the plane is still searched for
constexpr double kMaxTilt = 45.0 * kDegree;
constexpr double kCoarse = 3.0 * kDegree;
constexpr double kFine = 0.5 * kDegree;
constexpr double kFlatShare = 0.35;  // of a foot's outline: the sole lies flat as given

/// Axes of a candidate sole: columns forward, left, up.
Eigen::Matrix3d Tilted(const Eigen::Matrix3d& R_FS, double pitch_rad, double roll_rad) {
  return R_FS * Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()).toRotationMatrix() *
         Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()).toRotationMatrix();
}

double LowestAlong(const std::vector<SurfacePoint>& points, const Eigen::Vector3d& up) {
  double lowest = 1e300;
  for (const SurfacePoint& point : points) {
    lowest = std::min(lowest, up.dot(point.p_m) - point.radius_m);
  }
  return lowest;
}

/// Points within `touch_m` of the lowest, in the plane.
std::vector<Eigen::Vector2d> Touching(const std::vector<SurfacePoint>& points,
                                      const Eigen::Matrix3d& R_FS, double touch_m) {
  const Eigen::Vector3d up = R_FS.col(2);
  const double lowest = LowestAlong(points, up);
  std::vector<Eigen::Vector2d> flat;
  for (const SurfacePoint& point : points) {
    if (up.dot(point.p_m) - point.radius_m > lowest + touch_m) continue;
    flat.emplace_back(R_FS.col(0).dot(point.p_m), R_FS.col(1).dot(point.p_m));
  }
  return flat;
}

double OutlineArea(const std::vector<SurfacePoint>& points, const Eigen::Matrix3d& R_FS) {
  return Area(ConvexHull(Touching(points, R_FS, 1e3)));
}

/// The tilt within `reach` of `R_FS` whose touching points span most.
Eigen::Matrix3d BestTilt(const std::vector<SurfacePoint>& points, const Eigen::Matrix3d& R_FS,
                         double reach, double step, double touch_m) {
  Eigen::Matrix3d best = R_FS;
  double most = Area(ConvexHull(Touching(points, R_FS, touch_m)));
  for (double pitch = -reach; pitch <= reach; pitch += step) {
    for (double roll = -reach; roll <= reach; roll += step) {
      const Eigen::Matrix3d R = Tilted(R_FS, pitch, roll);
      const double area = Area(ConvexHull(Touching(points, R, touch_m)));
      if (area <= most) continue;
      most = area;
      best = R;
    }
  }
  return best;
}

}  // namespace

Sole FitSole(const std::vector<SurfacePoint>& points, const Eigen::Vector3d& forward,
             const Eigen::Vector3d& up) {
  Sole sole;
  if (points.size() < 3) return sole;
  Eigen::Matrix3d R_FS;
  R_FS << forward, up.cross(forward), up;
  const double flat = Area(ConvexHull(Touching(points, R_FS, kTouch_m)));
  if (flat < kFlatShare * OutlineArea(points, R_FS)) {
    R_FS = BestTilt(points, R_FS, kMaxTilt, kCoarse, kWideTouch_m);
    R_FS = BestTilt(points, R_FS, kCoarse, kFine, kTouch_m);
  }
  const Rectangle rectangle = InscribedRectangle(ConvexHull(Touching(points, R_FS, kTouch_m)));
  const Eigen::Vector2d middle = 0.5 * (rectangle.lower + rectangle.upper);
  sole.X_FS.linear() = R_FS;
  sole.X_FS.translation() =
      R_FS * Eigen::Vector3d(middle.x(), middle.y(), LowestAlong(points, R_FS.col(2)));
  sole.length_m = rectangle.upper.x() - rectangle.lower.x();
  sole.width_m = rectangle.upper.y() - rectangle.lower.y();
  sole.tilt_rad = std::acos(std::clamp(R_FS.col(2).dot(up), -1.0, 1.0));
  return sole;
}

}  // namespace sidestep::importer
