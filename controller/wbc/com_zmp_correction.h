// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// com_zmp_correction: what stands between the MPC and the inverse kinematics: the planned CoM
// velocity, corrected by what the robot is believed to do.
//
//   v_ref = v_C* + k_C (p_C* - p_C) + k_Z (p_Z - p_Z*)
//
// A robot whose joints are held stiffly goes where its CoM is told to; where the ground carries it
// (the ZMP p_Z) then says whether that was wise: a ZMP ahead of the plan's makes the CoM go ahead.
// Source: Choi et al., "Posture/walking control for humanoid robot based on kinematic resolution of
// CoM Jacobian with embedded motion", IEEE Trans. Robotics 23 (2007); Romualdi et al. (ICRA 2022).

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/types/control_tick.h"
#include "controller/types/inverse_kinematics_params.h"
#include "controller/types/robot_state.h"

namespace sidestep::wbc {

/// Point of the ground plane z = 0 about which the feet's wrenches have no horizontal moment (m, in
/// W). Empty when the feet carry less than `min_force_N`.
std::optional<Eigen::Vector2d> ZeroMomentPoint(const std::vector<FootState>& feet,
                                               double min_force_N);

/// The same of the planned vertex forces. `vertices_m` is one 3 x n_v a foot, in F.
std::optional<Eigen::Vector2d> PlannedZeroMomentPoint(
    const std::vector<FootTarget>& feet, const std::vector<Eigen::Matrix3Xd>& vertices_m,
    double min_force_N);

/// CoM velocity for the inverse kinematics (m/s, in W).
Eigen::Vector3d CorrectedComVelocity(const InverseKinematicsParams& params, const RobotState& state,
                                     const ComTarget& com,
                                     const std::optional<Eigen::Vector2d>& planned_zmp,
                                     const std::optional<Eigen::Vector2d>& believed_zmp);

}  // namespace sidestep::wbc
