// SPDX-License-Identifier: BSD-3-Clause
// What MujocoWorld tells of a humanoid: welded feet, force/torque sensors, servos, self-contact.
#include <gtest/gtest.h>

#include <cmath>

#include "models/support/config_error.h"
#include "sim/world/make_world.h"
#include "sim/world/mujoco_world.h"
#include "tests/support/box_biped.h"

namespace sidestep::humanoid_world_test {
namespace {

constexpr double kGravity_mps2 = 9.81;
constexpr double kMass_kg = 22.0;
constexpr double kHigh_m = 20.0;

// Of the sensors' sites in the soles' axes, as the MJCF has them; the soles are level.
const Eigen::Quaterniond kFrontTurn(0.8, 0.36, -0.48, 0.0);
const Eigen::Quaterniond kRearTurn(0.0, 0.6, 0.0, 0.8);
const Eigen::Vector3d kFrontSite_m(0.06, 0.02, 0.04);
const Eigen::Vector3d kRearSite_m(-0.05, -0.01, 0.04);

/// The servos at home, or `shift` (rad) from there on one joint of the actuators' order.
ActuatorCommand Home(const RobotDescription& robot, std::size_t joint = 0, double shift_rad = 0.0) {
  ActuatorCommand command;
  const auto joints = static_cast<Eigen::Index>(robot.joints.size());
  command.joint_position.setZero(joints);
  command.joint_velocity.setZero(joints);
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const auto home = robot.home.find(robot.joints[i].name);
    if (home == robot.home.end()) continue;
    command.joint_position[static_cast<Eigen::Index>(i)] = home->second;
  }
  command.joint_position[static_cast<Eigen::Index>(joint)] += shift_rad;
  return command;
}

void StepTo(Tick end, MujocoWorld* world) {
  for (Tick tick = 0; tick < end; ++tick) world->Step(tick);
}

class HumanoidWorldTest : public testing::Test {
 protected:
  /// After `ticks` on servos whose references were given once, at the start.
  MujocoWorld Standing(Tick ticks) const {
    MujocoWorld world = MakeMujocoWorld(scenario_);
    world.Apply(Home(scenario_.robot));
    StepTo(ticks, &world);
    return world;
  }

  void PushHand(const Eigen::Vector3d& force_N) {
    Push push;
    push.body = "r_palm";
    push.force_N = force_N;
    push.duration_s = 10.0;
    scenario_.pushes = {push};
  }

  TempFolder folder_;
  Scenario scenario_{BoxBipedScenario(folder_)};
};

TEST_F(HumanoidWorldTest, StandsOnItsServosOverBothFeet) {
  const MujocoWorld world = Standing(1000);
  const WorldTruth& truth = world.truth();
  EXPECT_TRUE(world.is_valid());
  EXPECT_NEAR(world.mass_kg(), kMass_kg, 1e-9);
  EXPECT_FALSE(truth.body_touches_ground) << "a box welded to the ankle is the foot's";
  EXPECT_EQ(truth.self_contact_depth_m, 0.0);
  EXPECT_EQ(truth.num_saturated, 0);
  EXPECT_NEAR(truth.p_WB.z(), scenario_.robot.base_height_m, 0.01);
  double weight_N = 0.0;
  for (const FootTruth& foot : truth.feet) {
    EXPECT_TRUE(foot.in_contact);
    EXPECT_NEAR(foot.p_WF.z(), 0.0, 2e-3);
    EXPECT_LT((foot.R_WF - Eigen::Matrix3d::Identity()).norm(), 0.02);
    EXPECT_EQ(foot.touch_N, foot.f_F_W.z()) << "it has no touch sensor: the true force";
    weight_N += foot.f_F_W.z();
  }
  // Nothing moves but for a sway of millimetres: 0.1 m/s^2 at most.
  EXPECT_NEAR(weight_N, kMass_kg * kGravity_mps2, 0.1 * kMass_kg);
}

TEST_F(HumanoidWorldTest, SensorsOfAStandingFootReadTheGroundUpwardLessTheBoxesWeight) {
  const MujocoWorld world = Standing(1000);
  const WorldTruth& truth = world.truth();
  ASSERT_EQ(truth.force_torque.size(), 5U);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const Wrench& front = truth.force_torque[1 + 2 * foot];
    const Wrench& rear = truth.force_torque[2 + 2 * foot];
    const Eigen::Vector3d front_N = kFrontTurn * front.force_N;
    const Eigen::Vector3d rear_N = kRearTurn * rear.force_N;
    const Eigen::Vector3d weight_N(0.0, 0.0, -kBoxFootMass_kg * kGravity_mps2);
    const Eigen::Vector3d expected_N = truth.feet[foot].f_F_W + weight_N;
    // The soles are level to within 0.01 rad.
    EXPECT_LT((front_N + rear_N - expected_N).norm(), 0.01 * expected_N.norm());
    EXPECT_GT((front_N + rear_N).z(), 0.3 * kMass_kg * kGravity_mps2) << "up is positive";

    const Eigen::Vector3d about_F = kFrontTurn * front.torque_Nm + kFrontSite_m.cross(front_N) +
                                    kRearTurn * rear.torque_Nm + kRearSite_m.cross(rear_N);
    const Eigen::Vector3d com_F(0.05 * (0.3 - 0.2) / kBoxFootMass_kg, 0.0, 0.02);
    const Eigen::Vector3d expected_Nm = truth.feet[foot].m_F_W + com_F.cross(weight_N);
    EXPECT_LT((about_F - expected_Nm).norm(), 0.01 * expected_N.norm() * 0.1) << "a lever of 0.1 m";
    EXPECT_GT(expected_Nm.norm(), 0.5) << "else the moment shows nothing";
  }
}

