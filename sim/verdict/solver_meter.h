// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// solver_meter: how often the controller's solvers failed, and how far their answers left bounds.

#include <optional>
#include <string>

#include "controller/types/control_tick.h"
#include "controller/types/tick.h"

namespace sidestep {

/// Counts what ControlTick tells and judges nothing but a row of failures: single ones are borne by
/// the plan in use.
class SolverMeter {
 public:
  /// @param friction  Of the MPC's cones.
  explicit SolverMeter(double friction) : friction_(friction) {}

  /// Takes a control tick.
  void Add(Tick tick, const ControlTick& control);

  /// Solves of the MPC without a usable solution, and whole-body solves that were not ok.
  int mpc_failures() const { return mpc_failures_; }
  int wbc_failures() const { return wbc_failures_; }
  /// Solves after which the plan before stayed in use.
  int fallbacks() const { return fallbacks_; }
  /// Of the planned forces, over every control tick; see ConeViolation_N.
  double max_cone_violation_N() const { return max_cone_violation_N_; }

  /// Tick at which the MPC had failed too often in a row, and how it failed then.
  std::optional<Tick> lost_tick() const { return lost_tick_; }
  const std::string& lost_status() const { return lost_status_; }

 private:
  double friction_;  ///< MpcParams' own, not the world's.
  int mpc_failures_{0};
  int mpc_failures_in_a_row_{0};  ///< Up to the last solve.
  int wbc_failures_{0};
  int fallbacks_{0};
  double max_cone_violation_N_{0.0};
  std::optional<Tick> lost_tick_;
  std::string lost_status_;
};

/// So many failed solves in a row are borne; one more makes a SOLVER verdict.
inline constexpr int kMostMpcFailuresInARow = 5;

}  // namespace sidestep
