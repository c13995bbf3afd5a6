// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/equation_of_motion.h"

namespace sidestep::wbc {

BaseForce OnBase(const Wrench& wrench_C, const RobotState& state) {
  const Eigen::Vector3d torque_B_W =
      wrench_C.torque_Nm + (state.p_WC - state.p_WB).cross(wrench_C.force_N);
  BaseForce external;
  external << wrench_C.force_N, state.q_WB.conjugate() * torque_B_W;  // nu has w_WB in B
  return external;
}

void AddBaseRows(const RigidBody& body, const ContactForces& forces, const BaseForce& external,
                 QpBuilder* qp) {
  const Eigen::Index nv = body.num_velocities();
  const Eigen::Index nb = body.num_base_velocities();
  EqualityRows rows = qp->AddEqualities(nb);
  rows.A.leftCols(nv) = body.mass_matrix().topRows(nb);
  rows.A.middleCols(nv, forces.size()) = -forces.jacobian().leftCols(nb).transpose();
  rows.b = -body.bias().head(nb);
  Eigen::Index row = 0;
  for (const int axis : body.base().axes()) rows.b[row++] += external[axis];
}

void AddTorqueLimits(const RigidBody& body, const ContactForces& forces, QpBuilder* qp) {
  const Eigen::Index nv = body.num_velocities();
  InequalityRows rows = qp->AddInequalities(body.num_actuators());
  for (Eigen::Index i = 0; i < body.num_actuators(); ++i) {
    const Eigen::Index row = body.actuated_velocity()[static_cast<std::size_t>(i)];
    const double limit_Nm = body.torque_limit_Nm()[i];
    rows.C.row(i).head(nv) = body.mass_matrix().row(row);
    rows.C.row(i).segment(nv, forces.size()) = -forces.jacobian().col(row).transpose();
    rows.lower[i] = -limit_Nm - body.bias()[row];
    rows.upper[i] = limit_Nm - body.bias()[row];
  }
}

void WriteTorques(const RigidBody& body, const ContactForces& forces, const QpVector& x,
                  Eigen::VectorXd* scratch, Eigen::VectorXd* torque_Nm) {
  const Eigen::Index nv = body.num_velocities();
  Eigen::VectorXd& generalised = *scratch;
  generalised = body.bias();
  generalised.noalias() += body.mass_matrix() * x.head(nv);
  generalised.noalias() -= forces.jacobian().transpose() * x.segment(nv, forces.size());
  for (Eigen::Index i = 0; i < body.num_actuators(); ++i) {
    (*torque_Nm)[i] = generalised[body.actuated_velocity()[static_cast<std::size_t>(i)]];
  }
}

}  // namespace sidestep::wbc
