// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// stage_matrix: assembles and eliminates the matrix of one stage (see riccati.h).

#include "controller/mpc/structured/isa.h"
#include "controller/mpc/structured/riccati.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {

/// Fills the stage's panel and `tail` (lower triangles, by columns) from the cost-to-go `next` of
/// stage k + 1, which is unused at k = N.
void AssembleStage(const ProblemView& problem, int k, const Evaluation& at,
                   const Linearization& linear, const NewtonTerms& terms, const double* next,
                   double* tail);

/// Eliminates the stage's pivots: the panel becomes the factor, `tail` the Schur complement.
/// False if a pivot is not positive.
bool EliminateStage(const Stage& stage, double* tail);

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
