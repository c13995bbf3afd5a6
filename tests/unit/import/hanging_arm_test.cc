// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/hanging_arm.h"

#include <sstream>

#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

/// A left arm of four joints on a trunk: a shoulder of three, an upper arm and a forearm that at
/// zero points forwards.
std::string ArmUrdf(double upper_m, double forearm_m) {
  std::ostringstream urdf;
  urdf << "<robot name=\"arm\"><link name=\"trunk\"><inertial><mass value=\"5\"/><inertia "
          "ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n";
  std::string parent = "trunk";
  const auto add = [&](const std::string& name, const std::string& xyz, const std::string& axis,
                       const std::string& com) {
    urdf << "<link name=\"" << name << "\"><inertial><origin xyz=\"" << com
         << "\"/><mass value=\"1\"/><inertia ixx=\"0.01\" iyy=\"0.01\" izz=\"0.01\" ixy=\"0\" "
            "ixz=\"0\" iyz=\"0\"/></inertial></link>\n<joint name=\""
         << name << "_joint\" type=\"revolute\"><parent link=\"" << parent << "\"/><child link=\""
         << name << "\"/><origin xyz=\"" << xyz << "\"/><axis xyz=\"" << axis
         << "\"/><limit lower=\"-2.5\" upper=\"2.5\" effort=\"10\" velocity=\"5\"/></joint>\n";
    parent = name;
  };
  const std::string half = std::to_string(-0.5 * upper_m);
  add("pitch", "0 0.15 0.4", "0 1 0", "0 0 0");
  add("roll", "0 0.05 0", "1 0 0", "0 0 0");
  add("yaw", "0 0 " + half, "0 0 1", "0 0 0");
  add("elbow", "0 0 " + half, "0 1 0", std::to_string(forearm_m) + " 0 0");
  urdf << "</robot>";
  return urdf.str();
}

TEST(HangingArm, UpperArmAndForearmHangWhicheverIsLonger) {
  for (const auto& [upper_m, forearm_m] : {std::pair(0.2, 0.16), std::pair(0.2, 0.3)}) {
    const SourceRobot robot = SourceOf(ArmUrdf(upper_m, forearm_m));
    Limb arm;
    for (const char* name : {"pitch_joint", "roll_joint", "yaw_joint", "elbow_joint"}) {
      arm.joints.push_back(JointCalled(robot, name));
    }
    arm.end = FindLink(robot, "elbow");
    Posture posture = ZeroPosture(robot);
    HangArm(robot, arm, 0.1, &posture);
    const Placement placement(robot, posture);
    const Eigen::Vector3d shoulder = placement.X_WJ(arm.joints[1]).translation();
    const Eigen::Vector3d elbow = placement.X_WJ(arm.joints[3]).translation();
    const Eigen::Vector3d hand = placement.CenterOfMass_W(arm.end);
    EXPECT_LT((elbow - shoulder).normalized().z(), -0.9) << "forearm of " << forearm_m << " m";
    EXPECT_LT((hand - elbow).normalized().z(), -0.7) << "forearm of " << forearm_m << " m";
  }
}

}  // namespace
}  // namespace sidestep::importer
