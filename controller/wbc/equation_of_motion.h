// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// equation_of_motion: M nudot + h = S^T tau + sum J_V^T f_V + e, over x = [nudot; f].
//
// Its rows of the base, where no motor acts, are constraints: six, or three of a base that moves in
// a plane (RigidBody::num_base_velocities()). The rows of the joints tell the torques,
// tau = (M nudot + h - sum J_V^T f_V) there.

#include <Eigen/Core>

#include "controller/model/rigid_body.h"
#include "controller/wbc/contact_forces.h"
#include "controller/wbc/qp_builder.h"

namespace sidestep::wbc {

/// [force (N, in W); torque (N m, in B)]: of its entries the base's freedoms pick theirs.
using BaseForce = Vector6;

/// The generalised force e of an external wrench about C, in W, as if it acted on the base: where
/// it does is not known, and on the base's rows it makes no difference.
BaseForce OnBase(const Wrench& wrench_C, const RobotState& state);

/// The base's rows, exact; `external` is e.
void AddBaseRows(const RigidBody& body, const ContactForces& forces, const BaseForce& external,
                 QpBuilder* qp);

/// |tau| <= limit, a row an actuator.
void AddTorqueLimits(const RigidBody& body, const ContactForces& forces, QpBuilder* qp);

/// Writes the actuators' torques (N m) of a solution x. `scratch` is of size nv.
void WriteTorques(const RigidBody& body, const ContactForces& forces, const QpVector& x,
                  Eigen::VectorXd* scratch, Eigen::VectorXd* torque_Nm);

}  // namespace sidestep::wbc
