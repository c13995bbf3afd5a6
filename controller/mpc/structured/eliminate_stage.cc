// SPDX-License-Identifier: BSD-3-Clause
// Partial Cholesky factorisation of a stage, left-looking. A row of a force of stage k - 1 is zero
// up to its own pivot (first_pivot), which saves about half of the work.
#include "controller/mpc/structured/stage_matrix.h"
#include "controller/mpc/structured/tile.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {
namespace {

// Applies pivots [.., end) to four columns of a matrix whose rows [row_begin, row_end) count from
// the panel's; `column` is the panel's row that belongs to the first of the four.
void UpdateColumns(const Stage& stage, int column, int row_begin, int row_end, int end,
                   double* target, int target_stride) {
  const int stride = stage.num_rows;
  const int column_first = stage.first_pivot[column / 4];
  ForTiles(
      row_begin, row_end, [&](auto tile, int row) __attribute__((always_inline)) {
        const int row_first = stage.first_pivot[row / 4];
        const int begin = row_first > column_first ? row_first : column_first;
        if (begin >= end) return;
        tile.Read(target + (row - row_begin), target_stride);
        tile.template Accumulate<true>({stage.panel + row, stride}, {stage.panel + column, stride},
                                       begin, end);
        tile.Write(target + (row - row_begin), target_stride);
      });
}

// Factorises the 4 x 4 block at the head of four columns. False if a pivot is not positive.
bool FactorHead(double* head, int stride, double* inverse_pivot) {
  for (int c = 0; c < 4; ++c) {
    double* column = head + c * stride;
    for (int p = 0; p < c; ++p) {
      const double* done = head + p * stride;
      for (int i = c; i < 4; ++i) column[i] -= done[i] * done[c];
    }
    if (!(column[c] > 1e-14)) return false;  // Also if not a number.
    const double root = Sqrt(column[c]);
    inverse_pivot[c] = 1.0 / root;
    column[c] = root;
    for (int i = c + 1; i < 4; ++i) column[i] *= inverse_pivot[c];
  }
  return true;
}

// Solves the rows below the head.
void SolveBelow(const Stage& stage, int column, double* head) {
  const int stride = stage.num_rows;
  const double* inverse = stage.inverse_pivot + column;
  const double l10 = head[1], l20 = head[2], l30 = head[3];
  const double l21 = head[stride + 2], l31 = head[stride + 3], l32 = head[2 * stride + 3];
  for (int row = column + 4; row < stride; row += 4) {
    if (stage.first_pivot[row / 4] > column) break;  // Still zero, here and below.
    double* at = head + (row - column);
    const Pack x0 = Load(at) * inverse[0];
    const Pack x1 = (Load(at + stride) - x0 * l10) * inverse[1];
    const Pack x2 = (Load(at + 2 * stride) - x0 * l20 - x1 * l21) * inverse[2];
    const Pack x3 = (Load(at + 3 * stride) - x0 * l30 - x1 * l31 - x2 * l32) * inverse[3];
    Store(x0, at);
    Store(x1, at + stride);
    Store(x2, at + 2 * stride);
    Store(x3, at + 3 * stride);
  }
}

}  // namespace

bool EliminateStage(const Stage& stage, double* tail) {
  const int rows = stage.num_rows;
  for (int column = 0; column < stage.num_pivots; column += 4) {
    double* head = stage.panel + column * rows + column;
    UpdateColumns(stage, column, column, rows, column, head, rows);
    if (!FactorHead(head, rows, stage.inverse_pivot + column)) return false;
    SolveBelow(stage, column, head);
  }
  const int kept = rows - stage.num_pivots;
  for (int column = 0; column < kept; column += 4) {
    UpdateColumns(stage, stage.num_pivots + column, stage.num_pivots + column, rows,
                  stage.num_pivots, tail + column * kept + column, kept);
  }
  return true;
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
