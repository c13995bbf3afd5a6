// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/whole_body.h"

namespace sidestep::wbc {

WbcReport Passive::Solve(const RobotState& state, const ComTarget& /*com*/,
                         const std::vector<FootTarget>& feet, ActuatorCommand* command) {
  command->torque_Nm.setZero(state.joint_position.size());
  command->centroidal_feet.resize(state.joint_position.size() == 0 ? feet.size() : 0);
  for (std::size_t i = 0; i < command->centroidal_feet.size(); ++i) {
    command->centroidal_feet[i].p_WF = feet[i].p_WF;
    command->centroidal_feet[i].force_N.setZero(3, feet[i].vertex_force_N.cols());
    command->centroidal_feet[i].in_contact = false;
  }
  return {};
}

WbcReport CentroidalForces::Solve(const RobotState& /*state*/, const ComTarget& /*com*/,
                                  const std::vector<FootTarget>& feet, ActuatorCommand* command) {
  command->centroidal_feet.resize(feet.size());
  for (std::size_t i = 0; i < feet.size(); ++i) {
    CentroidalFootCommand& foot = command->centroidal_feet[i];
    foot.p_WF = feet[i].p_WF;
    foot.in_contact = feet[i].planned_contact;
    foot.force_N = feet[i].vertex_force_N;
  }
  return {};
}

}  // namespace sidestep::wbc
