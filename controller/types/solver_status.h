// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// solver_status: how a solve of the MPC or of a whole-body QP ended. A failed solve is a status,
// never an exception; these enums cross from the solvers to the log and the verdict as they are.

#include <array>
#include <string_view>
#include <utility>

#include "controller/types/field.h"

namespace sidestep {

/// How an MPC solve ended. Only kSolved carries an optimum; the rest keep the best iterate found.
enum class SolveStatus {
  kNotSolved,       ///< No solve has come to an end yet.
  kSolved,          ///< To the tolerance asked for.
  kAcceptable,      ///< Stopped close to an optimum (looser tolerances).
  kInfeasible,      ///< Converged to a point of local infeasibility.
  kIterationLimit,  ///< Out of iterations before any tolerance was met.
  kNumericalError,  ///< Non-finite input or a failed factorisation.
};

template <>
struct EnumNames<SolveStatus> {
  static constexpr std::array<std::pair<SolveStatus, std::string_view>, 6> kNames{
      {{SolveStatus::kNotSolved, "not_solved"},
       {SolveStatus::kSolved, "solved"},
       {SolveStatus::kAcceptable, "acceptable"},
       {SolveStatus::kInfeasible, "infeasible"},
       {SolveStatus::kIterationLimit, "iteration_limit"},
       {SolveStatus::kNumericalError, "numerical_error"}}};
};

/// True if the trajectories may be used by the controller.
inline bool IsUsable(SolveStatus status) {
  return status == SolveStatus::kSolved || status == SolveStatus::kAcceptable;
}

/// How a dense QP ended. Only kSolved carries an optimum.
enum class QpStatus {
  kNotSolved,
  kSolved,          ///< Optimal within the tolerances of DenseQpOptions.
  kInfeasible,      ///< No x satisfies the constraints (proved within tolerance).
  kUnbounded,       ///< Feasible, and the cost falls for ever along a ray.
  kIterationLimit,  ///< Tolerance not reached; x is the last iterate.
  kNumericalError,  ///< Non-finite data, or H not convex on the equalities' null space.
};

template <>
struct EnumNames<QpStatus> {
  static constexpr std::array<std::pair<QpStatus, std::string_view>, 6> kNames{
      {{QpStatus::kNotSolved, "not_solved"},
       {QpStatus::kSolved, "solved"},
       {QpStatus::kInfeasible, "infeasible"},
       {QpStatus::kUnbounded, "unbounded"},
       {QpStatus::kIterationLimit, "iteration_limit"},
       {QpStatus::kNumericalError, "numerical_error"}}};
};

}  // namespace sidestep
