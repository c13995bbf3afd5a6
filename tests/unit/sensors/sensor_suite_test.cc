// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sensors/sensor_suite.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/scenario/scenario.h"

namespace sidestep::sensor_suite_test {
namespace {

constexpr double kRate_hz = 1000.0;

Scenario Quiet() {
  Scenario scenario;
  scenario.control.rate_hz = kRate_hz;
  scenario.robot.feet.resize(1);
  return scenario;
}

Scenario Noisy(std::uint64_t seed = 1) {
  Scenario scenario = Quiet();
  scenario.seed = seed;
  scenario.sensors.gyro_noise_radps = 0.01;
  scenario.sensors.accelerometer_noise_mps2 = 0.2;
  scenario.sensors.orientation_noise_rad = 0.002;
  scenario.sensors.encoder_noise_rad = 0.001;
  scenario.sensors.encoder_velocity_noise_radps = 0.05;
  scenario.sensors.touch_noise_N = 0.3;
  scenario.sensors.force_noise_N = 0.7;
  scenario.sensors.torque_noise_Nm = 0.04;
  return scenario;
}

/// A robot with two joints and a foot, where nothing is zero; `mark` tells instants apart.
WorldTruth Truth(double mark = 0.0) {
  WorldTruth truth;
  truth.p_WB = {1.0 + mark, 2.0, 3.0};
  truth.q_WB = Eigen::Quaterniond(0.8, 0.0, 0.6, 0.0);
  truth.v_WB = {0.1, 0.2, 0.3};
  truth.w_WB_B = {0.4, 0.5, 0.6};
  truth.p_WC = {1.1, 2.0, 3.2};
  truth.v_WC = {0.2, 0.3, 0.4};
  truth.angular_momentum = {0.01, 0.02, 0.03};
  truth.joint_position = Eigen::Vector2d(0.5 + mark, -0.5);
  truth.joint_velocity = Eigen::Vector2d(1.5, -2.5);
  truth.imu.q_WU = Eigen::Quaterniond(0.6, 0.8, 0.0, 0.0);
  truth.imu.gyro_radps = {0.7, 0.8, 0.9};
  truth.imu.accelerometer_mps2 = {0.1, 0.2, 9.8};
  truth.feet.resize(1);
  truth.feet[0].touch_N = 12.0;
  truth.feet[0].p_WF = {0.9, 2.1, 0.0};
  truth.force_torque = {{{1.0 + mark, 2.0, 3.0}, {0.1, 0.2, 0.3}},
                        {{-1.0, -2.0, 30.0}, {-0.1, -0.2, -0.3}}};
  truth.pushes = {{{0.0, 10.0, 0.0}, {1.1, 2.0, 3.7}}, {{3.0, 0.0, 0.0}, {1.1, 2.5, 3.2}}};
  return truth;
}

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

TEST(SensorSuiteTest, SameSeedGivesTheSameNoiseAndAnotherSeedAnother) {
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

/// Mean and standard deviation of a reading, over `kSamples` frames of an unmoving world.
struct Spread {
  double mean{0.0}, deviation{0.0};
};
constexpr int kSamples = 4000;

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

TEST(SensorSuiteTest, NoiseHasTheDeviationOfItsSetting) {
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

TEST(SensorSuiteTest, TouchIsNeverNegative) {
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

TEST(SensorSuiteTest, FramesAreAsOldAsTheDelay) {
  Scenario scenario = Quiet();
  scenario.sensors.delay_s = 0.003;
  SensorSuite sensors = MakeSensorSuite(scenario, 1.0);
  for (Tick tick = 0; tick < 20; ++tick) {
    const SensorFrame frame = sensors.Read(Truth(static_cast<double>(tick)), tick);
    const Tick measured = std::max<Tick>(0, tick - 3);
    EXPECT_EQ(frame.joint_position[0], 0.5 + static_cast<double>(measured)) << tick;
    EXPECT_EQ(frame.tick, tick) << "a frame is stamped when it arrives";
  }
}

TEST(SensorSuiteTest, BiasesAreAddedEveryTime) {
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

TEST(SensorSuiteTest, EncoderBiasIsOneDrawAJointAndSeed) {
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

TEST(SensorSuiteTest, NewErrorsLeaveTheDrawsOfTheOldOnesAlone) {
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

TEST(SensorSuiteTest, WrenchesAreOlderThanTheRestByTheirOwnDelay) {
  Scenario scenario = Quiet();
  scenario.sensors.delay_s = 0.002;
  scenario.sensors.wrench_delay_s = 0.003;
  SensorSuite sensors = MakeSensorSuite(scenario, 1.0);
  for (Tick tick = 0; tick < 20; ++tick) {
    const SensorFrame frame = sensors.Read(Truth(static_cast<double>(tick)), tick);
    EXPECT_EQ(frame.joint_position[0], 0.5 + static_cast<double>(std::max<Tick>(0, tick - 2)));
    EXPECT_EQ(frame.force_torque[0].force_N.x(),
              1.0 + static_cast<double>(std::max<Tick>(0, tick - 5)));
    const Tick sampled = std::max<Tick>(0, tick - 2);  // there is nothing older at first
    EXPECT_EQ(frame.force_torque_age_s, static_cast<double>(std::min<Tick>(sampled, 3)) / 1000.0);
  }
}

TEST(SensorSuiteTest, DropoutRepeatsTheLastFrameAsOftenAsItsProbability) {
  Scenario scenario = Quiet();
  scenario.sensors.dropout = 0.3;
  SensorSuite sensors = MakeSensorSuite(scenario, 1.0);
  int repeats = 0;
  double last = sensors.Read(Truth(0.0), 0).joint_position[0];
  EXPECT_EQ(last, 0.5) << "the first frame never drops";
  for (Tick tick = 1; tick <= kSamples; ++tick) {
    const SensorFrame frame = sensors.Read(Truth(static_cast<double>(tick)), tick);
    const double now = frame.joint_position[0];
    const bool repeated = now == last;
    EXPECT_TRUE(repeated || now == 0.5 + static_cast<double>(tick)) << "neither old nor new";
    EXPECT_EQ(frame.tick, tick);
    repeats += repeated ? 1 : 0;
    last = now;
  }
  // Four standard deviations of a binomial share.
  EXPECT_NEAR(static_cast<double>(repeats) / kSamples, 0.3, 4.0 * std::sqrt(0.3 * 0.7 / kSamples));
}

}  // namespace
}  // namespace sidestep::sensor_suite_test
