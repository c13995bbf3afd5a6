// SPDX-License-Identifier: BSD-3-Clause
#include "controller/wbc/centroidal_command.h"

namespace sidestep::wbc {

void WriteCentroidalCommand(const std::vector<FootTarget>& feet, ActuatorCommand* command) {
  command->centroidal_feet.resize(feet.size());
  for (std::size_t i = 0; i < feet.size(); ++i) {
    CentroidalFootCommand& foot = command->centroidal_feet[i];
    foot.p_WF = feet[i].p_WF;
    foot.in_contact = feet[i].planned_contact;
    foot.force_N = feet[i].vertex_force_N;
  }
}

}  // namespace sidestep::wbc
