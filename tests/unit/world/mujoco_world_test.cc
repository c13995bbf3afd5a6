// SPDX-License-Identifier: BSD-3-Clause
// Laws of the simulated world: momentum, weight, who touches the floor, and what ends a run.
#include "sim/world/mujoco_world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "models/support/config_error.h"
#include "models/support/require.h"
#include "sim/world/make_world.h"
#include "tests/support/hopper_scenario.h"
#include "tests/support/temp_folder.h"

namespace sidestep::mujoco_world_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr double kGravity_mps2 = 9.81;
constexpr double kHigh_m = 20.0;  // falls for 1 s and more before it touches anything

ActuatorCommand Torque(double roll_Nm, double pitch_Nm, double leg_N) {
  ActuatorCommand command;
  command.torque_Nm = Eigen::Vector3d(roll_Nm, pitch_Nm, leg_N);
  return command;
}

void StepFrom(MujocoWorld* world, Tick from, Tick to) {
  for (Tick tick = from; tick < to; ++tick) world->Step(tick);
}

/// A world whose hopper holds its joints by springs, which is enough to stand for a while.
void RunStanding(MujocoWorld* world, Tick from, Tick to) {
  const Eigen::Vector3d home(0.0, 0.0, 0.15), stiffness(50.0, 50.0, 2000.0),
      damping(2.0, 2.0, 40.0);
  for (Tick tick = from; tick < to; ++tick) {
    const WorldTruth& truth = world->truth();
    const Eigen::Vector3d torque = stiffness.cwiseProduct(home - truth.joint_position) -
                                   damping.cwiseProduct(Eigen::Vector3d(truth.joint_velocity));
    world->Apply(Torque(torque.x(), torque.y(), torque.z()));
    world->Step(tick);
  }
}

TEST(MujocoWorldTest, StartsAtHomeInStepWithItself) {
  const MujocoWorld world = MakeMujocoWorld(PlainHopper());
  const WorldTruth& truth = world.truth();
  EXPECT_TRUE(world.is_valid());
  EXPECT_NEAR(world.mass_kg(), 1.0, 1e-12);
  ASSERT_EQ(world.joints().size(), 3U);
  EXPECT_EQ(world.joints()[0].name, "hip_roll");
  EXPECT_FALSE(world.joints()[0].is_slide);
  EXPECT_EQ(world.joints()[2].name, "leg");
  EXPECT_TRUE(world.joints()[2].is_slide);
  EXPECT_EQ(truth.joint_position, Eigen::Vector3d(0.0, 0.0, 0.15));
  EXPECT_NEAR(truth.p_WB.z(), 0.515, 1e-12);
  EXPECT_NEAR(truth.feet[0].p_WF.z(), 0.015, 1e-12);
  EXPECT_EQ(truth.p_WB.z(), truth.qpos[2]);
}

TEST(MujocoWorldTest, InFlightTheComFallsFreely) {
  MujocoWorld world = MakeMujocoWorld(PlainHopper(kHigh_m));
  const Eigen::Vector3d start = world.truth().p_WC;
  world.Apply(Torque(0.5, -0.4, 3.0));  // inner forces move no CoM
  StepFrom(&world, 0, 300);
  // Semi-implicit Euler: v = g t, p = g t (t + dt) / 2. The legs' motion adds its own error of
  // order dt: velocity at the old posture is carried to the new one.
  EXPECT_NEAR(world.truth().v_WC.z(), -kGravity_mps2 * 0.3, 5e-3);
  EXPECT_LT(world.truth().v_WC.head<2>().norm(), 5e-3);
  EXPECT_NEAR(world.truth().p_WC.z() - start.z(), -0.5 * kGravity_mps2 * 0.3 * 0.301, 2e-3);
}

