// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// control_tick: everything the controller thought in one tick, for the log.

#include <Eigen/Core>
#include <vector>

#include "controller/types/actuator_command.h"
#include "controller/types/contact_plan.h"
#include "controller/types/robot_state.h"
#include "controller/types/solver_status.h"
#include "controller/types/tick.h"

namespace sidestep {

/// Where a foot is meant to be now, and the contact it stands in or flies to.
struct FootTarget {
  bool planned_contact{false};  ///< The schedule has the foot on the ground now.
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v_WF{Eigen::Vector3d::Zero()};
  Eigen::Vector3d a_WF{Eigen::Vector3d::Zero()};
  Eigen::Vector3d force_N{Eigen::Vector3d::Zero()};  ///< Net force the MPC plans, in W.
  Eigen::Matrix3Xd vertex_force_N;                   ///< 3 x n_v, the same by vertex.
  PlannedContact contact;                            ///< Current contact, or the next one.
};

/// CoM motion that the MPC's solution implies at this instant.
struct ComTarget {
  Eigen::Vector3d p_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d a_WC{Eigen::Vector3d::Zero()};
};

/// How the last MPC solve went. `ran` is true only on the tick of the solve.
struct MpcReport {
  bool ran{false};
  SolveStatus status{SolveStatus::kNotSolved};
  int iterations{0};
  double cost{0.0};
  double constraint_violation{0.0};
  double kkt_error{0.0};
  bool fell_back{false};  ///< The solve failed; the shifted previous solution is in use.
};

/// How the whole-body solve of this tick went.
struct WbcReport {
  QpStatus status{QpStatus::kNotSolved};  ///< kNotSolved where no QP is solved.
  bool ok{true};
  int iterations{0};
};

/// A controller's answer and, for the log, what it thought. Only `tick` and `command` must be set:
/// a state without feet says that it believes nothing, no feet that it plans nothing.
struct ControlTick {
  Tick tick{0};
  RobotState state;
  ComReference reference;  ///< Nominal CoM, shifted with the robot if the planner follows.
  ComTarget com;
  std::vector<FootTarget> feet;
  MpcReport mpc;
  double mpc_age_s{0.0};  ///< Since the measurement behind the solution in use.
  WbcReport wbc;
  ActuatorCommand command;
};

}  // namespace sidestep
