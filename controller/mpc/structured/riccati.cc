// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/riccati.h"

#include "controller/mpc/structured/stage_matrix.h"
#include "controller/mpc/structured/tile.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {
namespace {

// out[c] = column c . vector over `count` rows, a multiple of four.
template <int columns>
void DotColumns(const double* matrix, int stride, const double* vector, int count, double* out) {
  Pack sum[columns];
  for (int c = 0; c < columns; ++c) sum[c] = Pack{0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < count; i += 4) {
    const Pack value = Load(vector + i);
    for (int c = 0; c < columns; ++c) sum[c] += Load(matrix + c * stride + i) * value;
  }
  for (int c = 0; c < columns; ++c) out[c] = (sum[c][0] + sum[c][2]) + (sum[c][1] + sum[c][3]);
}

// The pivots' direction from the kept rows', four at a time from the last.
void SolvePivots(const Stage& stage, const double* change, double* rows) {
  const int stride = stage.num_rows;
  for (int j = stage.num_pivots - 4; j >= 0; j -= 4) {
    const double* head = stage.panel + j * stride + j;
    const double* inverse = stage.inverse_pivot + j;
    double sum[4];
    DotColumns<4>(head + 4, stride, rows + j + 4, stride - j - 4, sum);
    for (int c = 3; c >= 0; --c) {
      if (change != nullptr) sum[c] += change[j + c];
      for (int i = c + 1; i < 4; ++i) sum[c] += head[c * stride + i] * rows[j + i];
      rows[j + c] = -inverse[c] * sum[c];
    }
  }
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

// The slopes of a stage's rows: its own, and the next stage's through the dynamics.
void GatherSlopes(const ProblemView& problem, int k, const double* slope, const double* next,
                  double* rows) {
  const Stage& stage = problem.stages[k];
  Fill(rows, stage.num_rows, 0.0);
  if (k < problem.knots) {
    for (int a = 0; a < 9; ++a) {
      const double* G = stage.dynamics + a * stage.num_active;
      for (int i = 0; i < stage.num_active; ++i) rows[i] += next[a] * G[i];
    }
    for (int i = stage.first_carry; i < stage.first_carry + stage.num_carries; ++i) {
      const Carry& carry = problem.carries[i];
      for (int r = 0; r < carry.count; ++r) rows[carry.to + r] += next[carry.from + r];
    }
  }
  rows[stage.num_pivots + kOneRow] = 0.0;  // A constant cost.
  const double* u = slope + problem.at.u + 3 * stage.first_slot;
  for (int j = 0; j < 3 * stage.num_slots; ++j) rows[j] += u[j];
  for (int i = stage.first_alive; i < stage.first_alive + stage.num_new; ++i) {
    const AliveLocation& alive = problem.alive[i];
    for (int a = 0; a < 3; ++a) {
      rows[alive.row + a] += slope[problem.at.d + 3 * alive.location + a];
    }
  }
}

// Solves for the pivots and takes them out of the kept rows.
void EliminateSlopes(const Stage& stage, double* rows, double* change) {
  const int stride = stage.num_rows;
  for (int j = 0; j < stage.num_pivots; j += 4) {
    const double* head = stage.panel + j * stride + j;
    const double* inverse = stage.inverse_pivot + j;
    double x[4];
    for (int c = 0; c < 4; ++c) {
      x[c] = rows[j + c];
      for (int p = 0; p < c; ++p) x[c] -= head[p * stride + c] * x[p];
      x[c] *= inverse[c];
      change[j + c] = x[c];
    }
    for (int i = 4; i < stride - j; i += 4) {
      const Pack left = Load(head + i) * x[0] + Load(head + stride + i) * x[1] +
                        Load(head + 2 * stride + i) * x[2] + Load(head + 3 * stride + i) * x[3];
      Store(Load(rows + j + i) - left, rows + j + i);
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

void ChangeSlope(const ProblemView& problem, const NewtonTerms& terms, const double* slope) {
  double* rows = terms.vector;
  const double* kept = terms.kept;
  for (int k = problem.knots; k >= 0; --k) {
    const Stage& stage = problem.stages[k];
    GatherSlopes(problem, k, slope, kept, rows);
    EliminateSlopes(stage, rows, terms.change + stage.first_of_pivots);
    for (int i = stage.num_pivots; i < stage.num_rows; ++i) {
      terms.kept[i - stage.num_pivots] = rows[i];
    }
  }
}

void SolveForward(const ProblemView& problem, const NewtonTerms& terms, bool is_changed,
                  double* direction) {
  double* rows = terms.vector;
  Fill(direction, 9, 0.0);
  for (int k = 0; k <= problem.knots; ++k) {
    const Stage& stage = problem.stages[k];
    GatherKept(problem, k, direction, rows);
    SolvePivots(stage, is_changed ? terms.change + stage.first_of_pivots : nullptr, rows);
    double* u = direction + problem.at.u + 3 * stage.first_slot;
    for (int j = 0; j < 3 * stage.num_slots; ++j) u[j] = rows[j];
    for (int i = stage.first_alive; i < stage.first_alive + stage.num_new; ++i) {
      const AliveLocation& alive = problem.alive[i];
      for (int a = 0; a < 3; ++a) {
        direction[problem.at.d + 3 * alive.location + a] = rows[alive.row + a];
      }
    }
    if (k == problem.knots) break;
    double next[12];
    for (int i = 0; i < 9; i += 3) {
      DotColumns<3>(stage.dynamics + i * stage.num_active, stage.num_active, rows, stage.num_active,
                    next + i);
    }
    for (int i = 0; i < 9; ++i) direction[9 * (k + 1) + i] = next[i];
  }
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
