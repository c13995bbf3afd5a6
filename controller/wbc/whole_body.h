// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// whole_body: the last stage of the chain, from targets of CoM and feet to an ActuatorCommand.

#include <memory>
#include <vector>

#include "controller/model/rigid_body.h"
#include "controller/types/actuator_command.h"
#include "controller/types/control_tick.h"
#include "controller/types/robot_state.h"

namespace sidestep::wbc {

/// One way to carry the targets out on a robot with joints. Holds no pointers: copies go on by
/// themselves.
class WholeBody {
 public:
  virtual ~WholeBody() = default;

  /// Writes the command of this tick. `body` must be at `state`. A failed solve is told in the
  /// report; the command is then the previous one, unless the class tells of another way out.
  /// Does not allocate after the first call.
  /// @param com      What the CoM should do now; the nominal motion before the first plan.
  /// @param feet     One a foot of the robot, in its order.
  /// @param command  The one that was written last, or an empty one; its size is settled by the
  /// first call.
  virtual WbcReport Solve(const RobotState& state, const RigidBody& body, const ComTarget& com,
                          const std::vector<FootTarget>& feet, ActuatorCommand* command) = 0;

  /// A copy that goes on from here bit for bit as this one does.
  virtual std::unique_ptr<WholeBody> Clone() const = 0;

 protected:
  WholeBody() = default;
  WholeBody(const WholeBody&) = default;
  WholeBody& operator=(const WholeBody&) = default;
};

}  // namespace sidestep::wbc
