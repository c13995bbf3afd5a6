// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/weak_ankles.h"

#include <cmath>

#include "models/import/posture.h"
#include "models/import/weak_legs.h"
#include "models/support/gravity.h"

namespace sidestep::importer {

Notes WeakAnkles(const SourceRobot& robot, const BodyPlan& plan, const std::array<Foot, 2>& feet) {
  const Placement zero(robot, ZeroPosture(robot));
  const double weight_N = TotalMass_kg(robot) * kGravity_mps2;
  Notes notes;
  for (std::size_t side = 0; side < feet.size(); ++side) {
    const Limb& leg = plan.legs[side];
    const Sole& sole = feet[side].sole;
    const Eigen::Matrix3d R_WS = (zero.X_WL(leg.end) * sole.X_FS).linear();
    for (std::size_t i = leg.joints.size() - kAnkleJoints; i < leg.joints.size(); ++i) {
      const SourceJoint& joint = robot.joints[static_cast<std::size_t>(leg.joints[i])];
      const Eigen::Vector3d axis_S = R_WS.transpose() * zero.axis_W(leg.joints[i]);
      const double needed_Nm =
          weight_N * 0.5 *
          (std::abs(axis_S.y()) * sole.length_m + std::abs(axis_S.x()) * sole.width_m);
      if (joint.effort_Nm >= needed_Nm) continue;
      notes.push_back(TooWeak(joint, "the robot's weight over its sole's edge", needed_Nm));
    }
  }
  return notes;
}

}  // namespace sidestep::importer
