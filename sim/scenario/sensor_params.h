// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sensor_params: what a scenario says of the sensors' errors.

#include <Eigen/Core>

#include "controller/types/field.h"

namespace sidestep {

/// Errors of the sensors: noise (standard deviations, drawn anew each frame), biases (constant),
/// delay and dropout.
struct SensorParams {
  double gyro_noise_radps{0.0};
  double accelerometer_noise_mps2{0.0};
  double orientation_noise_rad{0.0};
  double encoder_noise_rad{0.0};  ///< Per joint; m for a slide.
  double encoder_velocity_noise_radps{0.0};
  double touch_noise_N{0.0};
  double delay_s{0.0};        ///< Age of a frame when the controller sees it.
  double dropout{0.0};        ///< Probability that a frame repeats the last one.
  double force_noise_N{0.0};  ///< Of the force/torque sensors, per axis.
  double torque_noise_Nm{0.0};
  /// Added to every force/torque sensor, in its own axes (N).
  Eigen::Vector3d force_bias_N{Eigen::Vector3d::Zero()};
  Eigen::Vector3d gyro_bias_radps{Eigen::Vector3d::Zero()};
  Eigen::Vector3d accelerometer_bias_mps2{Eigen::Vector3d::Zero()};
  /// Standard deviation of the encoders' constant errors, one a joint, which the seed decides.
  double encoder_bias_rad{0.0};
  double wrench_delay_s{0.0};  ///< Age of the force/torque readings beyond delay_s.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("gyro_noise_radps", self.gyro_noise_radps, Range{0.0, 10.0});
    visit("accelerometer_noise_mps2", self.accelerometer_noise_mps2, Range{0.0, 100.0});
    visit("orientation_noise_rad", self.orientation_noise_rad, Range{0.0, 1.0});
    visit("encoder_noise_rad", self.encoder_noise_rad, Range{0.0, 1.0});
    visit("encoder_velocity_noise_radps", self.encoder_velocity_noise_radps, Range{0.0, 10.0});
    visit("touch_noise_N", self.touch_noise_N, Range{0.0, 100.0});
    visit("delay_s", self.delay_s, Range{0.0, 0.1});
    visit("dropout", self.dropout, Range{0.0, 0.9});
    visit("force_noise_N", self.force_noise_N, Range{0.0, 100.0});
    visit("torque_noise_Nm", self.torque_noise_Nm, Range{0.0, 100.0});
    visit("force_bias_N", self.force_bias_N, Range{-100.0, 100.0});
    visit("gyro_bias_radps", self.gyro_bias_radps, Range{-1.0, 1.0});
    visit("accelerometer_bias_mps2", self.accelerometer_bias_mps2, Range{-10.0, 10.0});
    visit("encoder_bias_rad", self.encoder_bias_rad, Range{0.0, 0.1});
    visit("wrench_delay_s", self.wrench_delay_s, Range{0.0, 0.1});
  }
};

}  // namespace sidestep
