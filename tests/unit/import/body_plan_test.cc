// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/body_plan.h"

#include <numbers>

#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

std::vector<std::string> Names(const SourceRobot& robot, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const int joint : joints)
    names.push_back(robot.joints[static_cast<std::size_t>(joint)].name);
  return names;
}

BodyPlan PlanOf(const SourceRobot& robot) {
  Notes notes;
  return FindBodyPlan(robot, "robot.urdf", &notes);
}

using Strings = std::vector<std::string>;

TEST(BodyPlan, FindsLegsTorsoAndArmsInTheirOrder) {
  const SourceRobot robot = SourceOf(MakerRobot());
  const BodyPlan plan = PlanOf(robot);
  EXPECT_EQ(Names(robot, plan.legs[0].joints),
            (Strings{"left_hip_yaw", "left_hip_roll", "left_hip_pitch", "left_knee",
                     "left_ankle_pitch", "left_ankle_roll"}));
  EXPECT_EQ(Names(robot, plan.torso_joints), Strings{"waist_yaw"});
  EXPECT_EQ(Names(robot, plan.arms[1].joints),
            (Strings{"right_shoulder_pitch", "right_shoulder_roll", "right_shoulder_yaw",
                     "right_elbow"}));
  EXPECT_EQ(Names(robot, plan.locked), Strings{"neck_pitch"});
  EXPECT_EQ(robot.links[static_cast<std::size_t>(plan.torso)].name, "trunk");
  EXPECT_EQ(plan.Actuated().size(), 21U);
  EXPECT_EQ(plan.facing_rad, 0.0);
}

TEST(BodyPlan, FindsThePelvisBelowARootAboveTheWaist) {
  MakerRobot maker;
  maker.is_rooted_in_trunk = true;
  const SourceRobot robot = SourceOf(maker);
  const BodyPlan plan = PlanOf(robot);
  EXPECT_EQ(robot.links[static_cast<std::size_t>(plan.pelvis)].name, "pelvis");
  EXPECT_EQ(robot.links[static_cast<std::size_t>(plan.torso)].name, "trunk");
  EXPECT_EQ(Names(robot, plan.torso_joints), Strings{"waist_yaw"});
}

TEST(BodyPlan, EndsArmsWhereFingersBegin) {
  MakerRobot maker;
  maker.has_fingers = true;
  const SourceRobot robot = SourceOf(maker);
  const BodyPlan plan = PlanOf(robot);
  EXPECT_EQ(Names(robot, plan.arms[0].joints).back(), "left_elbow");
  EXPECT_EQ(plan.locked.size(), 5U);  // a neck, four fingers
}

TEST(BodyPlan, PlaceTellsLeftWhereNamesDoNot) {
  std::string urdf = UrdfOf(MakerRobot());
  const auto rename = [&](const std::string& from, const std::string& to) {
    for (std::size_t at = urdf.find(from); at != std::string::npos; at = urdf.find(from, at)) {
      urdf.replace(at, from.size(), to);
    }
  };
  rename("left_", "x1");
  rename("right_", "x2");
  const SourceRobot robot = SourceOf(urdf);
  EXPECT_EQ(Names(robot, PlanOf(robot).legs[0].joints)[0], "x1hip_yaw");
}

TEST(BodyPlan, FacesBackwardsOnlyIfNamesAndFeetAgree) {
  std::string urdf = UrdfOf(MakerRobot());
  const auto swap = [&](const std::string& a, const std::string& b) {
    for (std::size_t at = 0; at < urdf.size(); ++at) {
      const bool is_a = urdf.compare(at, a.size(), a) == 0;
      const bool is_b = urdf.compare(at, b.size(), b) == 0;
      if (is_a || is_b) urdf.replace(at, is_a ? a.size() : b.size(), is_a ? b : a);
      if (is_a || is_b) at += b.size() - 1;
    }
  };
  swap("left_", "right_");  // toes still at x > 0: the names are wrong
  const SourceRobot robot = SourceOf(urdf);
  const BodyPlan plan = PlanOf(robot);
  EXPECT_EQ(plan.facing_rad, 0.0);
  EXPECT_EQ(Names(robot, plan.legs[0].joints)[0], "right_hip_yaw");
}

TEST(BodyPlan, RefusesFiveJointsWithTheReason) {
  MakerRobot maker;
  maker.leg_joints = 5;
  const TempFolder folder;
  EXPECT_EQ(folder.ErrorOf([&] { PlanOf(SourceOf(maker)); }),
            "robot.urdf: error: the leg that ends in 'left_foot' has 5 joints (left_hip_yaw, "
            "left_hip_roll, left_hip_pitch, left_knee, left_ankle_pitch): a sole that is to stay "
            "flat wherever the pelvis goes needs six, a foot that is a point needs three");
}

TEST(BodyPlan, TellsWhichJointOfALegFollowsAnother) {
  const std::string what =
      ": right_hip_yaw can't follow another joint here and was fixed; take its <mimic> or "
      "<equality> out, and it moves by itself";
  SourceRobot robot = SourceOf(MakerRobot());
  const auto fix = [&](const std::string& name) {
    SourceJoint& joint = robot.joints[static_cast<std::size_t>(JointCalled(robot, name))];
    joint.is_mimic = true;
    joint.kind = JointKind::kFixed;
  };
  fix("right_hip_yaw");
  const TempFolder folder;
  EXPECT_EQ(folder.ErrorOf([&] { PlanOf(robot); }),
            "robot.urdf: error: has no two legs with as many joints" + what);
  fix("left_hip_yaw");
  EXPECT_NE(folder.ErrorOf([&] { PlanOf(robot); }).find("needs three: left_hip_yaw"),
            std::string::npos);
}

TEST(BodyPlan, RefusesArmsAsLegs) {
  const std::string urdf = UrdfOf(MakerRobot());
  std::string armed = urdf;  // its legs welded: only arms are left
  for (const char* joint :
       {"hip_yaw", "hip_roll", "hip_pitch", "knee", "ankle_pitch", "ankle_roll"}) {
    for (const std::string side : {"left_", "right_"}) {
      const std::size_t at = armed.find("\"" + side + joint + "\" type=\"revolute\"");
      ASSERT_NE(at, std::string::npos);
      armed.replace(armed.find("revolute", at), 8, "fixed");
    }
  }
  const TempFolder folder;
  EXPECT_NE(folder.ErrorOf([&] { PlanOf(SourceOf(armed)); }).find("end two arms, as their joints'"),
            std::string::npos);
  for (const auto& [from, to] : {std::pair("shoulder", "first"), std::pair("elbow", "second"),
                                 std::pair("arm", "third"), std::pair("hand", "fourth")}) {
    const std::string word(from);
    for (std::size_t at = 0; (at = armed.find(word)) != std::string::npos;) {
      armed.replace(at, word.size(), to);
    }
  }
  EXPECT_NE(folder.ErrorOf([&] { PlanOf(SourceOf(armed)); }).find("has no two legs that stand"),
            std::string::npos)
      << "names that say nothing: their place does";
}

}  // namespace
}  // namespace sidestep::importer