TEST(MujocoWorldTest, PushThroughTheTrunkInFlightGivesImpulseOverMass) {
  Scenario scenario = PlainHopper(kHigh_m);
  scenario.pushes = {TrunkPush({3.0, -4.0, 2.0}, 0.1, 0.2, kTrunkCom_m)};
  MujocoWorld world = MakeMujocoWorld(scenario);
  StepFrom(&world, 0, 400);
  // J / m = F dt with 1 kg, and gravity; the leg swings a little, see above.
  const Eigen::Vector3d expected =
      Eigen::Vector3d(0.6, -0.8, 0.4) - Eigen::Vector3d(0.0, 0.0, kGravity_mps2 * 0.4);
  EXPECT_LT((world.truth().v_WC - expected).norm(), 5e-3);
}

TEST(MujocoWorldTest, PushErrorShrinksWithTheStep) {
  const auto error = [](double step_s) {
    Scenario scenario = PlainHopper(kHigh_m);
    scenario.world.step_s = step_s;
    scenario.pushes = {TrunkPush({3.0, -4.0, 0.0}, 0.0, 0.2, kTrunkCom_m)};
    MujocoWorld world = MakeMujocoWorld(scenario);
    StepFrom(&world, 0, TickAt(0.2, step_s));
    return (world.truth().v_WC - Eigen::Vector3d(0.6, -0.8, -kGravity_mps2 * 0.2)).norm();
  };
  const double coarse = error(0.001);
  const double fine = error(0.0001);
  EXPECT_GT(coarse, 0.0);
  EXPECT_LT(fine, 0.2 * coarse) << "first order: a tenth";
}

TEST(MujocoWorldTest, PushesEnd) {
  Scenario scenario = PlainHopper(kHigh_m);
  scenario.pushes = {TrunkPush({5.0, 0.0, 0.0}, 0.05, 0.1, kTrunkCom_m)};
  MujocoWorld world = MakeMujocoWorld(scenario);
  StepFrom(&world, 0, 149);
  EXPECT_EQ(world.truth().pushes[0].force_W_N, Eigen::Vector3d(5.0, 0.0, 0.0)) << "still acts";
  world.Step(149);
  EXPECT_EQ(world.truth().pushes[0].force_W_N, Eigen::Vector3d::Zero());
  const double after_mps = world.truth().v_WC.x();
  StepFrom(&world, 150, 300);
  EXPECT_NEAR(world.truth().v_WC.x(), after_mps, 2e-3) << "nothing pushes on";
  EXPECT_NEAR(after_mps, 0.5, 2e-3);
}

TEST(MujocoWorldTest, PushOffTheComTurnsTheRobotTheRightWay) {
  struct Case {
    Eigen::Vector3d force_N, point_m, torque;
  };
  // By hand: r x F. Ahead of the trunk's CoM and to the left: a turn about +z; and so on.
  const Case cases[] = {
      {{0.0, 1.0, 0.0}, {0.2, 0.0, 0.02}, {0.0, 0.0, 0.2}},
      {{1.0, 0.0, 0.0}, {0.0, 0.0, 0.22}, {0.0, 0.2, 0.0}},
      {{0.0, 0.0, 1.0}, {0.0, 0.2, 0.02}, {0.2, 0.0, 0.0}},
  };
  for (const Case& one : cases) {
    Scenario scenario = PlainHopper(kHigh_m);
    scenario.pushes = {TrunkPush(one.force_N, 0.0, 0.05, one.point_m)};
    MujocoWorld pushed = MakeMujocoWorld(scenario);
    scenario.pushes = {TrunkPush(one.force_N, 0.0, 0.05, kTrunkCom_m)};
    MujocoWorld centred = MakeMujocoWorld(scenario);
    StepFrom(&pushed, 0, 50);
    StepFrom(&centred, 0, 50);
    const Eigen::Vector3d gained =
        pushed.truth().angular_momentum - centred.truth().angular_momentum;
    // The arm turns by less than 0.02 rad in 50 ms.
    EXPECT_LT((gained - 0.05 * one.torque).norm(), 0.02 * 0.05 * one.torque.norm())
        << one.torque.transpose();
    EXPECT_GT(pushed.truth().w_WB_B.dot(one.torque), 0.0);
  }
}

