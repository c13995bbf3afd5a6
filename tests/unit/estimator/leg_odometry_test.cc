// SPDX-License-Identifier: BSD-3-Clause
// On frames made by hand, whose truth is known, and on MuJoCo's world with and without noise.
#include "controller/estimator/leg_odometry.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/world/make_world.h"
#include "sim/world/mujoco_world.h"
#include "tests/support/hopper_scenario.h"
#include "tests/support/watched_controller.h"

namespace sidestep::leg_odometry_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr double kGravity_mps2 = 9.81;

RobotDescription Hopper() {
  return ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) /
                              "models/hopper/robot.yaml");
}

/// What the hopper feels at home: standing, or with `stands` false falling freely.
SensorFrame HomeFrame(bool stands) {
  SensorFrame frame;
  frame.joint_position = Eigen::Vector3d(0.0, 0.0, 0.15);
  frame.joint_velocity.setZero(3);
  frame.feet = {{stands ? 9.81 : 0.0}};
  frame.imu.accelerometer_mps2.z() = stands ? kGravity_mps2 : 0.0;
  return frame;
}

class LegOdometryTest : public testing::Test {
 protected:
  const RobotState& Feed(const SensorFrame& frame, int ticks) {
    for (int i = 0; i < ticks - 1; ++i) odometry_.Update(frame, &body_);
    return odometry_.Update(frame, &body_);
  }

  RigidBody body_{Hopper()};
  EstimatorParams params_;
  LegOdometry odometry_{Hopper(), params_, ExternalWrenchKnowledge::kUnknown, kTick_s, body_};
};

TEST_F(LegOdometryTest, StandingStillItStaysWhereItStarted) {
  const RobotState& state = Feed(HomeFrame(true), 2000);
  EXPECT_LT((state.p_WB - Eigen::Vector3d(0.0, 0.0, 0.515)).norm(), 1e-9);
  EXPECT_LT(state.v_WB.norm(), 1e-9);
  EXPECT_TRUE(state.feet[0].in_contact);
  EXPECT_LT((state.feet[0].p_WF - Eigen::Vector3d(0.0, 0.0, 0.015)).norm(), 1e-9);
}

TEST_F(LegOdometryTest, StandingFootFixesTheVelocityDespiteABiasedAccelerometer) {
  SensorFrame frame = HomeFrame(true);
  frame.imu.accelerometer_mps2.x() = 0.1;
  // Integrated alone, 2 s of it are 0.2 m/s and 0.2 m.
  const RobotState& state = Feed(frame, 2000);
  EXPECT_LT(std::abs(state.v_WB.x()), 0.02);
  EXPECT_LT(std::abs(state.p_WB.x()), 0.01);
}

TEST_F(LegOdometryTest, InFlightItIntegratesTheAccelerometer) {
  SensorFrame frame = HomeFrame(false);
  frame.imu.accelerometer_mps2 = {1.0, -0.5, 0.0};
  constexpr int kTicks = 300;
  const RobotState& state = Feed(frame, kTicks + 1);
  const double time_s = kTicks * kTick_s;
  const Eigen::Vector3d a(1.0, -0.5, -kGravity_mps2);
  EXPECT_LT((state.v_WB - a * time_s).norm(), 1e-9);
  const Eigen::Vector3d p = Eigen::Vector3d(0.0, 0.0, 0.515) + 0.5 * time_s * time_s * a;
  EXPECT_LT((state.p_WB - p).norm(), 1e-9);
  EXPECT_FALSE(state.feet[0].in_contact);
}

TEST_F(LegOdometryTest, AccelerometerIsTurnedIntoTheWorldByTheUnitsAttitude) {
  SensorFrame frame = HomeFrame(false);
  frame.imu.q_WU = Eigen::AngleAxisd(0.5 * 3.14159265358979, Eigen::Vector3d::UnitX());
  frame.imu.accelerometer_mps2 = {0.0, kGravity_mps2, 1.0};
  // By hand: a quarter turn about x takes y to z and z to -y.
  EXPECT_LT((Feed(frame, 101).v_WB - Eigen::Vector3d(0.0, -0.1, 0.0)).norm(), 1e-9);
}

