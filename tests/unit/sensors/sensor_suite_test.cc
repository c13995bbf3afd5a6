// SPDX-License-Identifier: BSD-3-Clause
// What sensors read of the truth, and what a frame tells beside.
#include <gtest/gtest.h>

#include "tests/unit/sensors/sensors_test_support.h"

namespace sidestep::sensor_suite_test {
namespace {

TEST(SensorSuiteTest, WithoutNoiseSensorsReadTheTruth) {
  SensorSuite sensors = MakeSensorSuite(Quiet(), 1.0);
  const WorldTruth truth = Truth();
  const SensorFrame frame = sensors.Read(truth, 7);
  EXPECT_EQ(frame.tick, 7);
  EXPECT_LT(frame.imu.q_WU.angularDistance(truth.imu.q_WU), 1e-7);
  EXPECT_EQ(frame.imu.gyro_radps, truth.imu.gyro_radps);
  EXPECT_EQ(frame.imu.accelerometer_mps2, truth.imu.accelerometer_mps2);
  EXPECT_EQ(frame.joint_position, truth.joint_position);
  EXPECT_EQ(frame.joint_velocity, truth.joint_velocity);
  ASSERT_EQ(frame.feet.size(), 1U);
  EXPECT_EQ(frame.feet[0].normal_force_N, 12.0);
  ASSERT_EQ(frame.force_torque.size(), 2U);
  EXPECT_EQ(frame.force_torque[1].force_N, truth.force_torque[1].force_N);
  EXPECT_EQ(frame.force_torque[1].torque_Nm, truth.force_torque[1].torque_Nm);
}

TEST(SensorSuiteTest, FootWithForceTorqueSensorsHasNoTouch) {
  Scenario scenario = Noisy();
  scenario.robot.feet[0].force_torque = {"ankle_ft"};
  EXPECT_EQ(MakeSensorSuite(scenario, 1.0).Read(Truth(), 0).feet[0].normal_force_N, 0.0);
}

TEST(SensorSuiteTest, TruthCentroidalStateAndPushAreToldOnlyWhenAskedFor) {
  SensorFrame frame = MakeSensorSuite(Quiet(), 1.0).Read(Truth(), 0);
  EXPECT_FALSE(frame.truth || frame.centroidal || frame.known_external_wrench);

  Scenario scenario = Quiet();
  scenario.control.estimator = EstimatorKind::kTruth;
  frame = MakeSensorSuite(scenario, 1.0).Read(Truth(), 0);
  ASSERT_TRUE(frame.truth);
  EXPECT_FALSE(frame.centroidal || frame.known_external_wrench);
  EXPECT_EQ(frame.truth->p_WB, Truth().p_WB);
  EXPECT_EQ(frame.truth->q_WB.coeffs(), Truth().q_WB.coeffs());
  EXPECT_EQ(frame.truth->v_WB, Truth().v_WB);
  EXPECT_EQ(frame.truth->w_WB_B, Truth().w_WB_B);

  scenario = Quiet();
  scenario.plant = Plant::kCentroidal;
  frame = MakeSensorSuite(scenario, 2.0).Read(Truth(), 0);
  ASSERT_TRUE(frame.centroidal);
  EXPECT_FALSE(frame.truth || frame.known_external_wrench);
  EXPECT_EQ(frame.centroidal->p_WC, Truth().p_WC);
  EXPECT_EQ(frame.centroidal->linear_momentum, 2.0 * Truth().v_WC);
  EXPECT_EQ(frame.centroidal->angular_momentum, Truth().angular_momentum);
  EXPECT_EQ(frame.centroidal->p_WF[0], Truth().feet[0].p_WF);

  scenario = Quiet();
  scenario.control.external_wrench = ExternalWrenchKnowledge::kKnown;
  frame = MakeSensorSuite(scenario, 1.0).Read(Truth(), 0);
  EXPECT_TRUE(frame.known_external_wrench);
  EXPECT_FALSE(frame.truth || frame.centroidal);
}

TEST(SensorSuiteTest, KnownPushIsTheSumOfPushesAboutTheCom) {
  Scenario scenario = Quiet();
  scenario.control.external_wrench = ExternalWrenchKnowledge::kKnown;
  const SensorFrame frame = MakeSensorSuite(scenario, 1.0).Read(Truth(), 0);
  EXPECT_EQ(frame.known_external_wrench->force_N, Eigen::Vector3d(3.0, 10.0, 0.0));
  // By hand: (0, 0, 0.5) x (0, 10, 0) + (0, 0.5, 0) x (3, 0, 0).
  const Eigen::Vector3d torque_Nm(-5.0, 0.0, -1.5);
  EXPECT_LT((frame.known_external_wrench->torque_Nm - torque_Nm).norm(), 1e-12);
}

}  // namespace
}  // namespace sidestep::sensor_suite_test
