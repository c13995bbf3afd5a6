// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// foot_velocity: the base's twist behind joint velocities, from how one foot is known to move.

#include <Eigen/Core>
#include <Eigen/LU>

#include "controller/model/rigid_body.h"

namespace sidestep::wbc {

struct FootTwist {
  Eigen::Vector3d linear{Eigen::Vector3d::Zero()};   ///< Of F, in W (m/s).
  Eigen::Vector3d angular{Eigen::Vector3d::Zero()};  ///< In W (rad/s).
};

/// nu (nv) with those joint velocities and the base twist that gives `foot` its velocity.
inline Eigen::VectorXd WithBaseTwist(const RigidBody& body, std::size_t foot,
                                     const FootTwist& velocity,
                                     const Eigen::VectorXd& joint_velocity) {
  Eigen::VectorXd nu = Eigen::VectorXd::Zero(body.num_velocities());
  for (Eigen::Index i = 0; i < joint_velocity.size(); ++i) {
    nu[body.actuated_velocity()[static_cast<std::size_t>(i)]] = joint_velocity[i];
  }
  Eigen::MatrixXd J(6, body.num_velocities());
  J << body.foot_jacobian(foot).J, body.foot_jacobian(foot).J_rot;
  Eigen::VectorXd wanted(6);
  wanted << velocity.linear, velocity.angular;
  nu.head<6>() = J.leftCols<6>().partialPivLu().solve(wanted - J * nu);
  return nu;
}

}  // namespace sidestep::wbc