TEST_F(LegOdometryTest, FirstFrameIsTheStartWhateverTheAccelerometerSays) {
  SensorFrame frame = HomeFrame(false);
  frame.imu.accelerometer_mps2 = {100.0, 0.0, 0.0};
  const RobotState& state = odometry_.Update(frame, &body_);
  EXPECT_LT((state.p_WB - Eigen::Vector3d(0.0, 0.0, 0.515)).norm(), 1e-12);
  EXPECT_LT(state.v_WB.norm(), 1e-12);
}

TEST_F(LegOdometryTest, VelocityErrorOfAFlightShrinksWithinAStance) {
  SensorFrame flight = HomeFrame(false);
  flight.imu.accelerometer_mps2 = {1.0, 0.0, kGravity_mps2};  // the truth does not move
  EXPECT_NEAR(Feed(flight, 201).v_WB.x(), 0.2, 1e-9);
  // Seventy times what the filter expects of its accelerometer: 0.2 * sqrt(200) ms.
  const double landed_m = Feed(HomeFrame(true), 1).p_WB.x();
  const RobotState& state = Feed(HomeFrame(true), 150);
  EXPECT_LT(std::abs(state.v_WB.x()), 0.05) << "three quarters are gone in a hop's stance";
  EXPECT_NEAR(state.p_WB.x(), landed_m, 0.02) << "a new foothold tells nothing of where it is";
}

TEST_F(LegOdometryTest, HeightErrorOfAFlightIsGoneSoonAfterTouchDown) {
  SensorFrame flight = HomeFrame(false);
  flight.imu.accelerometer_mps2 = {0.0, 0.0, kGravity_mps2 + 2.0};
  EXPECT_NEAR(Feed(flight, 201).p_WB.z(), 0.515 + 0.04, 1e-9);
  const RobotState& state = Feed(HomeFrame(true), 200);
  EXPECT_NEAR(state.p_WB.z(), 0.515, 0.004) << "the floor is known to 2 mm";
}

/// The hopper's believed height after 0.2 s in the air, in truth at rest where it started, and
/// `stance` frames on the ground, of which every one in `bounce` is not felt (0: all are).
double HeightAfterLanding_m(double floor_noise_m, double bias_mps2, double longer_m, int stance,
                            int bounce = 0) {
  RigidBody body(Hopper());
  EstimatorParams params;
  params.floor_noise_m = floor_noise_m;
  LegOdometry odometry(Hopper(), params, ExternalWrenchKnowledge::kUnknown, kTick_s, body);
  SensorFrame flight = HomeFrame(false);
  flight.imu.accelerometer_mps2.z() = kGravity_mps2 + bias_mps2;
  for (int i = 0; i <= 200; ++i) odometry.Update(flight, &body);
  SensorFrame landed = HomeFrame(true);
  landed.joint_position[2] += longer_m;  // the leg finds the ground so much lower
  for (int i = 1; i < stance; ++i) {
    landed.feet[0].normal_force_N = bounce > 0 && i % bounce == 0 ? 0.0 : 9.81;
    odometry.Update(landed, &body);
  }
  landed.feet[0].normal_force_N = 9.81;
  return odometry.Update(landed, &body).p_WB.z();
}

TEST(FloorHeightTest, ALandingWeighsTheFloorOnceByItsUncertainty) {
  // In closed form: height and velocity with the covariance of 201 predictions; then two
  // measurements of them, the height by the floor and the leg, the velocity by the leg.
  const EstimatorParams params;
  const double dt = kTick_s;
  const double step_mps = params.accelerometer_noise_mps2 * dt;
  Eigen::Matrix2d P = 1e-6 * Eigen::Matrix2d::Identity();
  Eigen::Matrix2d F;
  F << 1.0, dt, 0.0, 1.0;
  const Eigen::Vector2d Q(0.25 * step_mps * step_mps * dt * dt, step_mps * step_mps);
  for (int i = 0; i < 201; ++i)
    P = Eigen::Matrix2d(F * P * F.transpose()) + Eigen::Matrix2d(Q.asDiagonal());
  // 1 m/s^2 too much for 0.2 s, and one period more of the speed that this has given: two
  // deviations of the floor.
  const Eigen::Vector2d believed(0.515 + 0.5 * 1.0 * 0.04 + 1.0 * 0.2 * dt, 1.0 * 0.2);
  const Eigen::Vector2d measured(0.515, 0.0);
  const Eigen::Vector2d precision(
      1.0 / (0.01 * 0.01 + params.foot_position_noise_m * params.foot_position_noise_m),
      1.0 / (params.foot_velocity_noise_mps * params.foot_velocity_noise_mps));
  const Eigen::Matrix2d R_inverse = precision.asDiagonal();
  const Eigen::Matrix2d P_inverse = P.inverse();
  const Eigen::Vector2d after =
      (P_inverse + R_inverse).inverse() * (P_inverse * believed + R_inverse * measured);
  EXPECT_NEAR(HeightAfterLanding_m(0.01, 1.0, 0.0, 1), after[0], 1e-7);
}

