// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sensors_test_support: a truth for sensors to read, and sensors with and without noise.

#include <cstdint>

#include "sim/scenario/scenario.h"
#include "sim/sensors/sensor_suite.h"

namespace sidestep {

inline constexpr double kSensorRate_hz = 1000.0;

/// Sensors without errors, on one foot.
inline Scenario Quiet() {
  Scenario scenario;
  scenario.control.rate_hz = kSensorRate_hz;
  scenario.robot.feet.resize(1);
  return scenario;
}

/// The same with every noise.
inline Scenario Noisy(std::uint64_t seed = 1) {
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
inline WorldTruth Truth(double mark = 0.0) {
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

inline constexpr int kSamples = 4000;  ///< For figures of chance.

}  // namespace sidestep
