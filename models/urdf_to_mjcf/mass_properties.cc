// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/mass_properties.h"

#include <Eigen/Eigenvalues>
#include <sstream>

#include "models/support/require.h"

namespace sidestep {
namespace {

constexpr double kRounding = 1e-9;  // of the largest principal moment

/// Inertia of a point mass at `arm_m` about the origin.
Eigen::Matrix3d PointInertia(double mass_kg, const Eigen::Vector3d& arm_m) {
  return mass_kg * (arm_m.squaredNorm() * Eigen::Matrix3d::Identity() - arm_m * arm_m.transpose());
}

/// Ascending.
Eigen::Vector3d PrincipalMoments(const MassProperties& body) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(body.inertia_kgm2, Eigen::EigenvaluesOnly)
      .eigenvalues();
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

MassProperties Together(const MassProperties& one, const MassProperties& other) {
  MassProperties both;
  both.mass_kg = one.mass_kg + other.mass_kg;
  both.com_m = (one.mass_kg * one.com_m + other.mass_kg * other.com_m) / both.mass_kg;
  both.inertia_kgm2 = one.inertia_kgm2 + other.inertia_kgm2 +
                      PointInertia(one.mass_kg, one.com_m - both.com_m) +
                      PointInertia(other.mass_kg, other.com_m - both.com_m);
  return both;
}

MassProperties InFrame(const Eigen::Isometry3d& X_PF, const MassProperties& body) {
  const Eigen::Matrix3d R_PF = X_PF.rotation();
  return {body.mass_kg, X_PF * body.com_m, R_PF * body.inertia_kgm2 * R_PF.transpose()};
}

bool IsPhysical(const MassProperties& body) {
  const Eigen::Vector3d moments = PrincipalMoments(body);
  return body.mass_kg > 0.0 && moments(0) > 0.0 &&
         moments(2) <= (moments(0) + moments(1)) * (1.0 + kRounding);
}

std::string WhyNotPhysical(const MassProperties& body) {
  if (IsPhysical(body)) return "";
  const Eigen::Vector3d moments = PrincipalMoments(body);
  std::ostringstream why;
  why << "of " << body.mass_kg << " kg has the principal moments " << moments(0) << ", "
      << moments(1) << " and " << moments(2) << " kg m^2";
  if (body.mass_kg <= 0.0) {
    why << ", and no body has a mass that is not positive";
  } else if (moments(0) <= 0.0) {
    why << "; each must be greater than 0";
  } else {
    why << "; none may be greater than the other two together, and " << moments(2) << " > "
        << moments(0) << " + " << moments(1);
  }
  return why.str();
}

}  // namespace sidestep
