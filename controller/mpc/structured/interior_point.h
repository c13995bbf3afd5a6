// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// interior_point: the primal-dual barrier method on a laid-out problem.

#include "controller/mpc/structured/barrier.h"
#include "controller/mpc/structured/evaluate.h"
#include "controller/mpc/structured/isa.h"
#include "controller/mpc/structured/problem_view.h"
#include "controller/mpc/structured/riccati.h"

namespace sidestep::mpc::structured {

enum class Outcome { kSolved, kAcceptable, kIterationLimit, kStuck, kTooDear };

struct Settings {
  double tolerance{1e-8};
  bool is_rough{false};  ///< The cost alone is asked for, and not to more than a thousandth.
  double ceiling{__builtin_inf()};  ///< Costs above it need not be found out.
  int max_iterations{200};
  bool is_warm{false};     ///< The start is a guess, not a cold start.
  bool is_adaptive{true};  ///< Predictor and corrector instead of a monotone barrier.
  bool is_wary{
      false};  ///< Ends as stuck after a step that leads astray, as where the cost is flat.
  /// For where the cost is flat: a damped barrier that falls monotonically, and steps kept short by
  /// a shift. Takes longer.
  bool is_patient{false};
  bool is_exact{true};  ///< Second derivatives of the dynamics included.
};

struct Summary {
  Outcome outcome{Outcome::kStuck};
  int iterations{0};
  double cost{0.0};
  double kkt_error{0.0};
  double first_slope{0.0};  ///< Largest entry of the cost's gradient at the start.
};

/// Memory of a solve, sized for the problem by its owner.
struct Workspace {
  double* point{nullptr};  ///< In: the start's x, u, d. Out: the solution.
  double* trial{nullptr};
  double* direction{nullptr};
  double* target{nullptr};  ///< Products of slack and multiplier aimed at, in a point's order.
  double* change{nullptr};  ///< Change of the slopes by the corrector, in a point's order.
  Evaluation now;
  Evaluation next;
  Linearization linear;
  NewtonTerms newton;
};

namespace SIDESTEP_ISA {

/// Minimises from workspace->point.
Summary Minimize(const ProblemView& problem, const Settings& settings, Workspace* workspace);

}  // namespace SIDESTEP_ISA
}  // namespace sidestep::mpc::structured
