// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// whole_body: the last stage of the chain, from targets of CoM and feet to an ActuatorCommand.

#include <vector>

#include "controller/types/actuator_command.h"
#include "controller/types/control_tick.h"
#include "controller/types/robot_state.h"

namespace sidestep::wbc {

/// One way to carry the targets out.
class WholeBody {
 public:
  virtual ~WholeBody() = default;

  /// Writes the command of this tick. A failed solve is told in the report; the command is then
  /// the previous one. Does not allocate after the first call.
  virtual WbcReport Solve(const RobotState& state, const ComTarget& com,
                          const std::vector<FootTarget>& feet, ActuatorCommand* command) = 0;
};

/// Does nothing: zero torque, whatever is asked.
class Passive final : public WholeBody {
 public:
  WbcReport Solve(const RobotState& state, const ComTarget& com,
                  const std::vector<FootTarget>& feet, ActuatorCommand* command) override;
};

/// Hands the MPC's vertex forces and footholds to the centroidal plant.
class CentroidalForces final : public WholeBody {
 public:
  WbcReport Solve(const RobotState& state, const ComTarget& com,
                  const std::vector<FootTarget>& feet, ActuatorCommand* command) override;
};

}  // namespace sidestep::wbc
