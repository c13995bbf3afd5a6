// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// all_numbers: every number of a truth or a frame, to compare runs bit for bit.
//
// Structured bindings name the members: a new one that is not listed here does not compile.

#include <cstring>
#include <optional>
#include <vector>

#include "controller/types/sensor_frame.h"
#include "sim/world/world.h"

namespace sidestep {

using Numbers = std::vector<double>;

/// True if both have the same numbers to the last bit: a NaN equals itself, 0 is not -0.
inline bool SameBits(const Numbers& left, const Numbers& right) {
  return left.size() == right.size() &&
         std::memcmp(left.data(), right.data(), left.size() * sizeof(double)) == 0;
}

/// Takes down values of every kind that a truth or a frame holds.
class NumberCollector {
 public:
  /// Each of `parts`, in their order.
  template <typename... Parts>
  void AddAll(const Parts&... parts) {
    (Add(parts), ...);
  }

  const Numbers& numbers() const { return numbers_; }

 private:
  void Add(double number) { numbers_.push_back(number); }
  void Add(bool flag) { numbers_.push_back(flag ? 1.0 : 0.0); }
  void Add(int number) { numbers_.push_back(number); }
  void Add(Tick tick) { numbers_.push_back(static_cast<double>(tick)); }

  template <typename Derived>
  void Add(const Eigen::MatrixBase<Derived>& matrix) {
    numbers_.push_back(static_cast<double>(matrix.size()));
    for (const double number : matrix.reshaped()) numbers_.push_back(number);
  }
  void Add(const Eigen::Quaterniond& q) { Add(q.coeffs()); }

  template <typename Part>
  void Add(const std::vector<Part>& parts) {
    numbers_.push_back(static_cast<double>(parts.size()));
    for (const Part& part : parts) Add(part);
  }
  template <typename Part>
  void Add(const std::optional<Part>& part) {
    Add(part.has_value());
    if (part) Add(*part);
  }

  void Add(const Wrench& wrench) {
    const auto& [force, torque] = wrench;
    AddAll(force, torque);
  }
  void Add(const ImuSample& imu) {
    const auto& [orientation, gyro, accelerometer] = imu;
    AddAll(orientation, gyro, accelerometer);
  }
  void Add(const FootSample& foot) {
    const auto& [normal_force] = foot;
    AddAll(normal_force);
  }
  void Add(const FootTruth& foot) {
    const auto& [p, R, v, force, moment, touch, in_contact] = foot;
    AddAll(p, R, v, force, moment, touch, in_contact);
  }
  void Add(const PushTruth& push) {
    const auto& [force, p] = push;
    AddAll(force, p);
  }
  void Add(const TruthSample& truth) {
    const auto& [p, q, v, w] = truth;
    AddAll(p, q, v, w);
  }
  void Add(const CentroidalSample& sample) {
    const auto& [p, momentum, angular_momentum, feet] = sample;
    AddAll(p, momentum, angular_momentum, feet);
  }

  Numbers numbers_;
};

inline Numbers AllNumbers(const WorldTruth& truth) {
  const auto& [qpos, p_WB, q_WB, v_WB, w_WB_B, joint_position, joint_velocity, joint_torque,
               num_saturated, p_WC, v_WC, angular_momentum, imu, feet, force_torque, pushes,
               body_touches_ground, self_contact_depth, power] = truth;
  NumberCollector collector;
  collector.AddAll(qpos, p_WB, q_WB, v_WB, w_WB_B, joint_position, joint_velocity, joint_torque,
                   num_saturated, p_WC, v_WC, angular_momentum, imu, feet, force_torque, pushes,
                   body_touches_ground, self_contact_depth, power);
  return collector.numbers();
}

inline Numbers AllNumbers(const SensorFrame& frame) {
  const auto& [tick, imu, joint_position, joint_velocity, feet, force_torque, age, truth,
               centroidal, external_wrench] = frame;
  NumberCollector collector;
  collector.AddAll(tick, imu, joint_position, joint_velocity, feet, force_torque, age, truth,
                   centroidal, external_wrench);
  return collector.numbers();
}

}  // namespace sidestep
