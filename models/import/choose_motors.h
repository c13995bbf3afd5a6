// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// choose_motors: limits, servos and armatures where a URDF or an MJCF is silent, from mass and
// height.
//
// A robot that stands on servos tips over unless they are much stiffer than gravity, m g h a radian
// at the ankles. All figures grow with m g h; those of generic_humanoid (480 Nm) are the measure.

#include <string>
#include <vector>

#include "models/import/body_plan.h"
#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// Joints with the same figures: an element of robot.yaml's `joints`.
struct MotorGroup {
  std::string name;  ///< For the comment: legs, torso, arms.
  std::vector<int> joints;
  double stiffness_Nm_per_rad{0.0};
  double damping_Nms_per_rad{0.0};  ///< Of the servo.
  double armature_kgm2{0.0};
  double joint_damping_Nms_per_rad{0.0};  ///< 0: the URDF's.
  double posture_weight{1.0};
};

/// Fills the joints' efforts and velocities where the source has none or impossible ones, and says
/// so in their notes. Armatures that it tells are kept if they bear servos that hold the robot
/// (else they become 0, unknown), and servos damped no more than these bear in a step; servos that
/// it tells are taken if the legs' are stiff enough to carry the robot.
/// @param gravity_Nm   m g h.
/// @param omega_radps  sqrt(g / h): the smaller a robot, the quicker its joints.
std::vector<MotorGroup> ChooseMotors(const BodyPlan& plan, double gravity_Nm, double omega_radps,
                                     SourceRobot* robot, Notes* notes);

}  // namespace sidestep::importer
