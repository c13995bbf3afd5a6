// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// evaluate: cost, constraints, first derivatives and optimality of a point.

#include "controller/mpc/structured/isa.h"
#include "controller/mpc/structured/problem_view.h"

namespace sidestep::mpc::structured {

/// What is known at a point. Arrays belong to the workspace.
struct Evaluation {
  double cost{0.0};
  double log_sum{0.0};           ///< Sum of the logarithms of slacks and distances to boxes.
  double slack_sum{0.0};         ///< Sum of the friction rows' slacks.
  double infeasibility{0.0};     ///< 1-norm of gaps and residuals.
  double largest_residual{0.0};  ///< Infinity norm of the same.
  double* gap{nullptr};          ///< 9 N: what the dynamics predict minus the next state.
  double* residual{nullptr};     ///< faces x slots: A R^T u + s - b.
};

/// First derivatives and multipliers at a point.
struct Linearization {
  double* arm{nullptr};          ///< 3 x slots: vertex minus CoM.
  double* force{nullptr};        ///< 3 N: sum of the stage's u.
  double* block_force{nullptr};  ///< 3 a block: sum of its u.
  double* leg{nullptr};          ///< 4 a block: ankle to hip (m), what it lacks (m).
  double* gradient{nullptr};     ///< Of the cost, in the order of a point's x, u, d.
  double* costate{nullptr};      ///< 9 (N+1): multipliers of the dynamics.
  double dual{0.0};              ///< Infinity norm of the Lagrangian's gradient.
  double multiplier_sum{0.0};    ///< 1-norm of all multipliers.
  double bound_sum{0.0};         ///< 1-norm of the bounds' multipliers only.
  double gap_products{0.0};      ///< Sum of slack times multiplier.
  double largest_product{0.0};
  double smallest_product{0.0};
};

namespace SIDESTEP_ISA {

/// Cost, barrier and constraints at `point`.
void Evaluate(const ProblemView& problem, const double* point, Evaluation* out);

/// Derivatives at `point`, the costates that make the Lagrangian stationary in the states, and how
/// far it is from stationary in the rest.
void Linearize(const ProblemView& problem, const double* point, Linearization* out);

/// Replaces the states by what the dynamics make of the forces, and slacks by the distances that
/// the forces keep, but at least `push`.
void RollOut(const ProblemView& problem, double push, double* point);

}  // namespace SIDESTEP_ISA
}  // namespace sidestep::mpc::structured