TEST_F(HumanoidWorldTest, SensorOfTheArmReadsAPushOnTheHand) {
  const Eigen::Quaterniond turn(0.6, 0.8, 0.0, 0.0);
  const auto reading = [&](const Eigen::Vector3d& force_N) {
    PushHand(force_N);
    const Wrench read = Standing(1000).truth().force_torque[0];
    return Wrench{turn * read.force_N, turn * read.torque_Nm};
  };
  const Wrench still = reading(Eigen::Vector3d::Zero());
  EXPECT_NEAR(still.force_N.z(), -0.8 * kGravity_mps2, 0.05) << "a hand hangs: down";
  const Eigen::Vector3d push_N(3.0, -4.0, 5.0);
  const Wrench pushed = reading(push_N);
  // The arm gives way by less than 0.01 rad, which tilts push and weight.
  EXPECT_LT((pushed.force_N - still.force_N - push_N).norm(), 0.02 * push_N.norm());
  const Eigen::Vector3d torque_Nm = Eigen::Vector3d(0.0, 0.0, -0.1).cross(push_N);
  EXPECT_LT((pushed.torque_Nm - still.torque_Nm - torque_Nm).norm(), 0.05 * torque_Nm.norm());
}

TEST_F(HumanoidWorldTest, PushForwardMovesTheCentreOfPressureForward) {
  // By hand: upward force ahead of F turns about -y.
  const auto pressure_x_m = [&](double force_N) {
    PushHand({force_N, 0.0, 0.0});
    const FootTruth foot = Standing(1000).truth().feet[0];
    return -foot.m_F_W.y() / foot.f_F_W.z();
  };
  const double still_m = pressure_x_m(0.0);
  EXPECT_LT(std::abs(still_m), 0.1) << "within the sole";
  EXPECT_GT(pressure_x_m(5.0), still_m + 0.005);
  EXPECT_LT(pressure_x_m(-5.0), still_m - 0.005);
}

TEST_F(HumanoidWorldTest, GroundWrenchTurnsTheCom) {
  // Dropped from 20 mm, pushed: momentum about the CoM is what the feet's wrenches make of it.
  scenario_.robot.base_height_m += 0.02;
  MujocoWorld world = MakeMujocoWorld(scenario_);
  world.Apply(Home(scenario_.robot, 8, 0.1));
  Eigen::Vector3d impulse = Eigen::Vector3d::Zero();
  for (Tick tick = 0; tick < 200; ++tick) {
    const std::vector<FootTruth> before = world.truth().feet;
    const Eigen::Vector3d p_WC = world.truth().p_WC;
    world.Step(tick);
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const FootTruth& now = world.truth().feet[foot];
      impulse += 0.001 * (now.m_F_W + (before[foot].p_WF - p_WC).cross(now.f_F_W));
    }
  }
  EXPECT_GT(impulse.norm(), 0.1);
  // First-order integration across an impact.
  EXPECT_LT((world.truth().angular_momentum - impulse).norm(), 0.05 * impulse.norm());
}

TEST_F(HumanoidWorldTest, ImuMaySitOnAnotherBodyThanTheBase) {
  const MujocoWorld world = Standing(1000);
  const ImuSample& imu = world.truth().imu;
  EXPECT_LT(imu.q_WU.angularDistance(Eigen::Quaterniond(0.8, 0.0, 0.6, 0.0)), 0.02);
  const Eigen::Vector3d specific_W = imu.q_WU * imu.accelerometer_mps2;
  EXPECT_LT((specific_W - Eigen::Vector3d(0.0, 0.0, kGravity_mps2)).norm(), 0.2);
}

