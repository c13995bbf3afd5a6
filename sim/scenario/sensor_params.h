// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sensor_params: what a scenario says of the sensors' errors.

#include <Eigen/Core>

#include "controller/types/field.h"

namespace sidestep {

/// Errors of the sensors: noise (standard deviations, drawn anew each frame), biases (constant),
/// delay and dropout.
/// The truth passes in this order: bias and noise on each reading, then delay, then dropout; the
/// controller sees the outcome and never these numbers (EstimatorParams is what it assumes). All
/// draws come from one stream of the scenario's seed, and a deviation of 0 draws nothing, so that
/// adding one kind of noise shifts the numbers that the others get. Delays are rounded to whole
/// control periods. All are 0 by default: perfect sensors.
struct SensorParams {
  double gyro_noise_radps{0.0};  ///< White; no random walk.
  double accelerometer_noise_mps2{0.0};
  double orientation_noise_rad{0.0};  ///< About each axis of U.
  double encoder_noise_rad{0.0};
  double encoder_velocity_noise_radps{0.0};  ///< Independent of encoder_noise_rad.
  double touch_noise_N{0.0};                 ///< The sum is cut at 0: soles only push.
  double delay_s{0.0};                       ///< Of the whole frame.
  double dropout{0.0};                       ///< Drawn frame by frame, independently.
  double force_noise_N{0.0};                 ///< On the mean over the control period.
  double torque_noise_Nm{0.0};               ///< Likewise; torques have no bias.
  Eigen::Vector3d force_bias_N{Eigen::Vector3d::Zero()};
  Eigen::Vector3d gyro_bias_radps{Eigen::Vector3d::Zero()};
  Eigen::Vector3d accelerometer_bias_mps2{Eigen::Vector3d::Zero()};
  double encoder_bias_rad{0.0};  ///< Drawn once, from a stream of its own.
  double wrench_delay_s{0.0};    ///< Told as SensorFrame::force_torque_age_s.

  template <typename Self, typename Visitor>
  static void VisitFields(Self& self, Visitor&& visit) {
    visit("gyro_noise_radps", self.gyro_noise_radps, Range{0.0, 10.0},
          "standard deviation of the gyro, per axis and frame");
    visit("accelerometer_noise_mps2", self.accelerometer_noise_mps2, Range{0.0, 100.0},
          "standard deviation of the accelerometer, per axis and frame");
    visit("orientation_noise_rad", self.orientation_noise_rad, Range{0.0, 1.0},
          "standard deviation of the IMU's orientation");
    visit("encoder_noise_rad", self.encoder_noise_rad, Range{0.0, 1.0},
          "standard deviation of a joint position (of a slide: in m)");
    visit("encoder_velocity_noise_radps", self.encoder_velocity_noise_radps, Range{0.0, 10.0},
          "standard deviation of a joint velocity (of a slide: in m/s)");
    visit("touch_noise_N", self.touch_noise_N, Range{0.0, 100.0},
          "standard deviation of the touch sensors");
    visit("delay_s", self.delay_s, Range{0.0, 0.1}, "age of a frame when the controller sees it");
    visit("dropout", self.dropout, Range{0.0, 0.9},
          "probability that a frame repeats the last one");
    visit("force_noise_N", self.force_noise_N, Range{0.0, 100.0},
          "standard deviation of the forces of force/torque sensors, per axis");
    visit("torque_noise_Nm", self.torque_noise_Nm, Range{0.0, 100.0},
          "standard deviation of the torques of force/torque sensors, per axis");
    visit("force_bias_N", self.force_bias_N, Range{-100.0, 100.0},
          "added to every force/torque sensor, in its own axes");
    visit("gyro_bias_radps", self.gyro_bias_radps, Range{-1.0, 1.0},
          "added to the gyro, in its own axes");
    visit("accelerometer_bias_mps2", self.accelerometer_bias_mps2, Range{-10.0, 10.0},
          "added to the accelerometer, in its own axes");
    visit(
        "encoder_bias_rad", self.encoder_bias_rad, Range{0.0, 0.1},
        "standard deviation of the encoders' constant errors, one a joint, which the seed decides");
    visit("wrench_delay_s", self.wrench_delay_s, Range{0.0, 0.1},
          "age of the force/torque readings beyond delay_s");
  }
};

}  // namespace sidestep
