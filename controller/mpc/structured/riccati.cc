// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/structured/riccati.h"

#include "controller/mpc/structured/stage_matrix.h"
#include "controller/mpc/structured/tile.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {
namespace {

// out[c] = column c . vector over `count` rows, a multiple of four. Two sums a column hide the
// latency of the additions.
template <int columns>
inline void DotColumns(const double* matrix, int stride, const double* vector, int count,
                       double* out) {
  Pack even[columns], odd[columns];
  for (int c = 0; c < columns; ++c) even[c] = odd[c] = Pack{0.0, 0.0, 0.0, 0.0};
  int i = 0;
  for (; i + 8 <= count; i += 8) {
    const Pack first = Load(vector + i), second = Load(vector + i + 4);
    for (int c = 0; c < columns; ++c) {
      even[c] += Load(matrix + c * stride + i) * first;
      odd[c] += Load(matrix + c * stride + i + 4) * second;
    }
  }
  if (i < count) {
    const Pack first = Load(vector + i);
    for (int c = 0; c < columns; ++c) even[c] += Load(matrix + c * stride + i) * first;
  }
  for (int c = 0; c < columns; ++c) {
    const Pack sum = even[c] + odd[c];
    out[c] = (sum[0] + sum[2]) + (sum[1] + sum[3]);
  }
}

// The pivots' direction from the kept rows', four at a time from the last.
void SolvePivots(const Stage& stage, const double* change, double* rows) {
  const int stride = stage.num_rows;
  int end = stride;
  for (int j = stage.num_pivots - 4; j >= 0; j -= 4) {
    while (end > stage.num_active && stage.first_pivot[end / 4 - 1] > j) end -= 4;  // Zeros.
    const double* head = stage.panel + j * stride + j;
    const double* inverse = stage.inverse_pivot + j;
    double sum[4];
    DotColumns<4>(head + 4, stride, rows + j + 4, end - j - 4, sum);
    if (change != nullptr) {
      for (int c = 0; c < 4; ++c) sum[c] += change[j + c];
    }
    // In registers: loading what has just been stored in another width would stall.
    const double x3 = -inverse[3] * sum[3];
    const double x2 = -inverse[2] * (sum[2] + head[2 * stride + 3] * x3);
    const double x1 = -inverse[1] * (sum[1] + head[stride + 2] * x2 + head[stride + 3] * x3);
    const double x0 = -inverse[0] * (sum[0] + head[1] * x1 + head[2] * x2 + head[3] * x3);
    Store(Pack{x0, x1, x2, x3}, rows + j);
  }
}

// The kept rows of `rows` from the direction so far: state, constant, locations, forces before.
void GatherKept(const ProblemView& problem, int k, const double* direction, double* rows) {
  const Stage& stage = problem.stages[k];
  double* kept = rows + stage.num_pivots;
  Fill(kept, stage.num_rows - stage.num_pivots, 0.0);
  for (int i = 0; i < 9; ++i) kept[i] = direction[9 * k + i];
  kept[kOneRow] = 1.0;
  for (int i = stage.first_coupled + stage.num_new; i < stage.first_coupled + stage.num_coupled;
       ++i) {
    const CoupledLocation& coupled = problem.coupled[i];
    for (int a = 0; a < 3; ++a) {
      rows[coupled.row + a] = direction[problem.at.d + 3 * coupled.location + a];
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
  for (int i = stage.first_coupled; i < stage.first_coupled + stage.num_new; ++i) {
    const CoupledLocation& coupled = problem.coupled[i];
    for (int a = 0; a < 3; ++a) {
      rows[coupled.row + a] += slope[problem.at.d + 3 * coupled.location + a];
    }
  }
}

// Solves for the pivots and takes them out of the kept rows.
void EliminateSlopes(const Stage& stage, double* rows, double* change) {
  const int stride = stage.num_rows;
  int end = stage.num_active;
  for (int j = 0; j < stage.num_pivots; j += 4) {
    while (end < stride && stage.first_pivot[end / 4] <= j) end += 4;  // Zeros below.
    const double* head = stage.panel + j * stride + j;
    const double* inverse = stage.inverse_pivot + j;
    const double x0 = inverse[0] * rows[j];
    const double x1 = inverse[1] * (rows[j + 1] - head[1] * x0);
    const double x2 = inverse[2] * (rows[j + 2] - head[2] * x0 - head[stride + 2] * x1);
    const double x3 = inverse[3] * (rows[j + 3] - head[3] * x0 - head[stride + 3] * x1 -
                                    head[2 * stride + 3] * x2);
    Store(Pack{x0, x1, x2, x3}, change + j);
    for (int i = 4; i < end - j; i += 4) {
      const Pack left = Load(head + i) * x0 + Load(head + stride + i) * x1 +
                        Load(head + 2 * stride + i) * x2 + Load(head + 3 * stride + i) * x3;
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
    for (int i = stage.first_coupled; i < stage.first_coupled + stage.num_new; ++i) {
      const CoupledLocation& coupled = problem.coupled[i];
      for (int a = 0; a < 3; ++a) {
        direction[problem.at.d + 3 * coupled.location + a] = rows[coupled.row + a];
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
