// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// leg_reach: the cost of what a standing leg lacks in length, and its derivatives.
//
//   w/2 e^2,  e = max(0, (|r|^2 - L^2) / 2L),  r = p + anchor - R d from ankle to hip
//   slope in r     w e r / L          curvature    w (r r^T / L + e I) / L, if e > 0
//
// Convex in p and d: e is the positive part of a convex function of them.

#include "controller/mpc/structured/evaluate.h"
#include "controller/mpc/structured/isa.h"
#include "controller/mpc/structured/problem_view.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {

/// The cost at `point` over the stages 0 < k < N; the state at 0 is given.
double LegCost(const ProblemView& problem, const double* point);

/// Fills the legs of `out` and adds their slopes in p and d to its gradient.
void LinearizeLegs(const ProblemView& problem, const double* point, Linearization* out);

/// The curvature in r, 3 x 3, of the leg of block `b`: zero if it is long enough.
void LegCurvature(const ProblemView& problem, const Linearization& linear, int b,
                  double* curvature);

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
