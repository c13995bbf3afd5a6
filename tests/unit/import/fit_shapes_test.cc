// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/fit_shapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace sidestep::importer {
namespace {

using Vector = Eigen::Vector3d;

SourceShape Posed(ShapeKind kind, const Vector& size) {
  SourceShape shape;
  shape.kind = kind;
  shape.size_m = size;
  shape.X_LS.translation() << 0.1, -0.2, 0.3;
  shape.X_LS.linear() = Eigen::AngleAxisd(0.7, Vector(1, 1, 0).normalized()).toRotationMatrix();
  return shape;
}

TEST(FitShapes, FitsATurnedBoxToItsCorners) {
  const SourceShape box = Posed(ShapeKind::kBox, {0.1, 0.25, 0.2});
  const SourceShape fit = FitShape(SurfaceOf(box, nullptr));
  EXPECT_EQ(fit.kind, ShapeKind::kBox);
  EXPECT_NEAR(fit.size_m.prod(), box.size_m.prod(), 1e-9);
  EXPECT_LT((fit.X_LS.translation() - box.X_LS.translation()).norm(), 1e-9);
  EXPECT_NEAR(fit.X_LS.linear().determinant(), 1.0, 1e-12);
}

TEST(FitShapes, FitsACapsuleToALongRoundMesh) {
  Mesh mesh;
  for (int i = 0; i < 24; ++i) {
    for (int k = 0; k <= 10; ++k) {
      const double angle = 2 * std::numbers::pi * i / 24;
      const double z = -0.2 + 0.04 * k;
      const double beyond = std::max(0.0, std::abs(z) - 0.15);
      const double r = std::sqrt(std::max(0.0, 0.05 * 0.05 - beyond * beyond));
      mesh.vertices.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
    }
  }
  SourceShape shape;
  shape.kind = ShapeKind::kMesh;
  const SourceShape fit = FitShape(SurfaceOf(shape, &mesh));
  EXPECT_EQ(fit.kind, ShapeKind::kCylinder);
  EXPECT_NEAR(fit.size_m.x(), 0.05, 1e-6);
  EXPECT_NEAR(fit.size_m.y(), 0.4, 1e-6);
  EXPECT_NEAR(std::abs(fit.X_LS.linear()(2, 2)), 1.0, 1e-6);
}

TEST(FitShapes, TheBoxOfAnInertiaHasThatInertia) {
  const double m = 3.0, a = 0.1, b = 0.2, c = 0.3;
  MassProperties mass;
  mass.mass_kg = m;
  mass.com_m << 1, 2, 3;
  mass.inertia_kgm2 = (m / 12.0 * Vector(b * b + c * c, a * a + c * c, a * a + b * b)).asDiagonal();
  const SourceShape box = BoxOfInertia(mass);
  EXPECT_NEAR(box.size_m.prod(), a * b * c, 1e-12);
  EXPECT_EQ(box.X_LS.translation(), mass.com_m);
  const Vector along_x = box.X_LS.linear().transpose() * Vector::UnitX();
  EXPECT_NEAR(std::abs(along_x.dot(box.size_m)), a, 1e-9);
}

TEST(FitShapes, SurfacesAreWhereTheShapesAre) {
  const SourceShape cylinder = Posed(ShapeKind::kCylinder, {0.05, 0.4, 0});
  for (const Vector& p : SurfaceOf(cylinder, nullptr)) {
    const Vector local = cylinder.X_LS.inverse() * p;
    EXPECT_NEAR(local.head<2>().norm(), 0.05, 1e-12);
    EXPECT_NEAR(std::abs(local.z()), 0.2, 1e-12);
  }
  EXPECT_TRUE(SurfaceOf(Posed(ShapeKind::kMesh, {0, 0, 0}), nullptr).empty());
}

}  // namespace
}  // namespace sidestep::importer
