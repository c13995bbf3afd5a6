// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/foot_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "models/support/convex_hull.h"
#include "models/support/require.h"

namespace sidestep {
namespace {

using ConstVector3Map = Eigen::Map<const Eigen::Vector3d>;
using ConstMatrix3Map = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

// What is no higher than this above the lowest point counts as sole: edges may be rounded.
constexpr double kSoleBand_m = 0.005;
constexpr int kRimPoints = 24;  // of a circle: its chords leave 1 % of the radius outside

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Points of a geom that may be its lowest, in the geom's own axes G; `down` is a unit vector
/// there. A floor meets the hull of them.
std::vector<Eigen::Vector3d> LowPoints(const mjModel& model, int geom,
                                       const Eigen::Vector3d& down) {
  const ConstVector3Map size(model.geom_size + 3 * geom);
  std::vector<Eigen::Vector3d> points;
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      return {size.x() * down};
    case mjGEOM_CAPSULE:
      for (const double end : {-size.y(), size.y()}) {
        points.emplace_back(end * Eigen::Vector3d::UnitZ() + size.x() * down);
      }
      return points;
    case mjGEOM_ELLIPSOID: {
      const Eigen::Vector3d stretched = size.cwiseProduct(down);
      return {size.cwiseProduct(stretched) / stretched.norm()};
    }
    case mjGEOM_CYLINDER:
      for (int i = 0; i < kRimPoints; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kRimPoints;
        for (const double end : {-size.y(), size.y()}) {
          points.emplace_back(size.x() * std::cos(angle), size.x() * std::sin(angle), end);
        }
      }
      return points;
    case mjGEOM_BOX:
      for (int corner = 0; corner < 8; ++corner) {
        points.emplace_back((corner & 1) != 0 ? size.x() : -size.x(),
                            (corner & 2) != 0 ? size.y() : -size.y(),
                            (corner & 4) != 0 ? size.z() : -size.z());
      }
      return points;
    case mjGEOM_MESH: {
      const int mesh = model.geom_dataid[geom];
      const float* vertex = model.mesh_vert + 3 * model.mesh_vertadr[mesh];
      for (int i = 0; i < model.mesh_vertnum[mesh]; ++i, vertex += 3) {
        points.emplace_back(vertex[0], vertex[1], vertex[2]);
      }
      return points;
    }
    default:
      return points;
  }
}

/// Whether the floor, of contype and conaffinity 1, may touch it.
bool MayTouchFloor(const mjModel& model, int geom) {
  return ((model.geom_contype[geom] | model.geom_conaffinity[geom]) & 1) != 0;
}

double DistanceToSegment(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                         const Eigen::Vector2d& point) {
  const double length2 = (b - a).squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((point - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
  return (point - a - share * (b - a)).norm();
}

}  // namespace

double DistanceOutside(const std::vector<Eigen::Vector2d>& hull, const Eigen::Vector2d& point) {
  SIDESTEP_REQUIRE(!hull.empty(), hull.size());
  bool is_inside = hull.size() > 2;
  double nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d& a = hull[i];
    const Eigen::Vector2d& b = hull[(i + 1) % hull.size()];
    is_inside = is_inside && Cross(b - a, point - a) >= 0.0;
    nearest_m = std::min(nearest_m, DistanceToSegment(a, b, point));
  }
  return is_inside ? 0.0 : nearest_m;
}

std::optional<FootShape> FootShapeOf(const mjModel& model, const mjData& data, int site) {
  const ConstVector3Map p_WF(data.site_xpos + 3 * site);
  const Eigen::Matrix3d R_WF = ConstMatrix3Map(data.site_xmat + 9 * site);
  const int weld = model.body_weldid[model.site_bodyid[site]];
  std::vector<Eigen::Vector3d> points_F;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const bool is_foots = model.body_weldid[model.geom_bodyid[geom]] == weld;
    if (!is_foots || !MayTouchFloor(model, geom)) continue;
    const Eigen::Matrix3d R_WG = ConstMatrix3Map(data.geom_xmat + 9 * geom);
    const ConstVector3Map p_WG(data.geom_xpos + 3 * geom);
    const Eigen::Vector3d down_G = -(R_WG.transpose() * R_WF.col(2));
    for (const Eigen::Vector3d& p_GP : LowPoints(model, geom, down_G)) {
      points_F.push_back(R_WF.transpose() * (p_WG + R_WG * p_GP - p_WF));
    }
  }
  if (points_F.empty()) return std::nullopt;
  FootShape shape;
  shape.lowest_z_m = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& point : points_F) {
    shape.lowest_z_m = std::min(shape.lowest_z_m, point.z());
  }
  std::vector<Eigen::Vector2d> sole;
  for (const Eigen::Vector3d& point : points_F) {
    if (point.z() <= shape.lowest_z_m + kSoleBand_m) sole.emplace_back(point.head<2>());
  }
  shape.hull = ConvexHull(std::move(sole));
  return shape;
}

}  // namespace sidestep
