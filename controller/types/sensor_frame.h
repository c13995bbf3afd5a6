// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sensor_frame: all that crosses from the world to the controller. Nothing else does.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "controller/types/tick.h"
#include "controller/types/wrench.h"

namespace sidestep {

/// Inertial unit at site U. Orientation is the unit's own attitude filter's output.
struct ImuSample {
  Eigen::Quaterniond q_WU{Eigen::Quaterniond::Identity()};
  Eigen::Vector3d gyro_radps{Eigen::Vector3d::Zero()};  ///< w_WU_U.
  /// Specific force, in U; the mean over the period that ends now, which is what the unit's delta
  /// velocity is over it.
  Eigen::Vector3d accelerometer_mps2{Eigen::Vector3d::Zero()};
};

/// What a foot with a touch sensor feels.
struct FootSample {
  double normal_force_N{0.0};  ///< >= 0, from the touch sensor under the sole; 0 without one.
};

/// State of the whole robot as the simulator has it; present only under `estimator: truth`.
struct TruthSample {
  Eigen::Vector3d p_WB{Eigen::Vector3d::Zero()};
  Eigen::Quaterniond q_WB{Eigen::Quaterniond::Identity()};
  Eigen::Vector3d v_WB{Eigen::Vector3d::Zero()};    ///< Of B's origin, in W.
  Eigen::Vector3d w_WB_B{Eigen::Vector3d::Zero()};  ///< In B.
};

/// Direct measurement of the reduced state; present only on the centroidal plant.
struct CentroidalSample {
  Eigen::Vector3d p_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d linear_momentum{Eigen::Vector3d::Zero()};   ///< kg m/s.
  Eigen::Vector3d angular_momentum{Eigen::Vector3d::Zero()};  ///< kg m^2/s about C, in W.
  std::vector<Eigen::Vector3d> p_WF;                          ///< One a foot.
};

/// One reading of every sensor. Joint vectors are in the order of the actuators.
struct SensorFrame {
  Tick tick{0};
  ImuSample imu;
  Eigen::VectorXd joint_position;  ///< rad, or m for a slide.
  Eigen::VectorXd joint_velocity;  ///< rad/s or m/s.
  std::vector<FootSample> feet;
  /// One a force/torque sensor of the robot: what its distal part does to its proximal part, in the
  /// sensor's site, about its origin; the mean over the period that ends now, as the sensor's own
  /// filter against aliasing makes it. May be older than the rest (sensors.wrench_delay_s).
  std::vector<Wrench> force_torque;
  double force_torque_age_s{0.0};  ///< By how much, as its time stamp tells.
  std::optional<TruthSample> truth;
  std::optional<CentroidalSample> centroidal;
  /// The push acting now, about the CoM, in W; present only under `external_wrench: known`.
  std::optional<Wrench> known_external_wrench;
};

}  // namespace sidestep
