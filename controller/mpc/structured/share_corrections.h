// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// share_corrections: what a foot whose vertices do not share its force alike changes in the
// symmetry cost of equal shares, in value, slope and curvature.
//
// With shares s_j (sum 1), n vertices and r = n s, that cost is, per axis,
//   w/2 sum_j (u_j - s_j sum_l u_l)^2,    deviations e_j = u_j - r_j mean, which sum to zero.
// Feet with equal shares are most of all feet and never come here. All three functions are kept out
// of line, so that the compiler cannot mix them into the arithmetic of equal shares.

#include "controller/mpc/structured/isa.h"
#include "controller/mpc/structured/problem_view.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {

/// Sum of the squared deviations e_j, of one axis. `share` holds the r_j, `u` the forces by mass
/// (m/s^2), each of `count` vertices; `mean` is the mean of u.
double SquaresBesideShares(const double* share, const double* u, double mean, int count);

/// Turns the slope w (u_j - mean) of equal shares, of one axis, into that of the shares:
/// w (e_j - sum_i s_i e_i) = w (u_j - r_j mean - sum_i (r_i - 1) e_i / n), as the e_i sum to zero.
/// Arguments as above; `weight` is w, and `slope` has an entry a vertex.
void AddShareSlope(const double* share, const double* u, double weight, double mean, int count,
                   double* slope);

/// Turns the curvature w (I - 1 1^T / n) of equal shares, in the columns of the stage's panel that
/// belong to the block's forces, into that of the shares: w (I - s 1^T)^T (I - s 1^T), whose entry
/// is w (delta_ij - (r_i + r_j - r.r / n) / n).
void AddShareCurvature(const ProblemView& problem, const Stage& stage, const ContactBlock& block);

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
