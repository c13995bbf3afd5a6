// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/start_pose.h"

#include <numbers>

#include "models/import/feet.h"
#include "models/import/joint_ranges.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

struct Posed {
  SourceRobot robot;
  BodyPlan plan;
  StartPoseTask task;
  StartPose pose;
};

Posed PoseOf(const std::string& urdf) {
  const TempFolder folder;
  const std::filesystem::path file = folder.Write("robot.urdf", urdf);
  Notes notes;
  Posed posed;
  posed.robot = ReadSource(file, &notes);
  posed.plan = FindBodyPlan(posed.robot, "robot.urdf", &notes);
  MeshFiles meshes(file, {});
  const std::array<Foot, 2> feet =
      MakeFeet(posed.plan, "robot.urdf", &meshes, &posed.robot, &notes);
  posed.task.sole_frames = {feet[0].frame, feet[1].frame};
  posed.task.least_width_m = 0.12;
  posed.pose = FindStartPose(posed.robot, posed.plan, posed.task);
  return posed;
}

void ExpectStanding(const Posed& posed) {
  ASSERT_TRUE(posed.pose.is_found) << posed.pose.residual;
  const Placement placement(posed.robot, posed.pose.posture);
  const double half_m = 0.5 * posed.pose.step_width_m;
  for (std::size_t side = 0; side < 2; ++side) {
    const Eigen::Isometry3d& X_WS = placement.X_WL(posed.task.sole_frames[side]);
    EXPECT_LT((X_WS.translation() - Eigen::Vector3d(0, side == 0 ? half_m : -half_m, 0)).norm(),
              1e-6);
    EXPECT_LT((X_WS.linear() - Eigen::Matrix3d::Identity()).norm(), 1e-6);
  }
  EXPECT_LT(placement.com_W().head<2>().norm(), 1e-6);
  for (const int index : posed.plan.Actuated()) {
    const SourceJoint& joint = posed.robot.joints[static_cast<std::size_t>(index)];
    EXPECT_GE(posed.pose.posture.q[index], joint.lower) << joint.name;
    EXPECT_LE(posed.pose.posture.q[index], joint.upper) << joint.name;
  }
}

TEST(StartPose, StandsOnFlatSolesUnderTheCom) {
  const Posed posed = PoseOf(UrdfOf(MakerRobot()));
  ExpectStanding(posed);
  EXPECT_GT(posed.pose.posture.q[JointCalled(posed.robot, "left_knee")], 0.4);
  EXPECT_NEAR(posed.pose.leg_length_m, 0.7, 0.001);
}

TEST(StartPose, HoldsForARootAboveTheWaistAndAnotherHip) {
  MakerRobot maker;
  maker.is_rooted_in_trunk = true;
  maker.bends_hips_first = true;
  maker.size = 0.6;
  ExpectStanding(PoseOf(UrdfOf(maker)));
}

TEST(StartPose, BendsAKneeTheWayItsRangeAllows) {
  std::string urdf = UrdfOf(MakerRobot());
  for (const char* side : {"left_", "right_"}) {  // the same knee about the other axis
    const std::size_t at = urdf.find("\"" + std::string(side) + "knee\"");
    urdf.replace(urdf.find("xyz=\"0 1 0\"", at), 11, "xyz=\"0 -1 0\"");
    urdf.replace(urdf.find("lower=\"-0.02\" upper=\"2.3\"", at), 25,
                 "lower=\"-2.3\" upper=\"0.02\"");
  }
  const Posed posed = PoseOf(urdf);
  ExpectStanding(posed);
  EXPECT_LT(posed.pose.posture.q[JointCalled(posed.robot, "left_knee")], -0.4);
}

TEST(StartPose, ArmsHangBesideTheBody) {
  const Posed posed = PoseOf(UrdfOf(MakerRobot()));
  const Placement placement(posed.robot, posed.pose.posture);
  const Eigen::Vector3d shoulder =
      placement.X_WL(FindLink(posed.robot, "left_shoulder_roll_link")).translation();
  const Eigen::Vector3d forearm = placement.CenterOfMass_W(FindLink(posed.robot, "left_forearm"));
  EXPECT_LT(forearm.z(), shoulder.z() - 0.3);
  EXPECT_GT(forearm.y(), shoulder.y());
  EXPECT_LT(forearm.y(), shoulder.y() + 0.12);
}

TEST(StartPose, SaysSoIfThereIsNone) {
  std::string urdf = UrdfOf(MakerRobot());
  for (const char* side : {"left_", "right_"}) {  // ankles that can't follow a bent knee
    const std::size_t at = urdf.find("\"" + std::string(side) + "ankle_pitch\"");
    urdf.replace(urdf.find("lower=\"-1\" upper=\"0.8\"", at), 22, "lower=\"0.3\" upper=\"0.8\"");
  }
  const Posed posed = PoseOf(urdf);
  EXPECT_FALSE(posed.pose.is_found);
  EXPECT_GT(posed.pose.residual, 1e-3);
}

}  // namespace
}  // namespace sidestep::importer
