// SPDX-License-Identifier: BSD-3-Clause
// The belief of a robot in a plane never leaves it, and is as good along it as of any other robot.
#include <gtest/gtest.h>

#include <cmath>

#include "controller/estimator/leg_odometry.h"
#include "controller/estimator/truth_estimator.h"
#include "sim/scenario/read_scenario.h"
#include "tests/support/watched_controller.h"

namespace sidestep::planar_odometry_test {
namespace {

constexpr double kTick_s = 0.001;

RobotDescription Rabbit() {
  return ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) /
                              "models/rabbit/robot.yaml");
}

Scenario RabbitWalk(const std::vector<std::string>& overrides = {}) {
  return ReadScenario(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios/rabbit_walk.yaml",
                      overrides);
}

void ExpectInPlane(const RobotState& state) {
  EXPECT_EQ(state.p_WB.y(), 0.0);
  EXPECT_EQ(state.v_WB.y(), 0.0);
  EXPECT_EQ(state.q_WB.x(), 0.0);
  EXPECT_EQ(state.q_WB.z(), 0.0);
  EXPECT_EQ(state.w_WB_B.x(), 0.0);
  EXPECT_EQ(state.w_WB_B.z(), 0.0);
  EXPECT_EQ(state.p_WC.y(), 0.0);
  EXPECT_EQ(state.v_WC.y(), 0.0);
  EXPECT_EQ(state.angular_momentum.x(), 0.0);
  EXPECT_EQ(state.angular_momentum.z(), 0.0);
  EXPECT_EQ(state.external_wrench.force_N.y(), 0.0);
  EXPECT_EQ(state.external_wrench.torque_Nm.x(), 0.0);
  EXPECT_EQ(state.external_wrench.torque_Nm.z(), 0.0);
  for (std::size_t i = 0; i < state.feet.size(); ++i) {
    EXPECT_NEAR(state.feet[i].p_WF.y(), i == 0 ? 0.06 : -0.06, 1e-12);
  }
}

/// Standing at home, feeling what comes from outside the plane.
SensorFrame DisturbedFrame(const RigidBody& body) {
  RobotState home;
  body.WriteHome(&home);
  SensorFrame frame;
  frame.joint_position = home.joint_position;
  frame.joint_velocity.setZero(4);
  frame.feet = {{200.0}, {200.0}};
  frame.imu.q_WU = Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(-0.01, Eigen::Vector3d::UnitX());
  frame.imu.gyro_radps = {0.3, 0.0, -0.4};
  frame.imu.accelerometer_mps2 = {0.0, 0.5, 9.81};
  frame.known_external_wrench = Wrench{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  return frame;
}

TEST(PlanarOdometryTest, WhatSensorsSayAcrossThePlaneIsLeftOut) {
  RigidBody body{Rabbit()};
  LegOdometry odometry(Rabbit(), {}, ExternalWrenchKnowledge::kKnown, kTick_s, body);
  const SensorFrame frame = DisturbedFrame(body);
  for (int i = 0; i < 200; ++i) ExpectInPlane(odometry.Update(frame, &body));
  const RobotState& state = odometry.Update(frame, &body);
  EXPECT_NEAR(state.p_WB.z(), 0.72985, 5e-4) << "the floor is a little higher than its feet";
  EXPECT_LT(std::abs(state.v_WB.x()), 0.01);
  EXPECT_EQ(state.external_wrench.force_N, Eigen::Vector3d(1.0, 0.0, 3.0));
  EXPECT_EQ(state.external_wrench.torque_Nm, Eigen::Vector3d(0.0, 5.0, 0.0));
}

TEST(PlanarOdometryTest, PitchAndItsRateAreTheImus) {
  RigidBody body{Rabbit()};
  LegOdometry odometry(Rabbit(), {}, ExternalWrenchKnowledge::kUnknown, kTick_s, body);
  SensorFrame frame = DisturbedFrame(body);
  frame.imu.q_WU = Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitY());
  frame.imu.gyro_radps.y() = -0.7;
  const RobotState& state = odometry.Update(frame, &body);
  EXPECT_NEAR(2.0 * std::atan2(state.q_WB.y(), state.q_WB.w()), 0.2, 1e-12);
  EXPECT_EQ(state.w_WB_B, Eigen::Vector3d(0.0, -0.7, 0.0));
}

TEST(PlanarOdometryTest, ATruthThatIsToldIsInThePlaneTooAndSoIsAKnownPush) {
  RigidBody body{Rabbit()};
  TruthEstimator estimator(Rabbit(), {}, ExternalWrenchKnowledge::kKnown, kTick_s, body);
  SensorFrame frame = DisturbedFrame(body);
  frame.truth = TruthSample{};
  frame.truth->p_WB = {0.3, 0.1, 0.8};
  ExpectInPlane(estimator.Update(frame, &body));
}

TEST(PlanarOdometryOnMujocoTest, WalkingOnNoisySensorsItKeepsHeightAndVelocity) {
  double height_m = 0.0, speed_mps = 0.0, yaw_momentum = 0.0;
  RunWatched(RabbitWalk(), 4.0,
             [&](const SensorFrame& frame, Controller* controller,
                 const WorldTruth& truth) -> const ControlTick& {
               const ControlTick& tick = controller->Update(frame);
               ExpectInPlane(tick.state);
               height_m = std::max(height_m, std::abs(tick.state.p_WB.z() - truth.p_WB.z()));
               speed_mps = std::max(speed_mps, (tick.state.v_WB - truth.v_WB).norm());
               yaw_momentum = std::max(yaw_momentum, std::abs(truth.angular_momentum.z()));
               return tick;
             });
  // Noise of 1 mrad and 5 mrad/s on a leg of 0.7 m is 0.7 mm and 3.5 mm/s a frame.
  EXPECT_LT(height_m, 0.005);
  EXPECT_LT(speed_mps, 0.1);
  EXPECT_GT(yaw_momentum, 0.1) << "legs side by side have it; the plane bears it";
}

}  // namespace
}  // namespace sidestep::planar_odometry_test
