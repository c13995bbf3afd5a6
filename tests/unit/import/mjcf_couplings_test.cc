// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_couplings.h"

#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

constexpr char kTail[] =
    "<body name=\"tail\"><geom size=\"0.1\"/><joint name=\"wag\"/><body name=\"tip\"><geom "
    "size=\"0.1\"/><joint name=\"flick\"/></body></body>\n";

TEST(MjcfCouplings, AJointTiedToAnotherIsAMimic) {
  const SourceRobot robot = SourceOfMjcf(SmallMjcf(
      kTail, "<equality><joint joint1=\"flick\" joint2=\"wag\" polycoef=\"0 1\"/></equality>"));
  EXPECT_TRUE(robot.joints[static_cast<std::size_t>(JointCalled(robot, "flick"))].is_mimic);
  EXPECT_FALSE(robot.joints[static_cast<std::size_t>(JointCalled(robot, "wag"))].is_mimic);
}

TEST(MjcfCouplings, ALoopIsRefusedWhereItsJointsMoveOnly) {
  const SourceRobot robot = SourceOfMjcf(
      SmallMjcf(kTail,
                "<equality>\n<connect name=\"rod\" body1=\"tip\" body2=\"leg\" anchor=\"0 0 0\"/>\n"
                "<weld body1=\"tip\" body2=\"tail\" active=\"false\"/></equality>"));
  ASSERT_EQ(robot.couplings.size(), 1U);
  EXPECT_EQ(robot.couplings[0].joints.size(), 3U) << "wag, flick and hip lie between";
  const int hip = JointCalled(robot, "hip");
  const TempFolder folder;
  const std::string error = folder.ErrorOf([&] { RefuseCouplings(robot.couplings, {hip}); });
  EXPECT_NE(error.find(":9:1: error: <connect> 'rod' closes a loop from 'tip' to 'leg', and joints "
                       "that move here are of it"),
            std::string::npos)
      << error;
  EXPECT_EQ(folder.ErrorOf([&] { RefuseCouplings(robot.couplings, {}); }), "no error");
}

TEST(MjcfCouplings, TendonsThatPullAreCouplingsAndThoseThatLimitAreLeftOut) {
  const std::string joints = "<joint joint=\"wag\" coef=\"1\"/><joint joint=\"flick\" coef=\"1\"/>";
  Notes notes;
  const SourceRobot robot = SourceOfMjcf(
      SmallMjcf(kTail, "<tendon><fixed name=\"spring\" stiffness=\"9\">" + joints +
                           "</fixed>\n<fixed name=\"stop\" range=\"0 1\">" + joints +
                           "</fixed>\n<fixed name=\"cable\">" + joints +
                           "</fixed></tendon><actuator><motor tendon=\"cable\"/></actuator>"),
      &notes);
  ASSERT_EQ(robot.couplings.size(), 2U);
  EXPECT_EQ(robot.couplings[1].what, "<fixed> 'cable' is a tendon that pulls");
  EXPECT_EQ(robot.couplings[1].joints.size(), 2U);
  EXPECT_TRUE(HasNote(notes, "left out tendon 'stop' and the limit that it sets"));
}

TEST(MjcfCouplings, WhatHoldsTheRobotInTheWorldIsLeftOut) {
  Notes notes;
  const SourceRobot robot = SourceOfMjcf(
      SmallMjcf(kTail, "<equality><weld name=\"w\" body1=\"pelvis\"/></equality>"), &notes);
  EXPECT_TRUE(robot.couplings.empty());
  EXPECT_TRUE(HasNote(notes, "left out <weld> 'w', which holds 'pelvis' in the world"));
  EXPECT_EQ(
      MjcfErrorOf(SmallMjcf(kTail, "<equality><connect site1=\"a\" site2=\"b\"/></equality>")),
      "robot.xml:8:11: error: <connect> '' can't be simulated here; delete it");
}

}  // namespace
}  // namespace sidestep::importer
