// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// momentum_reference: the angular momentum that the MPC should follow. Zero as in the paper, plus
// what levels a leaning base: the centroidal model has no attitude, so a lean is paid back only if
// the reference asks for it.
//
//   h*(t) = I w*,   w* = rate theta exp(-rate t)
//
// the momentum of an attitude error theta (rotation vector) that decays at `rate`, with the whole
// robot's inertia I as if its joints were locked.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace sidestep {

/// h*(0) about C (kg m^2/s, in W), horizontal: about the vertical a base has no upright.
/// @param inertia_B   Locked inertia of the robot (kg m^2, in B).
/// @param rate_radps  MpcParams::attitude_rate_radps; 0 gives zero.
Eigen::Vector3d LevellingMomentum(const Eigen::Quaterniond& q_WB, const Eigen::Matrix3d& inertia_B,
                                  double rate_radps);

/// h*(t): `momentum` after it has decayed at `rate_radps` for `time_s`.
Eigen::Vector3d MomentumReference(const Eigen::Vector3d& momentum, double rate_radps,
                                  double time_s);

}  // namespace sidestep
