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
/// Written by the swing stage (motion, contact) and by the MPC's plan (forces); read by the
/// whole-body stage, the log and the plan's metrics. Motion is in W; a standing foot has zero
/// velocity and acceleration.
struct FootTarget {
  bool planned_contact{false};  ///< The schedule has the foot on the ground now.
  bool supports{false};         ///< It does, and the foot has landed: forces may be asked of it.
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v_WF{Eigen::Vector3d::Zero()};     ///< m/s, feed-forward.
  Eigen::Vector3d a_WF{Eigen::Vector3d::Zero()};     ///< m/s^2, feed-forward.
  Eigen::Vector3d force_N{Eigen::Vector3d::Zero()};  ///< Net force the MPC plans, in W.
  Eigen::Matrix3Xd vertex_force_N;                   ///< 3 x n_v, the same by vertex.
  PlannedContact contact;                            ///< Current contact, or the next one.
};

/// CoM motion and angular momentum that the MPC's solution implies at this instant.
/// Acceleration and momentum's rate are constant within a knot of the plan, and position, velocity
/// and momentum are integrated from the belief at the solve: the belief of now does not enter. The
/// nominal motion before the first plan.
struct ComTarget {
  Eigen::Vector3d p_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v_WC{Eigen::Vector3d::Zero()};  ///< m/s.
  Eigen::Vector3d a_WC{Eigen::Vector3d::Zero()};  ///< m/s^2, gravity and external wrench included.
  Eigen::Vector3d angular_momentum{Eigen::Vector3d::Zero()};          ///< h_C_W, kg m^2/s.
  Eigen::Vector3d angular_momentum_rate_Nm{Eigen::Vector3d::Zero()};  ///< External torque included.
};

/// How the last MPC solve went. `ran` is true only on the tick of the solve.
/// The other fields stay as the last solve left them.
struct MpcReport {
  bool ran{false};  ///< On this very tick.
  SolveStatus status{SolveStatus::kNotSolved};
  int iterations{0};  ///< Of the back end's own kind.
  double cost{0.0};   ///< J of the solution, mass-normalised.
  double constraint_violation{0.0};
  double kkt_error{0.0};
  bool fell_back{false};  ///< The solve failed; the shifted previous solution is in use.
};

/// How the whole-body solve of this tick went.
struct WbcReport {
  QpStatus status{QpStatus::kNotSolved};  ///< kNotSolved where no QP is solved.
  bool ok{true};                          ///< False: a fallback acts; see WholeBody::Solve.
  int iterations{0};
};

/// How a baseline's QP for the next step went.
struct StepReport {
  QpStatus status{QpStatus::kNotSolved};  ///< kNotSolved where none was solved on this very tick.
};

/// A controller's answer and, for the log, what it thought. Only `tick` and `command` must be set:
/// a state without feet says that it believes nothing, no feet that it plans nothing. Of all this
/// only `command` reaches the world, and no metric of MetricGroup::kTruth reads the rest. Written
/// in place each tick: sizes stay what they are after the first one.
struct ControlTick {
  Tick tick{0};                  ///< Of the frame that it answers.
  RobotState state;              ///< What it believed.
  ComReference reference;        ///< Nominal CoM, shifted with the robot if the planner follows.
  ComTarget com;                 ///< What the plan makes of that reference.
  std::vector<FootTarget> feet;  ///< In the order of RobotDescription::feet.
  MpcReport mpc;
  double mpc_age_s{0.0};  ///< Since the measurement behind the solution in use.
  StepReport step;
  WbcReport wbc;
  ActuatorCommand command;  ///< Acts until the next one.
};

}  // namespace sidestep
