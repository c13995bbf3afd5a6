// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mass_properties: mass, CoM and inertia of a body, joined and taken apart (parallel axis).

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

namespace sidestep {

/// Of one rigid body, in some frame fixed to it.
struct MassProperties {
  double mass_kg{0.0};
  Eigen::Vector3d com_m{Eigen::Vector3d::Zero()};
  /// About the CoM, axes of the frame; off-diagonal entries are the tensor's (URDF's signs).
  Eigen::Matrix3d inertia_kgm2{Eigen::Matrix3d::Zero()};
};

/// What remains of `whole` when `part` (in the same frame) is cut off: mass, first moment and
/// second moment subtract. Requires part.mass_kg < whole.mass_kg.
MassProperties Without(const MassProperties& whole, const MassProperties& part);

/// Two bodies welded together, both in the same frame.
MassProperties Together(const MassProperties& one, const MassProperties& other);

/// The same body seen from the frame in which its own frame has the pose `X_PF`.
MassProperties InFrame(const Eigen::Isometry3d& X_PF, const MassProperties& body);

/// Whether a body of positive mass could have this inertia: positive definite, and no principal
/// moment greater than the sum of the other two (but for rounding).
bool IsPhysical(const MassProperties& body);

/// Why no body is like this one, with its mass and principal moments, to follow "link 'x' "; empty
/// if IsPhysical().
std::string WhyNotPhysical(const MassProperties& body);

}  // namespace sidestep
