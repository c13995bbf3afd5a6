// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/servos_as_motors.h"

#include <gtest/gtest.h>

#include "models/mjcf/mjcf.h"
#include "tests/support/temp_folder.h"

namespace sidestep {
namespace {

constexpr char kHead[] =
    "<mujoco><compiler autolimits=\"true\"/><default><position kp=\"50\" forcerange=\"-3 3\"/>"
    "<default class=\"strong\"><position gear=\"2\" forcerange=\"-30 30\"/></default></default>"
    "<worldbody><body><freejoint/><geom size=\"0.1\"/><body><joint name=\"a\"/><joint "
    "name=\"b\"/><geom size=\"0.1\"/></body></body></worldbody>";

std::string Changed(const std::string& text) {
  const TempFolder folder;
  return WithServosAsMotors(text, folder.Write("robot.xml", text));
}

TEST(ServosAsMotors, LimitsAreTheClasssThroughTheGear) {
  const std::string text = Changed(
      std::string(kHead) +
      "<actuator><position name=\"first\" joint=\"a\" class=\"strong\"/><position "
      "joint=\"b\"/></actuator><sensor><actuatorfrc actuator=\"first\"/></sensor></mujoco>");
  const MjModelPtr model = CompileMjcf(text, "", "changed");
  ASSERT_EQ(model->nu, 2);
  EXPECT_EQ(model->actuator_trnid[0], RequireId(*model, mjOBJ_JOINT, "a"));
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(model->actuator_biastype[i], mjBIAS_NONE);
    EXPECT_EQ(model->actuator_gainprm[mjNGAIN * i], 1.0);
    EXPECT_EQ(model->actuator_gear[6 * i], 1.0);
    EXPECT_EQ(model->actuator_forcelimited[i], 0);
    EXPECT_EQ(model->actuator_ctrlrange[2 * i + 1], i == 0 ? 60.0 : 3.0);
    EXPECT_EQ(model->actuator_ctrlrange[2 * i], i == 0 ? -60.0 : -3.0);
  }
}

TEST(ServosAsMotors, WhatHasNoneStaysToTheByte) {
  const std::string motor =
      std::string(kHead) +
      "  <actuator><motor joint=\"a\" ctrlrange=\"-1 1\"/></actuator></mujoco>\n";
  EXPECT_EQ(Changed(motor), motor);
  const std::string bad = "<mujoco><actuator><position joint=\"a\"/></actuator></mujoco>";
  EXPECT_EQ(Changed(bad), bad) << "it does not compile";
}

}  // namespace
}  // namespace sidestep