TEST(MujocoWorldTest, FrameMayBePushedLikeABody) {
  Scenario scenario = PlainHopper(kHigh_m);
  Push push = TrunkPush({0.0, 2.0, 0.0}, 0.0, 0.1, Eigen::Vector3d::Zero());
  push.body = "imu";
  scenario.pushes = {push};
  MujocoWorld world = MakeMujocoWorld(scenario);
  EXPECT_LT((world.truth().pushes[0].p_W - Eigen::Vector3d(0.0, 0.0, kHigh_m + 0.03)).norm(),
            1e-12);
  StepFrom(&world, 0, 100);
  EXPECT_NEAR(world.truth().v_WC.y(), 0.2, 2e-3);
}

TEST(MujocoWorldTest, StandingFootCarriesTheWeight) {
  MujocoWorld world = MakeMujocoWorld(PlainHopper());
  RunStanding(&world, 0, 300);
  const FootTruth& foot = world.truth().feet[0];
  EXPECT_TRUE(foot.in_contact);
  EXPECT_FALSE(world.truth().body_touches_ground);
  // A stick on springs, falling over slowly: its CoM's acceleration is still below 0.1 m/s^2.
  EXPECT_NEAR(foot.f_F_W.z(), kGravity_mps2 * world.mass_kg(), 0.1);
  EXPECT_NEAR(foot.touch_N, foot.f_F_W.z(), 1e-6) << "a level floor: all of it is normal";
}

TEST(MujocoWorldTest, ContactForceIsWhatMovesTheCom) {
  MujocoWorld world = MakeMujocoWorld(PlainHopper(0.6));  // drops 85 mm onto its leg
  bool touched = false;
  Eigen::Vector3d impulse_Ns = Eigen::Vector3d::Zero();
  const Eigen::Vector3d start = world.truth().v_WC;
  for (Tick tick = 0; tick < 250; ++tick) {
    RunStanding(&world, tick, tick + 1);
    impulse_Ns += kTick_s * (world.truth().feet[0].f_F_W + Eigen::Vector3d(0, 0, -kGravity_mps2));
    touched = touched || world.truth().feet[0].in_contact;
  }
  EXPECT_TRUE(touched);
  EXPECT_LT((world.truth().v_WC - start - impulse_Ns).norm(), 0.02)
      << "momentum of 1 kg is the sum of impulses; a first-order integrator across an impact";
}

TEST(MujocoWorldTest, LimpHopperFallsUntilItsBodyTouchesTheGround) {
  Scenario scenario = PlainHopper();
  scenario.pushes = {TrunkPush({2.0, 0.0, 0.0}, 0.0, 0.1, kTrunkCom_m)};
  MujocoWorld world = MakeMujocoWorld(scenario);
  EXPECT_FALSE(world.truth().body_touches_ground);
  Tick tick = 0;
  while (!world.truth().body_touches_ground && tick < 3000) world.Step(tick++);
  EXPECT_LT(tick, 3000) << "it never fell";
  EXPECT_GT(tick, 100) << "half a metre takes 0.3 s";
  EXPECT_LT(world.truth().p_WB.z(), 0.3);
  EXPECT_TRUE(world.is_valid()) << "to fall is no error of the physics";
}

TEST(MujocoWorldTest, RobotInTheAirTouchesNothing) {
  MujocoWorld world = MakeMujocoWorld(PlainHopper(kHigh_m));
  StepFrom(&world, 0, 100);
  EXPECT_FALSE(world.truth().feet[0].in_contact);
  EXPECT_EQ(world.truth().feet[0].f_F_W.norm(), 0.0);
  EXPECT_EQ(world.truth().feet[0].touch_N, 0.0);
  EXPECT_LT(world.truth().imu.accelerometer_mps2.norm(), 0.1) << "weightless";
}

