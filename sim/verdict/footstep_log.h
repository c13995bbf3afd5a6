// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// footstep_log: the planned contacts of a run, what the truth made of them, and the swings between.

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

#include "controller/types/control_tick.h"
#include "controller/types/tick.h"
#include "models/robot_description/robot_description.h"
#include "sim/verdict/verdict.h"
#include "sim/world/world.h"

namespace sidestep {

/// Horizontal distance from a contact's nominal to its adjusted place (m).
double StepAdjustment_m(const PlannedContact& contact);

/// Farthest that adjusted - nominal leaves the contact's box along an axis of F (m); >= 0.
double BoxViolation_m(const PlannedContact& contact);

/// Farthest that a force at a vertex leaves |f_x| + |f_y| <= friction f_z in F's axes (N); >= 0.
double ConeViolation_N(const FootTarget& foot, double friction);

class FootstepLog {
 public:
  /// @param feet  The robot's, in the order of every other vector of feet.
  explicit FootstepLog(const std::vector<FootDescription>& feet);

  /// Takes a control tick's contacts. Must come before AddTruth of the same tick.
  void AddPlan(Tick tick, const ControlTick& control);

  /// Takes a tick's truth.
  /// @param stance_slip_m  One a foot, as SlipMeter measures it.
  void AddTruth(const WorldTruth& truth, const std::vector<double>& stance_slip_m);

  /// Contacts that began so far, in order of start; those of one instant in the order of feet.
  const std::vector<FootstepRecord>& footsteps() const { return footsteps_; }

  /// Adjustments (m) of the contacts that began at or after `from`, but for those the robot stood
  /// in at the start.
  std::vector<double> AdjustmentsFrom(Tick from) const;

  /// Over every control tick, contacts of the start apart (m).
  double max_box_violation_m() const { return max_box_violation_m_; }

  /// Smallest apex of the sole's lowest corner above the ground over the finished planned swings
  /// (m); NaN if none.
  double min_swing_clearance_m() const;

 private:
  struct Foot {
    FootDescription description;
    bool has_plan{false};
    bool planned_contact{false};
    std::optional<std::size_t> record;  ///< Of the latest contact, in footsteps_.
    std::optional<double> apex_m;       ///< Of the swing under way, once its lift-off was seen.
  };

  std::vector<Foot> feet_;
  std::vector<FootstepRecord> footsteps_;
  double max_box_violation_m_{0.0};
  double min_swing_clearance_m_{std::numeric_limits<double>::infinity()};
};

}  // namespace sidestep
