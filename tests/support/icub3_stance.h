// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// icub3_stance: iCub3 at home with targets that keep it there, to begin whole-body tests from.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "controller/types/control_tick.h"
#include "controller/types/inverse_kinematics_params.h"
#include "tests/support/icub3.h"

namespace sidestep::wbc {

inline constexpr double kStanceTick_s = 0.005;

/// No feedback from the belief, no anchor, no compensation: the stack of tasks alone.
inline InverseKinematicsParams BareTasks() {
  InverseKinematicsParams params;
  params.com_feedback_per_s = 0.0;
  params.zmp_feedback_per_s = 0.0;
  params.position_anchor_per_s = 0.0;
  params.attitude_anchor_per_s = 0.0;
  params.compensates_deflection = false;
  return params;
}

struct IcubStance {
  RobotDescription robot{Icub3()};
  RigidBody body{robot};
  RobotState state{IcubAtHome(&body)};
  std::vector<FootTarget> feet{Feet()};
  ComTarget com{state.p_WC, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};

  /// Both feet are meant to stand where they are; no force is planned.
  std::vector<FootTarget> Feet() const {
    std::vector<FootTarget> targets(2);
    for (std::size_t i = 0; i < 2; ++i) {
      targets[i].planned_contact = targets[i].supports = true;
      targets[i].p_WF = state.feet[i].p_WF;
      targets[i].contact.adjusted_p_WF = state.feet[i].p_WF;
      targets[i].vertex_force_N.setZero(3, robot.feet[i].vertices_m.cols());
    }
    return targets;
  }

  /// The foot swings: neither meant to stand nor felt to.
  void Lift(std::size_t foot) {
    feet[foot].planned_contact = feet[foot].supports = false;
    state.feet[foot].in_contact = false;
  }

  /// Every vertex bears the same share of the weight.
  void PlanWeightEvenly() {
    for (FootTarget& foot : feet) {
      foot.vertex_force_N.setZero();
      foot.vertex_force_N.row(2).setConstant(0.5 * 9.81 * body.mass_kg() /
                                             static_cast<double>(foot.vertex_force_N.cols()));
    }
  }
};

/// Puts `body` where its joints have those positions and the sole of `foot` stands flat and
/// straight ahead at p_WF: the base pose that a kinematic reference implies. Derived quantities are
/// filled in.
inline RobotState StandOnFoot(std::size_t foot, const Eigen::Vector3d& p_WF,
                              const Eigen::VectorXd& joint_position, RigidBody* body) {
  RobotState state;
  state.feet.resize(body->num_feet());
  state.joint_position = joint_position;
  state.joint_velocity.setZero(joint_position.size());
  body->Update(state);
  const Eigen::Matrix3d R_BF = body->feet()[foot].R_WF;
  const Eigen::Vector3d p_BF = body->feet()[foot].p_WF;
  state.q_WB = Eigen::Matrix3d(R_BF.transpose());
  state.p_WB = p_WF - R_BF.transpose() * p_BF;
  body->Update(state);
  body->FillDerived(&state);
  return state;
}

/// Tilt of a frame's z axis from the vertical (rad).
inline double Tilt_rad(const Eigen::Matrix3d& R) { return std::acos(std::min(1.0, R(2, 2))); }

}  // namespace sidestep::wbc
