// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/share_corrections.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {

__attribute__((noinline)) double SquaresBesideShares(const double* share, const double* u,
                                                     double mean, int count) {
  double sum = 0.0;
  for (int j = 0; j < count; ++j) {
    const double deviation = u[j] - share[j] * mean;
    sum += deviation * deviation;
  }
  return sum;
}

__attribute__((noinline)) void AddShareSlope(const double* share, const double* u, double weight,
                                             double mean, int count, double* slope) {
  double excess = 0.0;
  for (int j = 0; j < count; ++j) excess += (share[j] - 1.0) * (u[j] - share[j] * mean);
  excess /= count;
  for (int j = 0; j < count; ++j) slope[j] -= weight * ((share[j] - 1.0) * mean + excess);
}

__attribute__((noinline)) void AddShareCurvature(const ProblemView& problem, const Stage& stage,
                                                 const ContactBlock& block) {
  const int n = stage.num_slots;
  const double* relative = problem.relative_share + stage.first_slot;
  for (int a = 0; a < 3; ++a) {
    const double share = problem.weight_symmetry[a] / block.count;
    for (int j = block.first; j < block.first + block.count; ++j) {
      double* column = stage.panel + (a * n + j) * stage.num_rows + a * n;
      for (int i = j; i < block.first + block.count; ++i) {
        column[i] -= share * (relative[i] + relative[j] - block.share_square - 1.0);
      }
    }
  }
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
