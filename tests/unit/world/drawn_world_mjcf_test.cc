// SPDX-License-Identifier: BSD-3-Clause
// The exported MJCF, loaded by MuJoCo alone, is the robot that is simulated.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "models/support/data_folder.h"
#include "sim/world/world_model.h"
#include "tests/support/temp_folder.h"

namespace sidestep::drawn_world_mjcf_test {
namespace {

RobotDescription Shipped(const std::string& name) {
  return ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models" / name /
                              "robot.yaml");
}

MjModelPtr Loaded(const RobotDescription& robot) {
  const TempFolder folder;
  const std::filesystem::path file = folder.Write("robot.xml", DrawnWorldMjcf(robot));
  std::array<char, 1000> error{};
  MjModelPtr model(mj_loadXML(file.c_str(), nullptr, error.data(), static_cast<int>(error.size())));
  EXPECT_TRUE(model) << robot.name << ": " << error.data();
  return model;
}

std::vector<mjtNum> Numbers(const mjtNum* values, int count) { return {values, values + count}; }

/// What decides how a model moves.
std::vector<std::vector<mjtNum>> Physics(const mjModel& m) {
  return {Numbers(m.body_mass, m.nbody),
          Numbers(m.body_inertia, 3 * m.nbody),
          Numbers(m.body_ipos, 3 * m.nbody),
          Numbers(m.body_iquat, 4 * m.nbody),
          Numbers(m.body_pos, 3 * m.nbody),
          Numbers(m.jnt_range, 2 * m.njnt),
          Numbers(m.dof_armature, m.nv),
          Numbers(m.dof_damping, m.nv),
          Numbers(m.geom_size, 3 * m.ngeom),
          Numbers(m.geom_friction, 3 * m.ngeom),
          Numbers(m.geom_solref, mjNREF * m.ngeom),
          Numbers(m.pair_friction, 5 * m.npair),
          Numbers(m.pair_solref, mjNREF * m.npair),
          Numbers(m.actuator_ctrlrange, 2 * m.nu),
          {m.opt.timestep, m.opt.gravity[2], static_cast<mjtNum>(m.opt.collision)}};
}

/// Where a fall with restless motors ends.
std::vector<mjtNum> AfterAFall(const mjModel& model) {
  constexpr int kSteps = 600;
  const MjDataPtr data = MakeData(model);
  for (int step = 0; step < kSteps; ++step) {
    for (int i = 0; i < model.nu; ++i) data->ctrl[i] = std::sin(0.01 * step + i);
    mj_step(&model, data.get());
  }
  return Numbers(data->qpos, model.nq);
}

TEST(DrawnWorldMjcfTest, LoadedByMujocoAloneItIsTheSimulatedRobotNumberForNumber) {
  for (const std::string name :
       {"hopper", "biped", "rabbit", "icub3", "generic_humanoid", "g1", "xbot_l"}) {
    const RobotDescription robot = Shipped(name);
    const MjModelPtr loaded = Loaded(robot);
    ASSERT_TRUE(loaded);
    const MjModelPtr ours = CompileRobotWorld(robot, WorldParams{}, ModelDetail::kDrawn);
    EXPECT_EQ(Physics(*loaded), Physics(*ours)) << name;
    EXPECT_EQ(AfterAFall(*loaded), AfterAFall(*ours)) << name;
  }
}

TEST(DrawnWorldMjcfTest, DrawnShapesWeighNothing) {
  EXPECT_NEAR(mj_getTotalmass(Loaded(Shipped("generic_humanoid")).get()), 60.0, 1e-9);
  EXPECT_NEAR(mj_getTotalmass(Loaded(Shipped("icub3")).get()), 52.41, 5e-4);
}

TEST(DrawnWorldMjcfTest, ARobotsOwnSizesOfFrictionGiveWayToTheWorlds) {
  const TempFolder folder;
  const RobotDescription mini = Shipped("hopper");
  RobotDescription robot = mini;
  std::string& xml = robot.model->drawn_mjcf;
  const std::string geom = "<geom ";
  xml.insert(xml.rfind(geom) + geom.size(), "friction=\"0.3 0.02\" ");
  const MjModelPtr loaded = Loaded(robot);
  ASSERT_TRUE(loaded);
  const MjModelPtr ours = CompileRobotWorld(robot, WorldParams{}, ModelDetail::kDrawn);
  EXPECT_EQ(Physics(*loaded), Physics(*ours));
  EXPECT_NE(Physics(*loaded), Physics(*Loaded(mini))) << "the other numbers of it stay";
}

TEST(DrawnWorldMjcfTest, ARobotWithoutAModelHasItsStandIn) {
  const MjModelPtr loaded = Loaded(Shipped("two_legs"));
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->nbody, 4) << "the world, a ball and two feet";
}

}  // namespace
}  // namespace sidestep::drawn_world_mjcf_test
