// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// make_stages: the parts of a controller that a setup chooses between, and the robot as the MPC of
// any controller sees it.

#include <memory>

#include "controller/controller.h"
#include "controller/estimator/state_estimator.h"
#include "controller/model/rigid_body.h"
#include "controller/mpc/problem_builder.h"
#include "controller/wbc/whole_body.h"

namespace sidestep {

/// What the MPC must know of `robot`.
/// @param mass_kg       Its whole mass, > 0. @param gravity_mps2  Of its world, in W.
mpc::RobotModel PlannedRobot(const RobotDescription& robot, double mass_kg,
                             const Eigen::Vector3d& gravity_mps2 = {0.0, 0.0, -kGravity_mps2});

/// The same of a robot with a body, whose legs at home tell their reach. `body` must be at home.
mpc::RobotModel PlannedRobot(const RobotDescription& robot, const RigidBody& body);

/// The estimator that control.estimator names. `body` is the nominal robot.
std::unique_ptr<StateEstimator> MakeEstimator(const ControllerSetup& setup, const RigidBody& body);

/// The whole-body control of control.mode: torque or position. `body` is the nominal robot.
std::unique_ptr<wbc::WholeBody> MakeWholeBody(const ControllerSetup& setup, const RigidBody& body);

}  // namespace sidestep
