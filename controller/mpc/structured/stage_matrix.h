// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// stage_matrix: assembles and eliminates the matrix of one stage (see riccati.h).

#include "controller/mpc/structured/isa.h"
#include "controller/mpc/structured/riccati.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {

/// Fills `dynamics` of stage k < N: the transposed Jacobian of the next state, rows of the stage x
/// 9, and the gap in the constant's row. What is zero at every point is so from the start.
void BuildDynamics(const ProblemView& problem, int k, const Evaluation& at,
                   const Linearization& linear);

/// Fills the stage's panel and `tail` (lower triangles, by columns) from the cost-to-go `next` of
/// stage k + 1, which is unused at k = N.
void AssembleStage(const ProblemView& problem, int k, const Evaluation& at,
                   const Linearization& linear, const NewtonTerms& terms, const double* next,
                   double* tail);

/// Eliminates the stage's pivots: the panel becomes the factor, `tail` the Schur complement.
/// False if a pivot is not positive.
bool EliminateStage(const Stage& stage, double* tail);

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