TEST(FloorHeightTest, AFootThatFindsTheGroundLowerLearnsItsHeight) {
  // A level floor is a fact that lifts the belief. One that is known to 10 mm is worth 1 % against
  // the 1 mm to which a flight has left the height known.
  EXPECT_NEAR(HeightAfterLanding_m(0.0, 0.0, 0.04, 200), 0.515 + 0.04, 0.004);
  EXPECT_NEAR(HeightAfterLanding_m(0.01, 0.0, 0.04, 200), 0.515, 0.001);
}

TEST(FloorHeightTest, AHoleFarDeeperThanTheFloorIsKnownPullsNoHarderThanOneAtTheLimit) {
  // 10 cm and 20 cm are ten and twenty deviations of 1 cm; what counts is three of them.
  const double deep_m = HeightAfterLanding_m(0.01, 0.0, 0.1, 1) - 0.515;
  const double deeper_m = HeightAfterLanding_m(0.01, 0.0, 0.2, 1) - 0.515;
  const double at_limit_m = HeightAfterLanding_m(0.01, 0.0, 0.03, 1) - 0.515;
  EXPECT_GT(at_limit_m, 1e-5) << "else there is nothing to compare";
  EXPECT_NEAR(deep_m, at_limit_m, 0.05 * at_limit_m) << "but for what the height's own noise adds";
  EXPECT_NEAR(deeper_m, at_limit_m, 0.05 * at_limit_m);
}

TEST(FloorHeightTest, AFootThatBouncesIsToldOfItsFloorOnce) {
  // Of 100 frames a foot misses every tenth: ten landings on one foothold, 20 mm low.
  const double steady_m = HeightAfterLanding_m(0.01, 0.0, 0.02, 100) - 0.515;
  const double bouncing_m = HeightAfterLanding_m(0.01, 0.0, 0.02, 100, 10) - 0.515;
  EXPECT_GT(steady_m, 1e-5) << "the floor is told of";
  EXPECT_LT(bouncing_m, 2.0 * steady_m) << "ten times were ten times as much";
}

TEST(FloorHeightTest, LandingAfterLandingOnALevelFloorTheHeightComesBack) {
  RigidBody body(Hopper());
  EstimatorParams params;
  params.floor_noise_m = 0.01;
  LegOdometry odometry(Hopper(), params, ExternalWrenchKnowledge::kUnknown, kTick_s, body);
  // Hops whose flights the accelerometer takes for 0.2 mm higher each (0.5 * 0.04 * 0.1^2).
  SensorFrame flight = HomeFrame(false);
  flight.imu.accelerometer_mps2.z() = kGravity_mps2 + 0.04;
  double half_way_m = 0.0;
  double end_m = 0.0;
  for (int hop = 0; hop < 200; ++hop) {
    for (int i = 0; i < 100; ++i) odometry.Update(flight, &body);
    for (int i = 0; i < 200; ++i) odometry.Update(HomeFrame(true), &body);
    end_m = odometry.Update(HomeFrame(true), &body).p_WB.z() - 0.515;
    if (hop == 99) half_way_m = end_m;
  }
  EXPECT_LT(end_m, 200 * 0.0002 / 2) << "integrated alone they would be 40 mm";
  EXPECT_NEAR(end_m, half_way_m, 0.0005) << "the error does not grow";
}

