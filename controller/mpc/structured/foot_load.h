// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// foot_load: the cost of what a foot bears above its limit, and its derivatives.
//
//   w/2 e^2,  e = max(0, sum_j u_jz - limit)      slope in each u_jz   w e
//                                                 curvature in each pair of them   w, if e > 0
//
// Convex: e is the positive part of a sum. Sums by mass, z of W.

#include "controller/mpc/structured/evaluate.h"
#include "controller/mpc/structured/isa.h"
#include "controller/mpc/structured/problem_view.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {

/// The cost at `point` over all stages.
double LoadCost(const ProblemView& problem, const double* point);

/// Adds the slopes in the forces to the gradient of `out`, whose sums of forces are those of the
/// point.
void LinearizeLoads(const ProblemView& problem, Linearization* out);

/// Curvature of block `b` in every pair of its vertical forces: 0 within the limit.
double LoadCurvature(const ProblemView& problem, const Linearization& linear, int b);

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
