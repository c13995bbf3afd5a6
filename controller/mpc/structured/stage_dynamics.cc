// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/core_math.h"
#include "controller/mpc/structured/stage_matrix.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {

void BuildDynamics(const ProblemView& problem, int k, const Evaluation& at,
                   const Linearization& linear) {
  const Stage& stage = problem.stages[k];
  const double step_s = problem.step_s[k];
  const int rows = stage.num_active, n = stage.num_slots, x = stage.num_pivots;
  double* G = stage.dynamics;
  const double* arm = linear.arm + 3 * stage.first_slot;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    double* force = G + (3 + a) * rows + a * n;
    // Moment c of a unit force along a is the arm's b component with sign -, and so on.
    double* moment_b = G + (6 + b) * rows + a * n;
    double* moment_c = G + (6 + c) * rows + a * n;
    for (int j = 0; j < n; ++j) {
      force[j] = step_s;
      moment_b[j] = step_s * arm[c * n + j];
      moment_c[j] = -step_s * arm[b * n + j];
    }
    G[a * rows + x + a] = 1.0;
    G[a * rows + x + 3 + a] = step_s;
    G[(3 + a) * rows + x + 3 + a] = 1.0;
    G[(6 + a) * rows + x + 6 + a] = 1.0;
    for (int d = 0; d < 3; ++d) {
      G[(6 + a) * rows + x + d] = step_s * SkewEntry(linear.force + 3 * k, a, d);
    }
  }
  for (int i = 0; i < 9; ++i) G[i * rows + x + kOneRow] = at.gap[9 * k + i];
  for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
    const ContactBlock& block = problem.blocks[b];
    if (block.location < 0) continue;
    const double* R = problem.rotation + 9 * block.location;
    const double* is_free = problem.is_free + 3 * block.location;
    const int row = problem.coupled[block.coupled].row;
    for (int d = 0; d < 3; ++d) {  // (R e_d) x force.
      const double axis[3] = {R[d], R[3 + d], R[6 + d]};
      double turn[3];
      Cross(axis, linear.block_force + 3 * b, turn);
      for (int a = 0; a < 3; ++a) G[(6 + a) * rows + row + d] = is_free[d] * step_s * turn[a];
    }
  }
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
