// SPDX-License-Identifier: BSD-3-Clause
// Partial Cholesky factorisation of a stage, left-looking. A row of a force of stage k - 1 is zero
// up to its own pivot (first_pivot), which saves about half of the work.
#include "controller/mpc/structured/stage_matrix.h"
#include "controller/mpc/structured/tile.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {
namespace {

constexpr double kLeastPivot = 1e-14;  // Of a matrix whose entries are of the order of 10.

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

/// A Cholesky factor's 4 x 4 block below its diagonal.
struct Head {
  double l10, l20, l30, l21, l31, l32;
};

// Factorises the 4 x 4 block at the head of four columns, in registers. False if a pivot is not
// positive.
bool FactorHead(double* at, int stride, double* inverse_pivot, Head* head) {
  double* c1 = at + stride;
  double* c2 = at + 2 * stride;
  double* c3 = at + 3 * stride;
  const double i0 = 1.0 / Sqrt(at[0]);
  const double l10 = at[1] * i0, l20 = at[2] * i0, l30 = at[3] * i0;
  const double d1 = c1[1] - l10 * l10;
  const double i1 = 1.0 / Sqrt(d1);
  const double l21 = (c1[2] - l20 * l10) * i1, l31 = (c1[3] - l30 * l10) * i1;
  const double d2 = c2[2] - l20 * l20 - l21 * l21;
  const double i2 = 1.0 / Sqrt(d2);
  const double l32 = (c2[3] - l30 * l20 - l31 * l21) * i2;
  const double d3 = c3[3] - l30 * l30 - l31 * l31 - l32 * l32;
  const double i3 = 1.0 / Sqrt(d3);
  // Also false if not a number.
  const bool is_positive =
      at[0] > kLeastPivot && d1 > kLeastPivot && d2 > kLeastPivot && d3 > kLeastPivot;
  Store(Pack{i0, i1, i2, i3}, inverse_pivot);
  *head = {l10, l20, l30, l21, l31, l32};
  at[1] = l10;
  at[2] = l20;
  at[3] = l30;
  c1[2] = l21;
  c1[3] = l31;
  c2[3] = l32;
  return is_positive;
}

// Solves the rows below the head.
void SolveBelow(const Stage& stage, int column, const Head& l, double* head) {
  const int stride = stage.num_rows;
  const double* inverse = stage.inverse_pivot + column;
  for (int row = column + 4; row < stride; row += 4) {
    if (stage.first_pivot[row / 4] > column) break;  // Still zero, here and below.
    double* at = head + (row - column);
    const Pack x0 = Load(at) * inverse[0];
    const Pack x1 = (Load(at + stride) - x0 * l.l10) * inverse[1];
    const Pack x2 = (Load(at + 2 * stride) - x0 * l.l20 - x1 * l.l21) * inverse[2];
    const Pack x3 = (Load(at + 3 * stride) - x0 * l.l30 - x1 * l.l31 - x2 * l.l32) * inverse[3];
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
    Head factor;
    if (!FactorHead(head, rows, stage.inverse_pivot + column, &factor)) return false;
    SolveBelow(stage, column, factor, head);
  }
  const int kept = rows - stage.num_pivots;
  for (int column = 0; column < kept; column += 4) {
    UpdateColumns(stage, stage.num_pivots + column, stage.num_pivots + column, rows,
                  stage.num_pivots, tail + column * kept + column, kept);
  }
  return true;
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
