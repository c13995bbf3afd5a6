// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/fit_shapes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sidestep::importer {
namespace {

constexpr double kLeastEdge_m = 0.002;  // thinner shapes slip through others within a step
constexpr double kLeastSize_m = 1e-4;   // less is a point, a line or a sheet
constexpr int kRimPoints = 16;

/// Right-handed principal axes of the points about their mean, the shortest extent first.
Eigen::Matrix3d PrincipalAxes(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) spread += (p - mean) * (p - mean).transpose();
  Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
  if (axes.determinant() < 0.0) axes.col(0) = -axes.col(0);
  return axes;
}

struct Bounds {
  Eigen::Vector3d lower{Eigen::Vector3d::Constant(1e300)};
  Eigen::Vector3d upper{Eigen::Vector3d::Constant(-1e300)};

  Eigen::Vector3d size() const { return upper - lower; }
  Eigen::Vector3d middle() const { return 0.5 * (lower + upper); }
};

Bounds BoundsAlong(const Eigen::Matrix3d& axes, const std::vector<Eigen::Vector3d>& points) {
  Bounds bounds;
  for (const Eigen::Vector3d& p : points) {
    bounds.lower = bounds.lower.cwiseMin(axes.transpose() * p);
    bounds.upper = bounds.upper.cwiseMax(axes.transpose() * p);
  }
  return bounds;
}

double CapsuleVolume(double radius_m, double length_m) {
  const double straight_m = std::max(0.0, length_m - 2.0 * radius_m);
  return std::numbers::pi * radius_m * radius_m * (straight_m + 4.0 / 3.0 * radius_m);
}

}  // namespace

SourceShape FitShape(const std::vector<Eigen::Vector3d>& points) {
  SourceShape shape;
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Bounds bounds = BoundsAlong(axes, points);
  const Eigen::Matrix3d principal = PrincipalAxes(points);
  const Bounds turned = BoundsAlong(principal, points);
  if (turned.size().prod() < 0.8 * bounds.size().prod()) {  // else axes as drawn read better
    axes = principal;
    bounds = turned;
  }
  Eigen::Index longest = 0;
  bounds.size().maxCoeff(&longest);
  const Eigen::Vector3d size = bounds.size().cwiseMax(kLeastEdge_m);
  const double across_m = std::max(size[(longest + 1) % 3], size[(longest + 2) % 3]);
  shape.X_LS.translation() = axes * bounds.middle();
  const double radius_m = 0.5 * across_m;
  if (size[longest] > 2.2 * radius_m && CapsuleVolume(radius_m, size[longest]) < size.prod()) {
    Eigen::Matrix3d R;  // z along the longest axis
    R << axes.col((longest + 1) % 3), axes.col((longest + 2) % 3), axes.col(longest);
    shape.kind = ShapeKind::kCylinder;
    shape.size_m << radius_m, size[longest], 0.0;
    shape.X_LS.linear() = R;
  } else {
    shape.size_m = size;
    shape.X_LS.linear() = axes;
  }
  return shape;
}

SourceShape BoxOfInertia(const MassProperties& mass) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(mass.inertia_kgm2);
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0.0) axes.col(0) = -axes.col(0);
  return BoxOfInertia(mass, axes);
}

SourceShape BoxOfInertia(const MassProperties& mass, const Eigen::Matrix3d& R_LB) {
  const Eigen::Vector3d I = (R_LB.transpose() * mass.inertia_kgm2 * R_LB).diagonal();
  SourceShape shape;
  for (Eigen::Index i = 0; i < 3; ++i) {  // I_i = m (b^2 + c^2) / 12
    const double square = 6.0 * (I.sum() - 2.0 * I[i]) / mass.mass_kg;
    shape.size_m[i] = std::max(kLeastEdge_m, std::sqrt(std::max(0.0, square)));
  }
  shape.X_LS.linear() = R_LB;
  shape.X_LS.translation() = mass.com_m;
  return shape;
}

bool IsEmpty(const SourceShape& shape) {
  switch (shape.kind) {
    case ShapeKind::kMesh:
      return false;
    case ShapeKind::kSphere:
      return shape.size_m.x() < kLeastSize_m;
    case ShapeKind::kCylinder:
      return shape.size_m.head<2>().minCoeff() < kLeastSize_m;
    default:
      return shape.size_m.minCoeff() < kLeastSize_m;
  }
}

std::vector<Eigen::Vector3d> SurfaceOf(const SourceShape& shape, const Mesh* mesh) {
  std::vector<Eigen::Vector3d> points;
  if (shape.kind == ShapeKind::kMesh) {
    if (mesh == nullptr) return points;
    for (const Eigen::Vector3f& vertex : mesh->vertices) {
      points.emplace_back(shape.X_LS * vertex.cast<double>());
    }
  } else if (shape.kind == ShapeKind::kBox) {
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d sign((corner & 1) != 0 ? 0.5 : -0.5, (corner & 2) != 0 ? 0.5 : -0.5,
                                 (corner & 4) != 0 ? 0.5 : -0.5);
      points.emplace_back(shape.X_LS * sign.cwiseProduct(shape.size_m));
    }
  } else if (shape.kind == ShapeKind::kCylinder) {
    for (int i = 0; i < kRimPoints; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kRimPoints;
      for (const double end : {-0.5, 0.5}) {
        points.emplace_back(shape.X_LS * Eigen::Vector3d(shape.size_m.x() * std::cos(angle),
                                                         shape.size_m.x() * std::sin(angle),
                                                         end * shape.size_m.y()));
      }
    }
  } else {
    points.emplace_back(shape.X_LS.translation());
  }
  return points;
}

}  // namespace sidestep::importer
