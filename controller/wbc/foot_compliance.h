// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// foot_compliance: how standing feet of a robot on stiff servos give way to the ground.
//
// A servo holds a sole's attitude to a milliradian, and so much is a fifth of the moment that the
// sole can bear: where its centre of pressure is, and how two feet share the weight, is then left
// to chance. A foot that turns with the moment and yields to the force that the plan does not
// foresee takes the pressure to where the plan has it:
//
//   w_F = c_m (m_F - p_FZ* x f_F)  about x and y,   v_F.z = c_f (f_F.z - s* sum_i f_i.z)
//
// with the wrench that is felt, the plan's centre of pressure Z* and its share s* of the load.
// Source: damping control of Kajita et al., "Biped walking stabilization based on linear inverted
// pendulum tracking", IROS 2010, sections III-E and III-F.

#include <Eigen/Core>
#include <vector>

#include "controller/types/control_tick.h"
#include "controller/types/inverse_kinematics_params.h"
#include "controller/types/robot_state.h"

namespace sidestep::wbc {

/// How a foot gives way, in W.
struct FootYielding {
  double lift_mps{0.0};                           ///< Along z.
  Eigen::Vector3d w_WF{Eigen::Vector3d::Zero()};  ///< rad/s; none about z.
};

/// Of every foot that stands by the schedule and is felt; of the others none. `vertices_m` is one
/// 3 x n_v a foot, in F. The feet keep their mean height: what one gives way the other takes.
void GiveWay(const InverseKinematicsParams& params, const RobotState& state,
             const std::vector<FootTarget>& feet, const std::vector<Eigen::Matrix3Xd>& vertices_m,
             std::vector<FootYielding>* yielding);

}  // namespace sidestep::wbc
