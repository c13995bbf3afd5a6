// SPDX-License-Identifier: BSD-3-Clause
// The iCub that ships, on its servos: its sensors against the truth and the model's masses.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/home_pose.h"
#include "sim/scenario/read_scenario.h"
#include "sim/world/make_world.h"
#include "sim/world/mujoco_world.h"
#include "sim/world/world_model.h"
#include "tests/support/temp_folder.h"

namespace sidestep::icub3_world_test {
namespace {

constexpr double kGravity_mps2 = 9.81;

class Icub3WorldTest : public testing::Test {
 protected:
  /// After a second with the servos' references at home.
  MujocoWorld Standing() const {
    const RobotDescription& robot = scenario_.robot;
    ActuatorCommand command;
    command.joint_position.setZero(static_cast<Eigen::Index>(robot.joints.size()));
    command.joint_velocity = command.joint_position;
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      const auto home = robot.home.find(robot.joints[i].name);
      if (home != robot.home.end()) {
        command.joint_position[static_cast<Eigen::Index>(i)] = home->second;
      }
    }
    MujocoWorld world = MakeMujocoWorld(scenario_);
    world.Apply(command);
    for (Tick tick = 0; tick < 1000; ++tick) world.Step(tick);
    return world;
  }

  /// What a sensor feels, turned into W, less the weight of all that hangs on it: what else acts
  /// there. The robot must be at rest.
  Eigen::Vector3d FeltBeyond(const WorldTruth& truth, const std::string& sensor) const {
    const auto& names = scenario_.robot.force_torque;
    const auto at =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), sensor) - names.begin());
    const MjModelPtr model = CompileDrawnWorld(scenario_);
    const MjDataPtr data = MakeData(*model);
    mju_copy(data->qpos, truth.qpos.data(), model->nq);
    mj_kinematics(model.get(), data.get());
    const int site = RequireId(*model, mjOBJ_SITE, sensor);
    mjtNum force_W[3];
    mju_rotVecMat(force_W, truth.force_torque[at].force_N.data(), data->site_xmat + 9 * site);
    const double mass_kg = model->body_subtreemass[model->site_bodyid[site]];
    return {force_W[0], force_W[1], force_W[2] + mass_kg * kGravity_mps2};
  }

  TempFolder folder_;
  Scenario scenario_{ReadScenario(folder_.Write(
      "a.yaml", "sidestep: 1\nname: a\nrobot: icub3\nduration_s: 1\ncontrol: {mode: position}\n"))};
};

TEST_F(Icub3WorldTest, StandsOnItsServosWithItsWeightInTheFeetsSensors) {
  const MujocoWorld world = Standing();
  const WorldTruth& truth = world.truth();
  EXPECT_TRUE(world.is_valid());
  EXPECT_FALSE(truth.body_touches_ground);
  EXPECT_EQ(truth.self_contact_depth_m, 0.0);
  EXPECT_EQ(truth.num_saturated, 0);
  double weight_N = 0.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const FootTruth& foot = truth.feet[i];
    Eigen::Vector3d felt_N = Eigen::Vector3d::Zero();
    for (const std::string& name : scenario_.robot.feet[i].force_torque) {
      felt_N += FeltBeyond(truth, name);
    }
    // It stands still but for a sway below 0.01 m/s^2; the soles weigh a kilogram.
    EXPECT_LT((felt_N - foot.f_F_W).norm(), 0.1) << i;
    EXPECT_GT(foot.f_F_W.z(), 100.0) << i;
    weight_N += foot.f_F_W.z();
  }
  EXPECT_NEAR(weight_N, world.mass_kg() * kGravity_mps2, 1.0);
}

/// What MuJoCo knows of a contact, whatever the order of its geoms.
using Contact = std::array<double, 20>;

/// The contacts at a state, sorted.
std::vector<Contact> ContactsAt(const mjModel& model, const mjData& state, mjData* data) {
  mju_copy(data->qpos, state.qpos, model.nq);
  mj_fwdPosition(&model, data);
  std::vector<Contact> contacts;
  for (int i = 0; i < data->ncon; ++i) {
    const mjContact& at = data->contact[i];
    contacts.push_back({1.0 * std::min(at.geom1, at.geom2),
                        1.0 * std::max(at.geom1, at.geom2),
                        at.pos[0],
                        at.pos[1],
                        at.pos[2],
                        at.dist,
                        1.0 * at.dim,
                        at.friction[0],
                        at.friction[1],
                        at.friction[2],
                        at.friction[3],
                        at.friction[4],
                        at.solref[0],
                        at.solref[1],
                        at.solimp[0],
                        at.solimp[1],
                        at.solimp[2],
                        at.solimp[3],
                        at.solimp[4],
                        at.includemargin});
  }
  std::sort(contacts.begin(), contacts.end());
  return contacts;
}

// Without torques it collapses: feet, knees, trunk and arms come to the ground, and to each other.
TEST_F(Icub3WorldTest, ListedContactsAreThoseThatMuJoCosSearchFinds) {
  scenario_.world.friction = 0.37;
  const MjModelPtr listed =
      CompileRobotWorld(scenario_.robot, scenario_.world, ModelDetail::kSimulated);
  scenario_.robot.model->ground_pairs.clear();
  const MjModelPtr searched =
      CompileRobotWorld(scenario_.robot, scenario_.world, ModelDetail::kSimulated);
  EXPECT_EQ(listed->opt.collision, mjCOL_PAIR);
  EXPECT_EQ(searched->opt.collision, mjCOL_ALL);
  const MjDataPtr run = MakeData(*listed), found = MakeData(*listed),
                  expected = MakeData(*searched);
  PlaceAtHome(*listed, scenario_.robot, run.get());
  std::size_t most = 0;
  for (int tick = 0; tick < 2000; ++tick) {
    mj_step(listed.get(), run.get());
    if (tick % 20 != 0) continue;
    const std::vector<Contact> contacts = ContactsAt(*listed, *run, found.get());
    ASSERT_EQ(contacts, ContactsAt(*searched, *run, expected.get())) << tick;
    most = std::max(most, contacts.size());
  }
  EXPECT_GT(most, 10u) << "a robot on its soles proves little";
}

TEST_F(Icub3WorldTest, ArmsFeelAPushOnTheHandAndNothingElse) {
  const Eigen::Vector3d push_N(5.0, 10.0, -3.0);
  Push push;
  push.body = "r_hand";
  push.force_N = push_N;
  push.duration_s = 10.0;
  scenario_.pushes = {push};
  const MujocoWorld world = Standing();
  EXPECT_LT((FeltBeyond(world.truth(), "r_arm_ft") - push_N).norm(), 0.1);
  EXPECT_LT(FeltBeyond(world.truth(), "l_arm_ft").norm(), 0.1);
}

}  // namespace
}  // namespace sidestep::icub3_world_test
