// SPDX-License-Identifier: BSD-3-Clause
// Ground that is not level: where its geoms lie, what stands on it, and what counts as a fall.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "models/mjcf/ground.h"
#include "models/mjcf/mj_state.h"
#include "models/support/config_error.h"
#include "sim/world/box_contacts.h"
#include "sim/world/make_world.h"
#include "sim/world/mujoco_world.h"
#include "sim/world/world_model.h"
#include "tests/support/hopper_scenario.h"

namespace sidestep::uneven_world_test {
namespace {

constexpr double kWeight_N = 9.81;
constexpr double kBall_m = 0.015;  // of the hopper's foot, whose frame is its centre

/// The hopper over ground that is `height_m` high where it starts, let go a millimetre above it.
MujocoWorld HopperOn(double height_m) {
  Scenario scenario = PlainHopper();
  scenario.robot.base_height_m += height_m + 0.001;
  scenario.world.ground = {{-0.5, 0.5, -0.5, 0.5, height_m}};
  return MakeMujocoWorld(scenario);
}

/// Mean load of the foot from tick 200 to 300, its joints held by springs.
double MeanLoad_N(MujocoWorld* world) {
  double sum_N = 0.0;
  for (Tick tick = 0; tick < 300; ++tick) {
    const WorldTruth& truth = world->truth();
    ActuatorCommand command;
    command.torque_Nm = Eigen::Vector3d(50.0, 50.0, 2000.0)
                            .cwiseProduct(Eigen::Vector3d(0.0, 0.0, 0.15) - truth.joint_position) -
                        Eigen::Vector3d(2.0, 2.0, 40.0).cwiseProduct(truth.joint_velocity);
    world->Apply(command);
    world->Step(tick);
    if (tick >= 200) sum_N += world->truth().feet[0].f_F_W.z() / 100.0;
  }
  return sum_N;
}

TEST(UnevenWorldTest, TheFootStandsAtThePatchesHeight) {
  for (const double height_m : {-0.3, -0.02, 0.02, 0.3}) {
    MujocoWorld world = HopperOn(height_m);
    // The contact gives by less than 0.3 mm under the hopper's weight (measured: 0.1 mm).
    EXPECT_NEAR(MeanLoad_N(&world), kWeight_N, 0.2 * kWeight_N) << height_m;
    EXPECT_NEAR(world.truth().feet[0].p_WF.z(), height_m + kBall_m, 3e-4) << height_m;
    EXPECT_FALSE(world.truth().body_touches_ground);
  }
}

TEST(UnevenWorldTest, APatchInTheRobotIsAnError) {
  Scenario scenario = PlainHopper();
  scenario.world.ground = {{-0.5, 0.5, -0.5, 0.5, 0.5}};  // reaches up to the trunk
  EXPECT_THROW(MakeMujocoWorld(scenario), ConfigError);
  scenario.world.ground = {{-0.5, 0.5, -0.5, 0.5, 0.01}};
  EXPECT_THROW(MakeMujocoWorld(scenario), ConfigError) << "the foot is in it";
  scenario.world.ground = {{0.3, 0.5, -0.5, 0.5, 0.5}};
  EXPECT_NO_THROW(MakeMujocoWorld(scenario)) << "it stands in front";
}

TEST(UnevenWorldTest, ABodyOnASlabHasFallen) {
  Scenario scenario = PlainHopper();
  scenario.robot.base_height_m += 0.02;
  scenario.world.ground = {{-20.0, 20.0, -20.0, 20.0, 0.02}};
  scenario.pushes = {TrunkPush({5.0, 0.0, 0.0}, 0.0, 1.0, Eigen::Vector3d::Zero())};
  MujocoWorld world = MakeMujocoWorld(scenario);
  for (Tick tick = 0; tick < 3000 && !world.truth().body_touches_ground; ++tick) world.Step(tick);
  EXPECT_TRUE(world.truth().body_touches_ground) << "nobody holds it";
}

TEST(UnevenWorldTest, WhoLeavesTheGroundThatEndsIsInvalid) {
  Scenario scenario = PlainHopper();
  scenario.pushes.resize(1);
  scenario.pushes[0].body = scenario.robot.base;
  scenario.pushes[0].force_N = {0.0, -1e5, 0.0};
  scenario.pushes[0].duration_s = 0.1;
  for (const bool is_uneven : {false, true}) {
    if (is_uneven) scenario.world.ground = {{1.0, 2.0, -1.0, 1.0, -0.02}};
    MujocoWorld world = MakeMujocoWorld(scenario);
    for (Tick tick = 0; tick < 200; ++tick) world.Step(tick);
    EXPECT_LT(world.truth().p_WB.y(), -100.0);
    EXPECT_EQ(world.is_valid(), !is_uneven) << world.invalid_reason();
  }
}

TEST(UnevenWorldTest, GeomsLieWhereThePatchesSayAndRubAsTheSettingSays) {
  Scenario scenario = PlainHopper();
  scenario.world.friction = 0.4;
  scenario.world.ground = {{1.0, 1.5, -1.0, 3.0, -0.02}, {2.0, 3.0, -1.0, 1.0, 0.04}};
  const MjModelPtr model =
      CompileRobotWorld(scenario.robot, scenario.world, ModelDetail::kSimulated);
  const int plane = RequireId(*model, mjOBJ_GEOM, kGroundGeom);
  EXPECT_EQ(model->geom_pos[3 * plane + 2], -0.02);
  bool has_step = false;
  for (int geom = 0; geom < model->ngeom; ++geom) {
    if (model->geom_bodyid[geom] != 0) continue;
    EXPECT_EQ(model->geom_friction[3 * geom], 0.4);
    EXPECT_EQ(model->geom_condim[geom], model->geom_condim[plane]);
    EXPECT_EQ(model->geom_contype[geom], 1);
    if (geom == plane) continue;
    const double top_m = model->geom_pos[3 * geom + 2] + model->geom_size[3 * geom + 2];
    const bool is_step = std::abs(top_m - 0.04) < 1e-12;
    EXPECT_TRUE(is_step || std::abs(top_m) < 1e-12) << top_m;
    if (is_step) {
      EXPECT_EQ(model->geom_pos[3 * geom], 2.5);
    }
    has_step = has_step || is_step;
  }
  EXPECT_TRUE(has_step);
}

TEST(UnevenWorldTest, LightAndCameraGoByTheRobotNotByTheSlabs) {
  Scenario scenario = PlainHopper();
  const MjModelPtr level = CompileRobotWorld(scenario.robot, scenario.world, ModelDetail::kDrawn);
  scenario.world.ground = {{1.0, 1.5, -1.0, 3.0, -0.02}};
  const MjModelPtr uneven = CompileRobotWorld(scenario.robot, scenario.world, ModelDetail::kDrawn);
  EXPECT_EQ(uneven->stat.extent, level->stat.extent);
}

// A URDF's world lists its contacts: each slab has those of the plane, with the same friction.
TEST(UnevenWorldTest, ListedContactsOfThePlaneAreEverySlabsToo) {
  Scenario scenario;
  scenario.robot = ReadRobotDescription(FindRobot("icub3", ""));
  const MjModelPtr level =
      CompileRobotWorld(scenario.robot, scenario.world, ModelDetail::kSimulated);
  const int self = [&] {
    int count = 0;
    for (int pair = 0; pair < level->npair; ++pair) {
      count += level->geom_bodyid[level->pair_geom1[pair]] != 0 &&
               level->geom_bodyid[level->pair_geom2[pair]] != 0;
    }
    return count;
  }();
  scenario.world.friction = 0.3;
  scenario.world.ground = {{1.0, 1.5, -kGroundReach_m, kGroundReach_m, 0.02}};  // one slab
  const MjModelPtr uneven =
      CompileRobotWorld(scenario.robot, scenario.world, ModelDetail::kSimulated);
  EXPECT_EQ(uneven->npair, 2 * level->npair - self);
  for (int pair = 0; pair < uneven->npair; ++pair) {
    if (uneven->geom_bodyid[uneven->pair_geom1[pair]] != 0 &&
        uneven->geom_bodyid[uneven->pair_geom2[pair]] != 0) {
      continue;
    }
    EXPECT_EQ(uneven->pair_friction[5 * pair], 0.3);
  }
}

/// Deepest contact of a foot of 20 cm that lies over the edge of a slab of 20 m (m).
double DeepestOverAnEdge_m() {
  const MjModelPtr model = CompileMjcf(
      "<mujoco><worldbody><geom type='box' size='10 10 0.5' pos='-9.975 0 -0.5'/>"
      "<body><freejoint/><geom type='box' size='0.1 0.05 0.007' mass='0.1'/></body></worldbody>"
      "</mujoco>",
      "", "edge.xml");
  const MjDataPtr data = MakeData(*model);
  double deepest_m = 0.0;
  for (int i = 0; i < 20000; ++i) {
    // Over the edge at 0.025 m by 0 to 7 cm, pitched by at most 1e-3 rad, 0.05 mm deep.
    const double pitch_rad = 1e-3 * std::sin(1.7 * i);
    mju_zero(data->qpos, 7);
    data->qpos[0] = -0.05 + 0.05 * std::sin(0.37 * i);
    data->qpos[1] = 0.06;
    data->qpos[2] = 0.007 - 5e-5 * std::abs(std::sin(2.3 * i));
    data->qpos[3] = std::cos(0.5 * pitch_rad);
    data->qpos[5] = std::sin(0.5 * pitch_rad);
    mj_kinematics(model.get(), data.get());
    mj_comPos(model.get(), data.get());
    mj_collision(model.get(), data.get());
    for (int k = 0; k < data->ncon; ++k) {
      deepest_m = std::min(deepest_m, data->contact[k].dist);
    }
  }
  return deepest_m;
}

TEST(BoxContactsTest, NoneIsDeeperThanTheFootIsThick) {
  DropImpossibleBoxContacts();
  DropImpossibleBoxContacts();
  // Pitch times half the foot's length, and what it was sunk by.
  EXPECT_GT(DeepestOverAnEdge_m(), -1e-3 * 0.1 - 5e-5 - 1e-5);
  EXPECT_LT(DeepestOverAnEdge_m(), 0.0);
}

}  // namespace
}  // namespace sidestep::uneven_world_test
