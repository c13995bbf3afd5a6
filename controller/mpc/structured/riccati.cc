// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/riccati.h"

#include "controller/mpc/structured/core_math.h"
#include "controller/mpc/structured/stage_matrix.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {
namespace {

double Dot(const double* a, const double* b, int count) {
  double sum = 0.0;
  for (int i = 0; i < count; ++i) sum += a[i] * b[i];
  return sum;
}

// The kept rows of `rows` from the direction so far: state, constant, locations, forces before.
void GatherKept(const ProblemView& problem, int k, const double* direction, double* rows) {
  const Stage& stage = problem.stages[k];
  double* kept = rows + stage.num_pivots;
  Fill(kept, stage.num_rows - stage.num_pivots, 0.0);
  for (int i = 0; i < 9; ++i) kept[i] = direction[9 * k + i];
  kept[kOneRow] = 1.0;
  for (int i = stage.first_alive + stage.num_new; i < stage.first_alive + stage.num_alive; ++i) {
    const AliveLocation& alive = problem.alive[i];
    for (int a = 0; a < 3; ++a) {
      rows[alive.row + a] = direction[problem.at.d + 3 * alive.location + a];
    }
  }
  for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
    const ContactBlock& block = problem.blocks[b];
    if (block.previous < 0) continue;
    const Stage& before = problem.stages[k - 1];
    for (int a = 0; a < 3; ++a) {
      const double* u =
          direction + problem.at.u + 3 * before.first_slot + a * before.num_slots + block.previous;
      double* to = rows + stage.num_active + a * stage.num_kept + block.kept;
      for (int j = 0; j < block.count; ++j) to[j] = u[j];
    }
  }
}

}  // namespace

bool Factorize(const ProblemView& problem, const Evaluation& at, const Linearization& linear,
               const NewtonTerms& terms) {
  for (int k = problem.knots; k >= 0; --k) {
    double* tail = terms.tail[k % 2];
    AssembleStage(problem, k, at, linear, terms, terms.tail[(k + 1) % 2], tail);
    if (!EliminateStage(problem.stages[k], tail)) return false;
  }
  return true;
}

void SolveForward(const ProblemView& problem, const NewtonTerms& terms, double* direction) {
  double* rows = terms.vector;
  Fill(direction, 9, 0.0);
  for (int k = 0; k <= problem.knots; ++k) {
    const Stage& stage = problem.stages[k];
    GatherKept(problem, k, direction, rows);
    for (int j = stage.num_pivots - 1; j >= 0; --j) {
      const double* column = stage.panel + j * stage.num_rows;
      const int below = stage.num_rows - j - 1;
      rows[j] = -stage.inverse_pivot[j] * Dot(column + j + 1, rows + j + 1, below);
    }
    double* u = direction + problem.at.u + 3 * stage.first_slot;
    for (int j = 0; j < 3 * stage.num_slots; ++j) u[j] = rows[j];
    for (int i = stage.first_alive; i < stage.first_alive + stage.num_new; ++i) {
      const AliveLocation& alive = problem.alive[i];
      for (int a = 0; a < 3; ++a) {
        direction[problem.at.d + 3 * alive.location + a] = rows[alive.row + a];
      }
    }
    if (k == problem.knots) break;
    for (int i = 0; i < 9; ++i) {
      direction[9 * (k + 1) + i] =
          Dot(stage.dynamics + i * stage.num_active, rows, stage.num_active);
    }
  }
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
