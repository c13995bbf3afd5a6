// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// equation_of_motion: M nudot + h = S^T tau + sum J_V^T f_V, over x = [nudot; f].
//
// Its six rows of the base, where no motor acts, are constraints; the rows of the joints tell the
// torques, tau = (M nudot + h - sum J_V^T f_V) there.

#include <Eigen/Core>

#include "controller/model/rigid_body.h"
#include "controller/wbc/contact_forces.h"
#include "controller/wbc/qp_builder.h"

namespace sidestep::wbc {

inline constexpr Eigen::Index kBaseRows = 6;  ///< Unactuated: linear, angular.

/// The base's rows, exact.
void AddBaseRows(const RigidBody& body, const ContactForces& forces, QpBuilder* qp);

/// |tau| <= limit, a row an actuator.
void AddTorqueLimits(const RigidBody& body, const ContactForces& forces, QpBuilder* qp);

/// Writes the actuators' torques (N m) of a solution x. `scratch` is of size nv.
void WriteTorques(const RigidBody& body, const ContactForces& forces, const QpVector& x,
                  Eigen::VectorXd* scratch, Eigen::VectorXd* torque_Nm);

}  // namespace sidestep::wbc
