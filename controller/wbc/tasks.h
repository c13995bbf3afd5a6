// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// tasks: what a whole-body controller may ask of the robot, as rows that are linear in its motion.
//
// At velocity level a task asks J nu = v*, at acceleration level J nudot = a* - Jdot nu, with the
// same J. Which of them are exact, which are weighed against each other, and by how much, is a list
// in inverse_kinematics.cc and inverse_dynamics.cc. Posture has no J: it is a diagonal
// (QpBuilder::AddDiagonal).

#include <Eigen/Core>
#include <vector>

#include "controller/model/rigid_body.h"
#include "controller/types/control_tick.h"

namespace sidestep::wbc {

/// Three rows J x = target over the velocities x = nu, or the accelerations x = nudot. J is the
/// rigid body's own: valid until that moves on.
struct Task {
  const Jacobian3& J;      ///< 3 x nv, in W.
  Eigen::Vector3d target;  ///< v*, or a* - Jdot nu.
};

/// The six rows of a foot: where it goes and how it turns.
struct FootTask {
  Task linear, angular;
};

/// J_C nu = v_WC*.
Task ComVelocity(const RigidBody& body, const Eigen::Vector3d& v_WC);

/// J_C nudot = a_WC* - Jdot_C nu.
Task ComAcceleration(const RigidBody& body, const Eigen::Vector3d& a_WC);

/// A nu = h_C_W*, the angular momentum about C (N m s).
Task AngularMomentum(const RigidBody& body, const Eigen::Vector3d& h_C_W);

/// A nudot = hdot_C_W* - Adot nu: the moment about C (N m) that the ground is to exert.
Task AngularMomentumRate(const RigidBody& body, const Eigen::Vector3d& moment_C_W);

/// J_F nu = v_WF*, J_F,rot nu = w_WF*.
FootTask FootVelocity(const RigidBody& body, std::size_t foot, const Eigen::Vector3d& v_WF,
                      const Eigen::Vector3d& w_WF);

/// J_F nudot = a_WF* - Jdot_F nu, for a point foot, whose attitude is free.
Task FootLinearAcceleration(const RigidBody& body, std::size_t foot, const Eigen::Vector3d& a_WF);

/// The same and J_F,rot nudot = wdot_WF* - Jdot_F,rot nu.
FootTask FootAcceleration(const RigidBody& body, std::size_t foot, const Eigen::Vector3d& a_WF,
                          const Eigen::Vector3d& wdot_WF);

/// J_T nu = w_WT*. The robot must have a torso.
Task TrunkVelocity(const RigidBody& body, const Eigen::Vector3d& w_WT);

/// J_T nudot = wdot_WT* - Jdot_T nu. The robot must have a torso.
Task TrunkAcceleration(const RigidBody& body, const Eigen::Vector3d& wdot_WT);

/// Upright, and facing where the contacts of the feet face on average.
Eigen::Matrix3d UprightFacingAs(const std::vector<FootTarget>& feet);

/// Upright, and facing where the feet of `body` face on average.
Eigen::Matrix3d UprightFacingAs(const RigidBody& body);

/// How a point is wanted to move.
struct PointTarget {
  Eigen::Vector3d p, v, a;  ///< In W: m, m/s, m/s^2.
};

/// Feedback to acceleration level: a + k_p (p - p_now) + k_d (v - v_now).
Eigen::Vector3d TrackedAcceleration(const PointTarget& target, const Eigen::Vector3d& p_now,
                                    const Eigen::Vector3d& v_now, double stiffness_per_s2,
                                    double damping_per_s);

}  // namespace sidestep::wbc
