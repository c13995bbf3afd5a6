// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plan_log: the contacts that the controller said it planned. Nothing here is the truth: it makes
// the planned step adjustments and the boxes' violations, and two columns of footsteps.csv.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "controller/types/control_tick.h"
#include "controller/types/tick.h"

namespace sidestep {

/// Horizontal distance from a contact's nominal to its adjusted place (m).
double StepAdjustment_m(const PlannedContact& contact);

/// Farthest that adjusted - nominal leaves the contact's box along x or y of F (m); >= 0.
double BoxViolation_m(const PlannedContact& contact);

/// Farthest that a force at a vertex leaves |f_x| + |f_y| <= friction f_z in F's axes (N); >= 0.
double ConeViolation_N(const FootTarget& foot, double friction);

class PlanLog {
 public:
  explicit PlanLog(std::size_t num_feet) : feet_(num_feet), last_(num_feet) {}

  /// Takes a control tick's contacts; one without feet is a controller that plans none.
  void Add(const ControlTick& control);

  /// Contacts of a foot that began so far, each as it was planned on the tick that began it.
  const std::vector<PlannedContact>& begun(std::size_t foot) const { return feet_.at(foot); }

  /// Adjustments (m) of the contacts that began at or after `from`, but for those the robot stood
  /// in at the start.
  std::vector<double> AdjustmentsFrom(Tick from) const;

  /// Over every control tick on which a foot was on its way to its contact (m). Once it has landed
  /// the contact is where it was felt, which nobody planned; nor did anybody those of the start.
  double max_box_violation_m() const { return max_box_violation_m_; }

 private:
  std::vector<std::vector<PlannedContact>> feet_;
  std::vector<std::optional<int>> last_;  // index of the latest contact that began
  double max_box_violation_m_{0.0};
};

}  // namespace sidestep
