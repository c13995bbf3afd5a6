// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/weak_legs.h"

#include <cmath>

#include "models/import/text.h"
#include "models/support/gravity.h"

namespace sidestep::importer {
namespace {

/// The torque (N m) at `joint` of a leg that carries the robot alone and at rest: of the ground's
/// force, which is the weight through the CoM, and of what weighs below the joint.
double RestTorque_Nm(const SourceRobot& robot, const Placement& placement, int joint) {
  const int below = robot.joints[static_cast<std::size_t>(joint)].child;
  const Eigen::Vector3d at_m = placement.X_WJ(joint).translation();
  const Eigen::Vector3d arm_kgm =
      TotalMass_kg(robot) * (placement.com_W() - at_m) -
      SubtreeMass_kg(robot, below) * (placement.CenterOfMass_W(below) - at_m);
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  return std::abs(placement.axis_W(joint).dot(arm_kgm.cross(kGravity_mps2 * up)));
}

}  // namespace

std::string TooWeak(const SourceJoint& joint, const std::string& what, double needed_Nm) {
  return "'" + joint.name + "' has " + Figure(joint.effort_Nm, 3) + " Nm, and " + what + " takes " +
         Figure(needed_Nm, 3) + " Nm; if it falls, raise the effort in robot.urdf";
}

Notes WeakLegs(const SourceRobot& robot, const BodyPlan& plan, const Posture& start) {
  const Placement placement(robot, start);
  Notes notes;
  for (const Limb& leg : plan.legs) {
    const std::size_t ankles = plan.stands_on_points() ? 0 : kAnkleJoints;
    for (std::size_t i = 0; i + ankles < leg.joints.size(); ++i) {
      const SourceJoint& joint = robot.joints[static_cast<std::size_t>(leg.joints[i])];
      const double needed_Nm = RestTorque_Nm(robot, placement, leg.joints[i]);
      if (joint.effort_Nm >= needed_Nm) continue;
      notes.push_back(TooWeak(joint, "standing on that leg", needed_Nm));
    }
  }
  return notes;
}

}  // namespace sidestep::importer
