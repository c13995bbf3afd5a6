// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// riccati: the Newton system of the barrier problem, eliminated stage by stage from the last.
//
// Per stage one symmetric matrix over [pivots: u, locations that start here | kept: x, 1,
// locations that started before, the forces of stage k - 1 that continue]. Eliminating the pivots
// by a partial Cholesky factorisation leaves the cost-to-go in the kept quantities, which the next
// state's dynamics carry into stage k - 1. The row of the constant carries the gradients, so that
// the factorisation solves on the way. Positive pivots everywhere are equivalent to a positive
// definite reduced Hessian, that is to the inertia that a minimum wants.

#include "controller/mpc/structured/evaluate.h"
#include "controller/mpc/structured/isa.h"
#include "controller/mpc/structured/problem_view.h"

namespace sidestep::mpc::structured {

/// The barrier's part of the Newton system, and scratch memory.
struct NewtonTerms {
  double* curvature{nullptr};         ///< 6 x slots: xx, yy, zz, xy, xz, yz of sum z/s a a^T.
  double* box_curvature{nullptr};     ///< 3 a location.
  double* slope{nullptr};             ///< Gradient of the barrier function in the order of x, u, d.
  double shift{0.0};                  ///< Added to the diagonals of u and d.
  bool is_exact{true};                ///< Curvature of the dynamics included.
  double* tail[2]{nullptr, nullptr};  ///< Cost-to-go matrices, of this stage and the next.
  double* value{nullptr};             ///< Scratch, active rows x 12.
  double* product{nullptr};           ///< Scratch, active rows x 12.
  double* vector{nullptr};            ///< Scratch, a stage's rows.
  double* kept{nullptr};              ///< Scratch, a stage's rows.
  double* change{nullptr};            ///< One a pivot, stage by stage.
};

namespace SIDESTEP_ISA {

/// Factorises the whole system. False if a pivot is not positive: raise `shift` and repeat.
bool Factorize(const ProblemView& problem, const Evaluation& at, const Linearization& linear,
               const NewtonTerms& terms);

/// What a change of the slopes in u and d (`slope`, in the order of a point) adds to the constant's
/// row of the factor, to `terms.change`. After Factorize().
void ChangeSlope(const ProblemView& problem, const NewtonTerms& terms, const double* slope);

/// The Newton direction of x, u, d after Factorize(), and after ChangeSlope() if `is_changed`.
void SolveForward(const ProblemView& problem, const NewtonTerms& terms, bool is_changed,
                  double* direction);

}  // namespace SIDESTEP_ISA
}  // namespace sidestep::mpc::structured
