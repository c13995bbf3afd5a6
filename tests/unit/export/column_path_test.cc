// SPDX-License-Identifier: BSD-3-Clause
#include "sim/export/column_path.h"

#include <gtest/gtest.h>

namespace sidestep {
namespace {

TEST(ColumnPath, GroupsByWhoSaysItAndOfWhat) {
  EXPECT_EQ(PathText(PathOf("truth_p_WC_x_m")), "truth/com/position/x_m");
  EXPECT_EQ(PathText(PathOf("truth_tilt_rad")), "truth/base/tilt_rad");
  EXPECT_EQ(PathText(PathOf("belief_f_F_W_left_z_N")), "belief/feet/left/force/z_N");
  EXPECT_EQ(PathText(PathOf("joint_l_knee_rad")), "joints_state/positions/l_knee_rad");
  EXPECT_EQ(PathText(PathOf("joint_l_knee_Nm")), "joints_state/torques/l_knee_Nm");
}

TEST(ColumnPath, WhatItDoesNotKnowIsOther) {
  EXPECT_EQ(PathText(PathOf("weather")), "other/weather");
}

}  // namespace
}  // namespace sidestep
