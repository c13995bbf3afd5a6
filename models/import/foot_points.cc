// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/foot_points.h"

#include <memory>

#include "models/import/fit_shapes.h"
#include "models/import/posture.h"

namespace sidestep::importer {
namespace {

constexpr double kUnlevelFrame_rad = 0.002;

}  // namespace

std::vector<SurfacePoint> ShapePoints(const SourceShape& shape, const Eigen::Isometry3d& X_FL,
                                      MeshFiles* meshes) {
  std::vector<SurfacePoint> points;
  const double radius_m = shape.size_m.x();
  const double straight_m = 0.5 * shape.size_m.y() - radius_m;
  if (shape.kind == ShapeKind::kCylinder && straight_m > 0.0) {
    for (const double z : {-straight_m, straight_m}) {
      points.push_back({X_FL * (shape.X_LS * Eigen::Vector3d(0.0, 0.0, z)), radius_m});
    }
    return points;
  }
  const std::shared_ptr<const Mesh> mesh =
      shape.kind == ShapeKind::kMesh ? meshes->Find(shape) : nullptr;
  for (const Eigen::Vector3d& p : SurfaceOf(shape, mesh.get())) {
    points.push_back({X_FL * p, shape.kind == ShapeKind::kSphere ? radius_m : 0.0});
  }
  return points;
}

std::vector<SurfacePoint> FootPoints(const SourceRobot& robot, int foot, Shapes shapes,
                                     MeshFiles* meshes) {
  const Placement zero(robot, ZeroPosture(robot));
  std::vector<SurfacePoint> points;
  for (const int link : Subtree(robot, foot)) {
    const Eigen::Isometry3d X_FL = zero.X_WL(foot).inverse() * zero.X_WL(link);
    for (const SourceShape& shape : robot.links[static_cast<std::size_t>(link)].*shapes) {
      const std::vector<SurfacePoint> more = ShapePoints(shape, X_FL, meshes);
      points.insert(points.end(), more.begin(), more.end());
    }
  }
  return points;
}

int MakersFrameAt(const SourceRobot& robot, int foot, const Eigen::Isometry3d& X_FS,
                  const Eigen::Vector3d& most_off_m, Notes* notes) {
  for (const int joint : robot.joints_below[static_cast<std::size_t>(foot)]) {
    const SourceJoint& below = robot.joints[static_cast<std::size_t>(joint)];
    const SourceLink& link = robot.links[static_cast<std::size_t>(below.child)];
    if (below.is_moving() || link.has_mass() || !link.collisions.empty()) continue;
    const Eigen::Isometry3d X_SL = X_FS.inverse() * below.X_PC;
    const bool is_near = (X_SL.translation().cwiseAbs().array() <= most_off_m.array()).all();
    if (is_near && Eigen::AngleAxisd(X_SL.linear()).angle() <= kUnlevelFrame_rad) {
      notes->push_back("took '" + link.name + "' for the frame of its foot");
      return below.child;
    }
  }
  return -1;
}

}  // namespace sidestep::importer
