// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/make_world.h"

#include <gtest/gtest.h>

#include "models/support/config_error.h"
#include "sim/world/centroidal_world.h"
#include "sim/world/mujoco_world.h"
#include "tests/support/hopper_scenario.h"
#include "tests/unit/world/centroidal_test_support.h"

namespace sidestep::make_world_test {
namespace {

TEST(MakeWorldTest, TheKeyPlantDecides) {
  const std::unique_ptr<World> hopper = MakeWorld(PlainHopper());
  EXPECT_NE(dynamic_cast<const MujocoWorld*>(hopper.get()), nullptr);
  const std::unique_ptr<World> point_mass = MakeWorld(TwoFeetScenario());
  EXPECT_NE(dynamic_cast<const CentroidalWorld*>(point_mass.get()), nullptr);
}

TEST(MakeWorldTest, ACloneIsOfTheSameKind) {
  EXPECT_NE(dynamic_cast<const MujocoWorld*>(MakeWorld(PlainHopper())->Clone().get()), nullptr);
  EXPECT_NE(dynamic_cast<const CentroidalWorld*>(MakeWorld(TwoFeetScenario())->Clone().get()),
            nullptr);
}

TEST(MakeWorldTest, MassScaleAndStepReachThePlant) {
  Scenario scenario = PlainHopper();
  const double mass_kg = MakeWorld(scenario)->mass_kg();
  scenario.world.mass_scale = 1.5;
  EXPECT_NEAR(MakeWorld(scenario)->mass_kg(), 1.5 * mass_kg, 1e-12);
  scenario = TwoFeetScenario();
  scenario.world.mass_scale = 1.5;
  scenario.world.step_s = 0.01;
  const std::unique_ptr<World> falling = MakeWorld(scenario);
  falling->Step(0);
  EXPECT_EQ(falling->mass_kg(), 3.0);
  EXPECT_NEAR(falling->truth().v_WC.z(), -0.0981, 1e-15);  // g times one step
}

TEST(MakeWorldTest, RobotWithoutModelIsAUsersMistakeOnMujoco) {
  Scenario scenario = TwoFeetScenario();
  scenario.plant = Plant::kMujoco;
  EXPECT_THROW(MakeWorld(scenario), ConfigError);
}

}  // namespace
}  // namespace sidestep::make_world_test