TEST(MujocoWorldTest, CommandsBeyondTheActuatorsRangeAreCut) {
  MujocoWorld bounded = MakeMujocoWorld(PlainHopper(kHigh_m));
  MujocoWorld excessive = MakeMujocoWorld(PlainHopper(kHigh_m));
  bounded.Apply(Torque(0.0, 0.0, 60.0));
  excessive.Apply(Torque(0.0, 0.0, 1e6));
  StepFrom(&bounded, 0, 20);
  StepFrom(&excessive, 0, 20);
  EXPECT_EQ(bounded.truth().qpos, excessive.truth().qpos);
}

TEST(MujocoWorldTest, PowerIsTorqueTimesSpeed) {
  MujocoWorld world = MakeMujocoWorld(PlainHopper(kHigh_m));
  world.Apply(Torque(0.0, 0.0, 2.0));
  StepFrom(&world, 0, 10);
  const double speed_mps = std::abs(world.truth().joint_velocity[2]);
  EXPECT_GT(speed_mps, 0.01);
  EXPECT_NEAR(world.truth().actuator_power_W, 2.0 * speed_mps, 1e-9);
}

TEST(MujocoWorldTest, DivergedPhysicsIsInvalidWithItsReasonForGood) {
  // MuJoCo logs its warnings into the working folder.
  const std::filesystem::path before = std::filesystem::current_path();
  const TempFolder folder;
  std::filesystem::current_path(folder.path());
  Scenario scenario = PlainHopper(kHigh_m);
  scenario.pushes = {TrunkPush({1e13, 0.0, 0.0}, 0.0, 0.01, kTrunkCom_m)};
  MujocoWorld world = MakeMujocoWorld(scenario);
  EXPECT_TRUE(world.is_valid());
  StepFrom(&world, 0, 10);
  EXPECT_FALSE(world.is_valid());
  const std::string reason = world.invalid_reason();
  EXPECT_FALSE(reason.empty());
  EXPECT_EQ(reason.find('\n'), std::string::npos) << reason;
  StepFrom(&world, 10, 200);
  EXPECT_FALSE(world.is_valid()) << "MuJoCo resets its state; the verdict must not";
  EXPECT_EQ(world.invalid_reason(), reason);
  std::filesystem::current_path(before);
}

TEST(MujocoWorldTest, SameScenarioGivesTheSameStatesBitForBit) {
  Scenario scenario = PlainHopper();
  scenario.pushes = {TrunkPush({1.0, 0.5, 0.0}, 0.1, 0.1, Eigen::Vector3d::Zero())};
  MujocoWorld first = MakeMujocoWorld(scenario), second = MakeMujocoWorld(scenario);
  RunStanding(&first, 0, 500);
  RunStanding(&second, 0, 500);
  EXPECT_EQ(first.truth().qpos, second.truth().qpos);
}

TEST(MujocoWorldTest, MirroredPushGivesMirroredMotion) {
  const auto end_y = [](double force_N) {
    Scenario scenario = PlainHopper();
    scenario.pushes = {TrunkPush({0.0, force_N, 0.0}, 0.1, 0.1, kTrunkCom_m)};
    MujocoWorld world = MakeMujocoWorld(scenario);
    RunStanding(&world, 0, 400);
    return world.truth().p_WC.y();
  };
  EXPECT_GT(end_y(2.0), 0.01);
  // The floor's contact solver iterates to 1e-8 of the forces.
  EXPECT_NEAR(end_y(2.0), -end_y(-2.0), 1e-6);
}

TEST(MujocoWorldTest, NamesThatTheMjcfLacksAreConfigErrors) {
  Scenario scenario = PlainHopper();
  scenario.robot.feet[0].name = "hoof";
  try {
    const MujocoWorld world = MakeMujocoWorld(scenario);
    ADD_FAILURE() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "error: the robot's MJCF has no sensor called 'hoof_touch'");
  }
}

TEST(MujocoWorldTest, CommandMustHaveOneTorqueAJoint) {
  MujocoWorld world = MakeMujocoWorld(PlainHopper());
  ActuatorCommand command;
  command.torque_Nm.setZero(2);
  EXPECT_THROW(world.Apply(command), ContractViolation);
}

}  // namespace
}  // namespace sidestep::mujoco_world_test