TEST_F(HumanoidWorldTest, ServosActAtEveryPhysicsStepOnTheReferencesTheyHold) {
  scenario_.robot.base_height_m = kHigh_m;
  MujocoWorld world = MakeMujocoWorld(scenario_);
  world.Apply(Home(scenario_.robot, 0, 0.2));
  world.Step(0);
  EXPECT_NEAR(world.truth().joint_torque_Nm[0], 60.0, 1e-9) << "400 x 0.2 is beyond the motor";
  EXPECT_EQ(world.truth().num_saturated, 1);
  const double velocity_radps = world.truth().joint_velocity[0];
  const double position_rad = world.truth().joint_position[0];
  world.Step(1);
  const double wanted_Nm = 400.0 * (0.2 - position_rad) - 8.0 * velocity_radps;
  EXPECT_NEAR(world.truth().joint_torque_Nm[0], std::min(wanted_Nm, 60.0), 1e-9);
  for (Tick tick = 2; tick < 600; ++tick) world.Step(tick);
  EXPECT_NEAR(world.truth().joint_position[0], 0.2, 1e-3);
  EXPECT_EQ(world.truth().num_saturated, 0);
}

TEST_F(HumanoidWorldTest, JointsTellTheirBounds) {
  const MujocoWorld world = MakeMujocoWorld(scenario_);
  ASSERT_EQ(world.joints().size(), 12U);
  EXPECT_EQ(world.joints()[0].name, "shoulder");
  EXPECT_EQ(world.joints()[4].name, "l_knee");
  EXPECT_EQ(world.joints()[4].position_min, 0.0);
  EXPECT_EQ(world.joints()[4].position_max, 2.0);
  EXPECT_EQ(world.joints()[4].torque_limit_Nm, 60.0);
  EXPECT_FALSE(world.joints()[4].is_slide);
}

TEST_F(HumanoidWorldTest, LegsInEachOtherTellTheirDepth) {
  RobotDescription& robot = scenario_.robot;
  robot.base_height_m = kHigh_m;
  robot.home = {{"l_hip_roll", -0.15}, {"r_hip_roll", 0.15}};
  MujocoWorld world = MakeMujocoWorld(scenario_);
  world.Step(0);
  // By hand: the lower ends of the shanks' axes, 0.35 m below the hips, are 2 (0.07 - 0.35 sin
  // 0.15) apart and the capsules' radii 0.03.
  EXPECT_NEAR(world.truth().self_contact_depth_m, 0.06 - 2.0 * (0.07 - 0.35 * std::sin(0.15)),
              1e-9);
  EXPECT_FALSE(world.truth().body_touches_ground);
}

TEST_F(HumanoidWorldTest, HeavierPlantIsHeavierInEveryPart) {
  scenario_.robot.base_height_m = kHigh_m;
  Push push;
  push.body = "pelvis";
  push.force_N = {0.0, 50.0, 0.0};
  push.duration_s = 0.1;
  scenario_.pushes = {push};
  const auto motion = [&](double scale) {
    scenario_.world.mass_scale = scale;
    MujocoWorld world = MakeMujocoWorld(scenario_);
    EXPECT_NEAR(world.mass_kg(), scale * kMass_kg, 1e-9);
    StepTo(100, &world);
    return std::pair(world.truth().v_WC.y(), world.truth().angular_momentum.norm());
  };
  const auto [speed_mps, momentum] = motion(1.0);
  EXPECT_NEAR(speed_mps, 50.0 * 0.1 / kMass_kg, 2e-3);
  const auto [heavy_speed_mps, heavy_momentum] = motion(1.5);
  EXPECT_NEAR(heavy_speed_mps, speed_mps / 1.5, 2e-3);
  EXPECT_NEAR(heavy_momentum, momentum, 0.05 * momentum) << "the same lever, the same turn";
}

TEST_F(HumanoidWorldTest, HeavierPlantStandsOnMoreTorque) {
  const auto knee_Nm = [&](double scale) {
    scenario_.world.mass_scale = scale;
    return std::abs(Standing(1000).truth().joint_torque_Nm[4]);
  };
  const double nominal_Nm = knee_Nm(1.0);
  EXPECT_GT(nominal_Nm, 1.0);
  // Servos sag more under more weight, which changes the levers a little.
  EXPECT_NEAR(knee_Nm(1.3), 1.3 * nominal_Nm, 0.15 * nominal_Nm);
}

TEST_F(HumanoidWorldTest, ServosMustBeThoseOfTheMotors) {
  std::swap(scenario_.robot.joints[1], scenario_.robot.joints[3]);
  try {
    const MujocoWorld world = MakeMujocoWorld(scenario_);
    ADD_FAILURE() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(),
                 "box_biped/robot.yaml: error: servo 1 is called 'l_hip_pitch', but the MJCF's "
                 "motor moves 'waist'");
  }
}

TEST_F(HumanoidWorldTest, SensorThatTheMjcfLacksIsAConfigError) {
  scenario_.robot.force_torque[0] = "l_arm_ft";
  try {
    const MujocoWorld world = MakeMujocoWorld(scenario_);
    ADD_FAILURE() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "error: the robot's MJCF has no sensor called 'l_arm_ft_force'");
  }
}

}  // namespace
}  // namespace sidestep::humanoid_world_test
