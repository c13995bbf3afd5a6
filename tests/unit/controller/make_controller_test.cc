// SPDX-License-Identifier: BSD-3-Clause
#include "controller/make_controller.h"

#include <gtest/gtest.h>

#include "controller/centroidal_controller.h"
#include "controller/locomotion_controller.h"
#include "controller/passive_controller.h"

namespace sidestep::make_controller_test {
namespace {

ControllerSetup SetupFor(const std::string& robot) {
  ControllerSetup setup;
  setup.robot = ReadRobotDescription(FindRobot(robot, ""));
  setup.gait.resize(1);
  setup.is_centroidal = !setup.robot.model;
  return setup;
}

template <typename Kind>
bool Makes(const ControllerSetup& setup) {
  StageTimer timer;
  return dynamic_cast<Kind*>(MakeController(setup, &timer).get()) != nullptr;
}

TEST(MakeControllerTest, ARobotWithJointsGetsTheWholeChain) {
  EXPECT_TRUE(Makes<LocomotionController>(SetupFor("hopper")));
}

TEST(MakeControllerTest, TheCentroidalPlantGetsTheChainWithoutJoints) {
  EXPECT_TRUE(Makes<CentroidalController>(SetupFor("one_leg")));
}

TEST(MakeControllerTest, PassiveIsPassiveOnEveryPlant) {
  for (const char* robot : {"hopper", "one_leg"}) {
    ControllerSetup setup = SetupFor(robot);
    setup.control.mode = ControlMode::kPassive;
    EXPECT_TRUE(Makes<PassiveController>(setup)) << robot;
  }
}

}  // namespace
}  // namespace sidestep::make_controller_test