TEST_F(LegOdometryTest, MovingJointsOfAStandingFootMoveTheBase) {
  SensorFrame frame = HomeFrame(true);
  constexpr double kSpeed_mps = 0.1;  // the leg grows
  frame.joint_velocity[2] = kSpeed_mps;
  for (int i = 0; i < 500; ++i) {
    frame.joint_position[2] = 0.15 + kSpeed_mps * kTick_s * i;
    odometry_.Update(frame, &body_);
  }
  const RobotState& state = odometry_.Update(frame, &body_);
  EXPECT_NEAR(state.v_WB.z(), kSpeed_mps, 0.005);
  EXPECT_NEAR(state.p_WB.z(), 0.515 + 0.05, 0.002);
}

/// Largest errors of the belief on a run of MuJoCo's world.
struct Errors {
  double height_m{0.0}, speed_mps{0.0}, drift_m{0.0}, com_m{0.0};
  int flight_ticks{0}, stance_ticks{0};

  void Add(const RobotState& state, const WorldTruth& truth) {
    const Eigen::Vector3d position = state.p_WB - truth.p_WB;
    height_m = std::max(height_m, std::abs(position.z()));
    drift_m = std::max(drift_m, position.head<2>().norm());
    speed_mps = std::max(speed_mps, (state.v_WB - truth.v_WB).norm());
    com_m = std::max(com_m, ((state.p_WC - truth.p_WC) - position).norm());
    ++(truth.feet[0].in_contact ? stance_ticks : flight_ticks);
  }
};

TEST(LegOdometryOnMujocoTest, TumblingFreelyItFollowsThePerfectSensors) {
  Scenario scenario = PlainHopper(10.0);
  scenario.pushes = {TrunkPush({2.0, 1.0, 0.0}, 0.0, 0.1, {0.1, 0.1, 0.2})};
  MujocoWorld world = MakeMujocoWorld(scenario);
  SensorSuite sensors = MakeSensorSuite(scenario, world.mass_kg());
  RigidBody body(scenario.robot);
  LegOdometry odometry(scenario.robot, scenario.control.estimation,
                       ExternalWrenchKnowledge::kUnknown, kTick_s, body);
  Errors errors;
  for (Tick tick = 0; tick <= 500; ++tick) {
    errors.Add(odometry.Update(sensors.Read(world.truth(), tick), &body), world.truth());
    world.Step(tick);
  }
  EXPECT_GT(world.truth().w_WB_B.norm(), 1.0) << "hardly a tumble";
  // A first-order integration of a turning acceleration.
  EXPECT_LT(errors.speed_mps, 0.02);
  EXPECT_LT(errors.drift_m, 0.01);
  EXPECT_LT(errors.height_m, 0.02);
}

Errors ErrorsInClosedLoop(double duration_s) {
  Errors errors;
  RunWatched(HoppingHopper(), duration_s,
             [&](const SensorFrame& frame, Controller* controller,
                 const WorldTruth& truth) -> const ControlTick& {
               const ControlTick& control = controller->Update(frame);
               errors.Add(control.state, truth);
               EXPECT_FALSE(truth.body_touches_ground);
               return control;
             });
  return errors;
}

TEST(LegOdometryOnMujocoTest, HoppingOnNoisySensorsItKeepsHeightAndVelocity) {
  const Errors errors = ErrorsInClosedLoop(2.0);
  EXPECT_GT(errors.flight_ticks, 300);
  EXPECT_GT(errors.stance_ticks, 300);
  // Measured 1.3 mm, 10 mm/s, 0.8 mm and 0.02 mm; the sensors' noise of 1 mrad and 5 mrad/s on an
  // arm of 0.5 m is 0.5 mm and 2.5 mm/s a frame.
  EXPECT_LT(errors.height_m, 0.004);
  EXPECT_LT(errors.speed_mps, 0.04);
  EXPECT_LT(errors.drift_m, 0.005) << "a random walk: nothing tells where the robot is";
  EXPECT_LT(errors.com_m, 0.0003) << "the CoM relative to the base comes from the encoders";
}

TEST(LegOdometryOnMujocoTest, StandingOnNoisySensorsItIsBetterStill) {
  const Errors errors = ErrorsInClosedLoop(0.45);
  EXPECT_LE(errors.flight_ticks, 1) << "no step has been taken at the start";
  EXPECT_LT(errors.height_m, 0.002);
  EXPECT_LT(errors.speed_mps, 0.02);
  EXPECT_LT(errors.drift_m, 0.001);
}

}  // namespace
}  // namespace sidestep::leg_odometry_test
