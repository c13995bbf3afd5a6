// SPDX-License-Identifier: BSD-3-Clause
// How the centroidal plant starts, and that what it records is what the drawn stand-in replays.
#include <gtest/gtest.h>

#include "sim/world/centroidal_world.h"
#include "sim/world/make_world.h"
#include "sim/world/world_model.h"
#include "tests/unit/world/centroidal_test_support.h"

namespace sidestep::centroidal_plant_start_test {
namespace {

TEST(CentroidalPlantStartTest, LeftFootIsFirstAndComRestsAboveTheMean) {
  const CentroidalWorld world = MakeCentroidalWorld(TwoFeetScenario());
  const WorldTruth& truth = world.truth();
  EXPECT_EQ(truth.feet[0].p_WF, Eigen::Vector3d(0.0, 0.1, 0.0));
  EXPECT_EQ(truth.feet[1].p_WF, Eigen::Vector3d(0.0, -0.1, 0.0));
  EXPECT_EQ(truth.p_WC, Eigen::Vector3d(0.0, 0.0, 0.5));
  EXPECT_EQ(truth.v_WC, Eigen::Vector3d::Zero());
  EXPECT_TRUE(truth.feet[0].in_contact && truth.feet[1].in_contact);
}

TEST(CentroidalPlantStartTest, SingleFootStandsBelowTheCom) {
  Scenario scenario = TwoFeetScenario();
  scenario.robot.feet.pop_back();
  const CentroidalWorld world = MakeCentroidalWorld(scenario);
  EXPECT_EQ(world.truth().feet[0].p_WF, Eigen::Vector3d::Zero());
}

TEST(CentroidalPlantStartTest, RecordedPositionsMoveTheStandInsBodies) {
  const Scenario scenario = TwoFeetScenario();
  CentroidalWorld world = MakeCentroidalWorld(scenario);
  ActuatorCommand command;
  command.centroidal_feet.resize(2);
  command.centroidal_feet[1].p_WF = {0.3, -0.2, 0.04};
  world.Apply(command);
  for (Tick tick = 0; tick < 10; ++tick) world.Step(tick);

  const MjModelPtr model = CompileDrawnWorld(scenario);
  const MjDataPtr data = MakeData(*model);
  const WorldTruth& truth = world.truth();
  ASSERT_EQ(truth.qpos.size(), model->nq);
  for (Eigen::Index i = 0; i < truth.qpos.size(); ++i) data->qpos[i] = truth.qpos[i];
  mj_kinematics(model.get(), data.get());
  const auto place = [&](const char* name) {
    const int body = RequireId(*model, mjOBJ_BODY, name);
    return Eigen::Vector3d(data->xpos[3 * body], data->xpos[3 * body + 1],
                           data->xpos[3 * body + 2]);
  };
  EXPECT_EQ(place("com"), truth.p_WC);
  EXPECT_EQ(place("right"), truth.feet[1].p_WF);
  EXPECT_LT(truth.p_WC.z(), 0.5);
}

TEST(CentroidalPlantStartTest, MassComesFromTheMjcfWhereTheRobotHasOne) {
  Scenario scenario = TwoFeetScenario();
  RobotDescription& robot = scenario.robot;
  robot.mass_kg = 0.0;
  robot.model =
      ReadMjcfModel(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models/hopper/hopper.xml");
  const CentroidalWorld world = MakeCentroidalWorld(scenario);
  const MjModelPtr model = CompileRobotWorld(robot, scenario.world, ModelDetail::kSimulated);
  EXPECT_GT(world.mass_kg(), 0.1);
  EXPECT_NEAR(world.mass_kg(), mj_getTotalmass(model.get()), 1e-12);
}

}  // namespace
}  // namespace sidestep::centroidal_plant_start_test
