// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// joint_meter: how near the joints came to their limits, and the motors to theirs.

#include <limits>
#include <vector>

#include "models/robot_description/robot_description.h"
#include "sim/verdict/verdict.h"
#include "sim/world/world.h"

namespace sidestep {

/// Of actuated joints alone. A slide counts for torques (as forces) but has no margin: metres and
/// radians are not compared.
class JointMeter {
 public:
  /// @param joints  Of the plant. @param described  The robot's, which may tell a limit of a
  /// hinge's speed; in the same order, or none. @param tick_s  Length of a tick.
  JointMeter(const std::vector<JointInfo>& joints, const std::vector<JointDescription>& described,
             double tick_s);

  /// Takes the truth of one tick, with as many joints as there are or with none.
  void Add(const WorldTruth& truth);

  /// Least distance of a hinge from an end of its range (rad), negative beyond it; NaN if no hinge
  /// has a range.
  double min_margin_rad() const { return min_margin_rad_; }

  /// Largest |torque| of a motor over its limit; NaN if no motor has one.
  double max_torque_ratio() const { return max_torque_ratio_; }

  /// Largest speed of a hinge over its limit; NaN if the robot tells no limit.
  double max_speed_ratio() const { return max_speed_ratio_; }

  /// Time in which some motor was asked for more than it can (s).
  double saturation_s() const { return saturation_s_; }

  /// Peaks so far, in the order of the actuators.
  const std::vector<JointRecord>& records() const { return records_; }

 private:
  static constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

  double tick_s_;
  std::vector<JointRecord> records_;
  double min_margin_rad_{kNaN};
  double max_torque_ratio_{kNaN};
  double max_speed_ratio_{kNaN};
  double saturation_s_{0.0};
};

}  // namespace sidestep
