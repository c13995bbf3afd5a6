// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/mass_properties.h"

#include <Eigen/Eigenvalues>

#include "models/support/require.h"

namespace sidestep {
namespace {

constexpr double kRounding = 1e-9;  // of the largest principal moment

/// Inertia of a point mass at `arm_m` about the origin.
Eigen::Matrix3d PointInertia(double mass_kg, const Eigen::Vector3d& arm_m) {
  return mass_kg * (arm_m.squaredNorm() * Eigen::Matrix3d::Identity() - arm_m * arm_m.transpose());
}

}  // namespace

MassProperties Without(const MassProperties& whole, const MassProperties& part) {
  SIDESTEP_REQUIRE(part.mass_kg < whole.mass_kg, part.mass_kg);
  MassProperties rest;
  rest.mass_kg = whole.mass_kg - part.mass_kg;
  rest.com_m = (whole.mass_kg * whole.com_m - part.mass_kg * part.com_m) / rest.mass_kg;
  rest.inertia_kgm2 = whole.inertia_kgm2 - part.inertia_kgm2 -
                      PointInertia(part.mass_kg, part.com_m - whole.com_m) -
                      PointInertia(rest.mass_kg, rest.com_m - whole.com_m);
  return rest;
}

MassProperties InFrame(const Eigen::Isometry3d& X_PF, const MassProperties& body) {
  const Eigen::Matrix3d R_PF = X_PF.rotation();
  return {body.mass_kg, X_PF * body.com_m, R_PF * body.inertia_kgm2 * R_PF.transpose()};
}

bool IsPhysical(const MassProperties& body) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(body.inertia_kgm2,
                                                              Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& moments = solver.eigenvalues();  // ascending
  return body.mass_kg > 0.0 && moments(0) > 0.0 &&
         moments(2) <= (moments(0) + moments(1)) * (1.0 + kRounding);
}

}  // namespace sidestep
