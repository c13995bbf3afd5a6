// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// solver_meter: how often the controller's solvers failed, and how far their answers left bounds.

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "controller/types/control_tick.h"
#include "controller/types/tick.h"

namespace sidestep {

/// One solver's answers.
struct SolverCount {
  int solves{0};
  int failures{0};

  /// Failures over solves; 0 without any.
  double failure_ratio() const;

  void Add(bool is_solved);
};

/// The controller's solvers, in the order of kSolverNames. kWholeBody is inverse dynamics' QP or
/// inverse kinematics', kStep that of the baseline dcm_qp.
enum class Solver { kMpc, kWholeBody, kStep };
inline constexpr std::array<const char*, 3> kSolverNames{"MPC", "whole-body", "step"};

/// Counts what ControlTick tells. Single failures are borne by the plan in use or a fallback; a row
/// of the MPC's, or a large share of any solver's, is not: what happened then was not the
/// controller's doing.
class SolverMeter {
 public:
  /// @param friction  Of the MPC's cones.
  explicit SolverMeter(double friction) : friction_(friction) {}

  /// Takes a control tick.
  void Add(Tick tick, const ControlTick& control);

  /// Solves, and those of them without a usable solution: for the whole body also those whose
  /// exact tasks had to give way.
  const SolverCount& count(Solver solver) const {
    return counts_[static_cast<std::size_t>(solver)];
  }

  /// The largest failure_ratio() of all.
  double max_failure_ratio() const;

  /// The first solver that failed in more than kMostFailureRatio of its solves, if more than
  /// kMostFailures times.
  std::optional<Solver> failing_solver() const;

  /// Solves after which the plan before stayed in use.
  int fallbacks() const { return fallbacks_; }
  /// Of the planned forces, over every control tick; see ConeViolation_N.
  double max_cone_violation_N() const { return max_cone_violation_N_; }

  /// Tick at which the MPC had failed too often in a row, and how it failed then.
  std::optional<Tick> lost_tick() const { return lost_tick_; }
  const std::string& lost_status() const { return lost_status_; }

 private:
  double friction_;  ///< MpcParams' own, not the world's.
  std::array<SolverCount, kSolverNames.size()> counts_;
  int mpc_failures_in_a_row_{0};  ///< Up to the last solve.
  int fallbacks_{0};
  double max_cone_violation_N_{0.0};
  std::optional<Tick> lost_tick_;
  std::string lost_status_;
};

/// So many failed solves of the MPC in a row are borne; one more makes a SOLVER verdict.
inline constexpr int kMostMpcFailuresInARow = 5;

/// So much of a solver's work may fail. Of the scenarios that ship one fails at all: in 14 of 4000
/// whole-body solves, before a fall that it expects.
inline constexpr double kMostFailureRatio = 0.05;
inline constexpr int kMostFailures = 5;  ///< Of a short run.

}  // namespace sidestep
