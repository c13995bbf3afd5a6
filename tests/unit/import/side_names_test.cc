// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/side_names.h"

#include <gtest/gtest.h>

namespace sidestep::importer {
namespace {

TEST(SideNames, ReadsWordsNotLetters) {
  for (const char* name :
       {"left_knee", "l_hip", "LHipYaw", "FL_HAA", "leg_left_1", "arm_l", "leftKnee", "LeftArm"}) {
    EXPECT_EQ(SideInName(name), 1) << name;
  }
  for (const char* name : {"right_knee", "r_hip", "RAnkleRoll", "FR_HAA", "J_R3", "arm_r"}) {
    EXPECT_EQ(SideInName(name), -1) << name;
  }
  for (const char* name :
       {"pelvis", "ankle_roll", "lower_leg", "torso", "", "left_right_bar", "roll_link"}) {
    EXPECT_EQ(SideInName(name), 0) << name;
  }
}

TEST(SideNames, TellsLegsFromArms) {
  for (const char* name : {"LHipYaw", "left_knee", "LEG_R1", "ankleRoll", "l_foot"}) {
    EXPECT_EQ(LegInName(name), 1) << name;
  }
  for (const char* name : {"LeftShoulderYaw", "r_elbow", "RightWristYaw", "left_hand_link"}) {
    EXPECT_EQ(LegInName(name), -1) << name;
  }
  for (const char* name : {"pelvis", "armature", "legend", "foot_hand", "link3", ""}) {
    EXPECT_EQ(LegInName(name), 0) << name;
  }
}

}  // namespace
}  // namespace sidestep::importer
