// SPDX-License-Identifier: BSD-3-Clause
// Errors of the sensors: noise, biases and the seed that they are drawn by.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/sensors/sensors_test_support.h"

namespace sidestep::sensor_noise_test {
namespace {

/// Mean and standard deviation of a reading, over `kSamples` frames of an unmoving world.
struct Spread {
  double mean{0.0}, deviation{0.0};
};

template <typename Reading>
Spread SpreadOf(const Scenario& scenario, Reading&& reading) {
  SensorSuite sensors = MakeSensorSuite(scenario, 1.0);
  double sum = 0.0, squares = 0.0;
  for (Tick tick = 0; tick < kSamples; ++tick) {
    const double value = reading(sensors.Read(Truth(), tick));
    sum += value;
    squares += value * value;
  }
  const double mean = sum / kSamples;
  return {mean, std::sqrt(squares / kSamples - mean * mean)};
}

void ExpectSpread(const Spread& spread, double mean, double deviation) {
  // Four standard errors: deviation / sqrt(n) of a mean, deviation / sqrt(2 n) of a deviation.
  EXPECT_NEAR(spread.mean, mean, 4.0 * deviation / std::sqrt(kSamples));
  EXPECT_NEAR(spread.deviation, deviation, 4.0 * deviation / std::sqrt(2.0 * kSamples));
}

TEST(SensorNoiseTest, SameSeedGivesTheSameNoiseAndAnotherSeedAnother) {
  SensorSuite first = MakeSensorSuite(Noisy(3), 1.0), second = MakeSensorSuite(Noisy(3), 1.0),
              other = MakeSensorSuite(Noisy(4), 1.0);
  for (Tick tick = 0; tick < 20; ++tick) {
    const SensorFrame a = first.Read(Truth(), tick);
    const SensorFrame b = second.Read(Truth(), tick);
    const SensorFrame c = other.Read(Truth(), tick);
    EXPECT_EQ(a.imu.gyro_radps, b.imu.gyro_radps);
    EXPECT_EQ(a.imu.q_WU.coeffs(), b.imu.q_WU.coeffs());
    EXPECT_EQ(a.joint_velocity, b.joint_velocity);
    EXPECT_EQ(a.feet[0].normal_force_N, b.feet[0].normal_force_N);
    EXPECT_NE(a.imu.gyro_radps, c.imu.gyro_radps);
  }
}

TEST(SensorNoiseTest, NoiseHasTheDeviationOfItsSetting) {
  ExpectSpread(SpreadOf(Noisy(), [](const SensorFrame& f) { return f.imu.gyro_radps.y(); }), 0.8,
               0.01);
  ExpectSpread(SpreadOf(Noisy(), [](const SensorFrame& f) { return f.imu.accelerometer_mps2.z(); }),
               9.8, 0.2);
  ExpectSpread(SpreadOf(Noisy(), [](const SensorFrame& f) { return f.joint_position[1]; }), -0.5,
               0.001);
  ExpectSpread(SpreadOf(Noisy(), [](const SensorFrame& f) { return f.joint_velocity[0]; }), 1.5,
               0.05);
  ExpectSpread(SpreadOf(Noisy(), [](const SensorFrame& f) { return f.feet[0].normal_force_N; }),
               12.0, 0.3);
  ExpectSpread(
      SpreadOf(Noisy(), [](const SensorFrame& f) { return f.force_torque[1].force_N.z(); }), 30.0,
      0.7);
  ExpectSpread(
      SpreadOf(Noisy(), [](const SensorFrame& f) { return f.force_torque[0].torque_Nm.x(); }), 0.1,
      0.04);
  const auto tilt_rad = [](const SensorFrame& f) {
    return 2.0 * (Truth().imu.q_WU.conjugate() * f.imu.q_WU).y();
  };
  ExpectSpread(SpreadOf(Noisy(), tilt_rad), 0.0, 0.002);
}

TEST(SensorNoiseTest, TouchIsNeverNegative) {
  Scenario scenario = Noisy();
  SensorSuite sensors = MakeSensorSuite(scenario, 1.0);
  WorldTruth truth = Truth();
  truth.feet[0].touch_N = 0.0;
  bool felt = false;
  for (Tick tick = 0; tick < 200; ++tick) {
    const double force_N = sensors.Read(truth, tick).feet[0].normal_force_N;
    EXPECT_GE(force_N, 0.0);
    felt = felt || force_N > 0.0;
  }
  EXPECT_TRUE(felt) << "there was no noise";
}

TEST(SensorNoiseTest, BiasesAreAddedEveryTime) {
  Scenario scenario = Quiet();
  scenario.sensors.force_bias_N = {1.0, -2.0, 4.0};
  scenario.sensors.gyro_bias_radps = {0.25, 0.5, -0.125};
  scenario.sensors.accelerometer_bias_mps2 = {-0.5, 0.25, 0.125};
  SensorSuite sensors = MakeSensorSuite(scenario, 1.0);
  const WorldTruth truth = Truth();
  for (Tick tick = 0; tick < 3; ++tick) {
    const SensorFrame frame = sensors.Read(truth, tick);
    EXPECT_EQ(frame.imu.gyro_radps, truth.imu.gyro_radps + scenario.sensors.gyro_bias_radps);
    EXPECT_EQ(frame.imu.accelerometer_mps2,
              truth.imu.accelerometer_mps2 + scenario.sensors.accelerometer_bias_mps2);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(frame.force_torque[i].force_N,
                truth.force_torque[i].force_N + scenario.sensors.force_bias_N);
      EXPECT_EQ(frame.force_torque[i].torque_Nm, truth.force_torque[i].torque_Nm);
    }
  }
}

TEST(SensorNoiseTest, EncoderBiasIsOneDrawAJointAndSeed) {
  const auto bias_of = [](std::uint64_t seed, int joints, Tick tick) {
    Scenario scenario = Quiet();
    scenario.seed = seed;
    scenario.sensors.encoder_bias_rad = 0.02;
    WorldTruth truth = Truth();
    truth.joint_position = truth.joint_velocity = Eigen::VectorXd::Zero(joints);
    SensorSuite sensors = MakeSensorSuite(scenario, 1.0);
    for (Tick before = 0; before < tick; ++before) sensors.Read(truth, before);
    const SensorFrame frame = sensors.Read(truth, tick);
    EXPECT_EQ(frame.joint_velocity, truth.joint_velocity) << "of the position only";
    return frame.joint_position;
  };
  EXPECT_EQ(bias_of(3, 5, 0), bias_of(3, 5, 7)) << "constant";
  EXPECT_NE(bias_of(3, 5, 0), bias_of(4, 5, 0));
  const Eigen::VectorXd many = bias_of(3, kSamples, 0);
  ExpectSpread({many.mean(), std::sqrt(many.squaredNorm() / kSamples)}, 0.0, 0.02);
}

TEST(SensorNoiseTest, NewErrorsLeaveTheDrawsOfTheOldOnesAlone) {
  Scenario biased = Noisy();
  biased.sensors.encoder_bias_rad = 0.02;
  biased.sensors.gyro_bias_radps = {0.5, 0.5, 0.5};
  SensorSuite sensors = MakeSensorSuite(Noisy(), 1.0), with_biases = MakeSensorSuite(biased, 1.0);
  for (Tick tick = 0; tick < 20; ++tick) {
    const SensorFrame a = sensors.Read(Truth(), tick);
    const SensorFrame b = with_biases.Read(Truth(), tick);
    EXPECT_EQ(a.imu.q_WU.coeffs(), b.imu.q_WU.coeffs());
    EXPECT_EQ(a.imu.accelerometer_mps2, b.imu.accelerometer_mps2);
    EXPECT_EQ(a.joint_velocity, b.joint_velocity);
    EXPECT_EQ(a.feet[0].normal_force_N, b.feet[0].normal_force_N);
  }
}

}  // namespace
}  // namespace sidestep::sensor_noise_test
