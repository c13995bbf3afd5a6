// SPDX-License-Identifier: BSD-3-Clause
// One stage's matrix. With the next state x' = G [rows], its cost-to-go V splits into the state's
// block, what is carried over unchanged, and the coupling Y of both:
//
//   M = carried + G^T V_xx G + G^T Y^T + Y G + own curvature.
#include "controller/mpc/structured/foot_load.h"
#include "controller/mpc/structured/leg_reach.h"
#include "controller/mpc/structured/share_corrections.h"
#include "controller/mpc/structured/stage_matrix.h"
#include "controller/mpc/structured/tile.h"

namespace sidestep::mpc::structured::SIDESTEP_ISA {
namespace {

/// The stage's matrix, whose lower triangle is kept in two pieces.
struct StageMatrix {
  const Stage& stage;
  double* tail;
  int kept;

  /// Start of column `column`, such that [row] is the entry of that row.
  double* Column(int column) const {
    return column < stage.num_pivots ? stage.panel + column * stage.num_rows
                                     : tail + (column - stage.num_pivots) * kept - stage.num_pivots;
  }
  /// Adds to the entry of two rows, in the lower triangle.
  void Add(int row, int column, double value) const {
    Column(row > column ? column : row)[row > column ? row : column] += value;
  }
  /// The same of a pivot's column.
  double* Pivot(int column) const { return stage.panel + column * stage.num_rows; }
};

// Coupling of the next state with what is carried over.
void BuildCoupling(const ProblemView& problem, const Stage& stage, const double* next, int stride,
                   double* coupling) {
  const int rows = stage.num_active;
  Fill(coupling, 12 * rows, 0.0);
  for (int i = stage.first_carry; i < stage.first_carry + stage.num_carries; ++i) {
    const Carry& carry = problem.carries[i];
    for (int a = 0; a < 9; ++a) {
      const double* from = next + a * stride + carry.from;
      double* to = coupling + a * rows + carry.to;
      for (int r = 0; r < carry.count; ++r) to[r] = from[r];
    }
  }
}

// product = coupling + G^T V_xx.
void BuildProduct(const Stage& stage, const double* next, int stride, const double* coupling,
                  double* product) {
  const int rows = stage.num_active;
  alignas(32) double value[9 * 12] = {};  // V_xx in full, by columns of twelve.
  for (int a = 0; a < 9; ++a) {
    for (int b = 0; b <= a; ++b) value[12 * b + a] = value[12 * a + b] = next[b * stride + a];
  }
  for (int column = 0; column < 12; column += 4) {
    ForTiles(
        0, rows, [&](auto tile, int row) __attribute__((always_inline)) {
          tile.Read(coupling + column * rows + row, rows);
          tile.template Accumulate<false>({stage.dynamics + row, rows}, {value + column, 12}, 0, 9);
          tile.Write(product + column * rows + row, rows);
        });
  }
}

// Overwrites the active rows of the lower triangle.
void SetCongruence(const StageMatrix& matrix, const double* coupling, const double* product) {
  const Stage& stage = matrix.stage;
  const int rows = stage.num_active;
  const double* G = stage.dynamics;
  for (int column = 0; column < rows; column += 4) {
    const bool is_pivot = column < stage.num_pivots;
    double* target = matrix.Column(column);
    const int stride = is_pivot ? stage.num_rows : matrix.kept;
    const int first = column + 4 <= 3 * stage.num_slots ? 3 : 0;  // Forces do not move p at once.
    ForTiles(
        column, rows, [&](auto tile, int row) __attribute__((always_inline)) {
          tile.Clear();
          tile.template Accumulate<false>({product + row, rows}, {G + column, rows}, first, 9);
          tile.template Accumulate<false>({G + row, rows}, {coupling + column, rows}, 0, 9);
          tile.Write(target + row, stride);
        });
  }
}

// to += from, both anywhere.
inline void AddTo(const double* from, int count, double* to) {
  int i = 0;
  for (; i + 4 <= count; i += 4) {
    StoreAnywhere(LoadAnywhere(to + i) + LoadAnywhere(from + i), to + i);
  }
  for (; i < count; ++i) to[i] += from[i];
}

void AddCarried(const ProblemView& problem, const StageMatrix& matrix, const double* next,
                int stride) {
  const Carry* carries = problem.carries + matrix.stage.first_carry;
  for (int i = 0; i < matrix.stage.num_carries; ++i) {
    for (int j = 0; j < matrix.stage.num_carries; ++j) {
      const Carry& low = carries[i];
      const Carry& high = carries[j];
      if (low.from < high.from) continue;
      for (int c = 0; c < high.count; ++c) {
        const double* from = next + (high.from + c) * stride + low.from;
        if (low.to >= high.to) {
          // From a whole pack on: what lands above the diagonal is never read.
          const int first = i == j ? c / 4 * 4 : 0;
          AddTo(from + first, low.count - first, matrix.Column(high.to + c) + low.to + first);
        } else {
          for (int r = 0; r < low.count; ++r) matrix.Column(low.to + r)[high.to + c] += from[r];
        }
      }
    }
  }
}

// Curvature and slope of the stage's forces.
void AddForces(const ProblemView& problem, const NewtonTerms& terms, const StageMatrix& matrix) {
  const Stage& stage = matrix.stage;
  const int n = stage.num_slots, one = stage.num_pivots + kOneRow;
  const double* curvature = terms.curvature + 6 * stage.first_slot;
  const double* slope = terms.slope + problem.at.u + 3 * stage.first_slot;
  for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
    const ContactBlock& block = problem.blocks[b];
    const int num_rates =
        (block.previous >= 0 || block.has_previous_force ? 1 : 0) + (block.next >= 0 ? 1 : 0);
    for (int a = 0; a < 3; ++a) {
      const double own = num_rates * problem.weight_rate[a] + problem.weight_symmetry[a] +
                         (block.is_new ? problem.weight_new[a] : 0.0) + terms.shift;
      const double share = problem.weight_symmetry[a] / block.count;
      for (int j = block.first; j < block.first + block.count; ++j) {
        double* column = matrix.Pivot(a * n + j);
        for (int i = j; i < block.first + block.count; ++i) column[a * n + i] -= share;
        column[a * n + j] += own + curvature[a * n + j];
        column[one] += slope[a * n + j];
      }
    }
    if (block.has_shares) AddShareCurvature(problem, stage, block);
    for (int j = block.first; j < block.first + block.count; ++j) {
      matrix.Pivot(j)[n + j] += curvature[3 * n + j];
      matrix.Pivot(j)[2 * n + j] += curvature[4 * n + j];
      matrix.Pivot(n + j)[2 * n + j] += curvature[5 * n + j];
    }
  }
}

// Second derivatives of costate . (p_F - p) x u.
void AddDynamicsCurvature(const ProblemView& problem, int k, const Linearization& linear,
                          const StageMatrix& matrix) {
  const Stage& stage = matrix.stage;
  const int n = stage.num_slots, x = stage.num_pivots;
  double pull[3];
  for (int a = 0; a < 3; ++a) pull[a] = problem.step_s[k] * linear.costate[9 * (k + 1) + 6 + a];
  for (int a = 0; a < 3; ++a) {
    const double turn[3] = {SkewEntry(pull, 0, a), SkewEntry(pull, 1, a), SkewEntry(pull, 2, a)};
    for (int j = 0; j < n; ++j) {
      double* column = matrix.Pivot(a * n + j) + x;
      for (int b = 0; b < 3; ++b) column[b] += turn[b];
    }
  }
  for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
    const ContactBlock& block = problem.blocks[b];
    if (block.location < 0) continue;
    const double* R = problem.rotation + 9 * block.location;
    const int row = problem.coupled[block.coupled].row;
    for (int d = 0; d < 3; ++d) {
      if (problem.is_free[3 * block.location + d] == 0.0) continue;
      const double axis[3] = {R[d], R[3 + d], R[6 + d]};
      double turn[3];
      Cross(pull, axis, turn);  // d/du of pull . (axis x u).
      for (int a = 0; a < 3; ++a) {
        for (int j = block.first; j < block.first + block.count; ++j) {
          matrix.Pivot(a * n + j)[row + d] += turn[a];
        }
      }
    }
  }
}

void AddLocations(const ProblemView& problem, const NewtonTerms& terms, const StageMatrix& matrix) {
  const Stage& stage = matrix.stage;
  const int one = stage.num_pivots + kOneRow;
  for (int i = stage.first_coupled; i < stage.first_coupled + stage.num_new; ++i) {
    const CoupledLocation& coupled = problem.coupled[i];
    const double* hessian = problem.location_hessian + 9 * coupled.location;
    for (int a = 0; a < 3; ++a) {
      const int entry = 3 * coupled.location + a;
      double* column = matrix.Column(coupled.row + a);
      if (problem.is_free[entry] == 0.0) {
        column[coupled.row + a] += 1.0;
        continue;
      }
      column[coupled.row + a] += terms.box_curvature[entry] + terms.shift;
      column[one] += terms.slope[problem.at.d + entry];
      for (int b = a; b < 3; ++b) {
        column[coupled.row + b] += problem.is_free[3 * coupled.location + b] * hessian[3 * a + b];
      }
    }
  }
}

void AddStates(const ProblemView& problem, int k, const NewtonTerms& terms,
               const StageMatrix& matrix) {
  const int x = matrix.stage.num_pivots;
  for (int i = 0; i < 9; ++i) {
    double* column = matrix.Column(x + i);
    if (i < 3) column[x + i] += problem.weight_com[i];
    if (i >= 6) column[x + i] += problem.weight_momentum[i - 6];
    column[x + kOneRow] += terms.slope[9 * k + i];
  }
}

// Curvature of the legs' lengths in p, in d where the foot's place is free, and between them.
void AddLegs(const ProblemView& problem, const Linearization& linear, const StageMatrix& matrix) {
  const Stage& stage = matrix.stage;
  if (problem.weight_leg == 0.0) return;
  for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
    const ContactBlock& block = problem.blocks[b];
    if (linear.leg[4 * b + 3] == 0.0) continue;
    double H[9];
    LegCurvature(problem, linear, b, H);
    for (int c = 0; c < 3; ++c) {
      for (int r = c; r < 3; ++r)
        matrix.Add(stage.num_pivots + r, stage.num_pivots + c, H[3 * r + c]);
    }
    if (block.location < 0) continue;
    const double* R = problem.rotation + 9 * block.location;
    const double* is_free = problem.is_free + 3 * block.location;
    const int row = problem.coupled[block.coupled].row;
    for (int d = 0; d < 3; ++d) {
      if (is_free[d] == 0.0) continue;
      const double axis[3] = {R[d], R[3 + d], R[6 + d]};
      double pull[3], pull_F[3];  // H R, a column of it, and R^T H R
      Rotate(H, axis, pull);
      RotateBack(R, pull, pull_F);
      for (int a = 0; a < 3; ++a) matrix.Add(stage.num_pivots + a, row + d, -pull[a]);
      for (int a = d; a < 3; ++a) matrix.Add(row + a, row + d, is_free[a] * pull_F[a]);
    }
  }
}

// Curvature of what feet bear above their limit, in their vertical forces.
void AddLoads(const ProblemView& problem, const Linearization& linear, const StageMatrix& matrix) {
  const Stage& stage = matrix.stage;
  if (problem.weight_load == 0.0) return;
  for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
    const ContactBlock& block = problem.blocks[b];
    const double curvature = LoadCurvature(problem, linear, b);
    if (curvature == 0.0) continue;
    const int z = 2 * stage.num_slots;
    for (int j = z + block.first; j < z + block.first + block.count; ++j) {
      for (int i = j; i < z + block.first + block.count; ++i) matrix.Pivot(j)[i] += curvature;
    }
  }
}

void CoupleToPreviousForces(const ProblemView& problem, const StageMatrix& matrix) {
  const Stage& stage = matrix.stage;
  for (int b = stage.first_block; b < stage.first_block + stage.num_blocks; ++b) {
    const ContactBlock& block = problem.blocks[b];
    if (block.previous < 0) continue;
    for (int a = 0; a < 3; ++a) {
      for (int j = 0; j < block.count; ++j) {
        const int row = stage.num_active + a * stage.num_kept + block.kept + j;
        matrix.Pivot(a * stage.num_slots + block.first + j)[row] = -problem.weight_rate[a];
      }
    }
  }
}

// Zeroes the lower triangle from row `first` on: what SetCongruence() leaves. Structural zeros are
// read too, where a tile has rows with and without them.
void ClearMatrix(const StageMatrix& matrix, int first) {
  const int rows = matrix.stage.num_rows;
  for (int column = 0; column < rows; ++column) {
    const int begin = column > first ? column / 4 * 4 : first;
    double* entries = matrix.Column(column);
    for (int row = begin; row < rows; row += 4) Store(Pack{0.0, 0.0, 0.0, 0.0}, entries + row);
  }
}

}  // namespace

void AssembleStage(const ProblemView& problem, int k, const Evaluation& at,
                   const Linearization& linear, const NewtonTerms& terms, const double* next,
                   double* tail) {
  const Stage& stage = problem.stages[k];
  const StageMatrix matrix{stage, tail, stage.num_rows - stage.num_pivots};
  ClearMatrix(matrix, k < problem.knots ? stage.num_active : 0);
  if (k < problem.knots) {
    const Stage& after = problem.stages[k + 1];
    const int stride = after.num_rows - after.num_pivots;
    BuildDynamics(problem, k, at, linear);
    BuildCoupling(problem, stage, next, stride, terms.value);
    BuildProduct(stage, next, stride, terms.value, terms.product);
    SetCongruence(matrix, terms.value, terms.product);
    AddCarried(problem, matrix, next, stride);
    AddForces(problem, terms, matrix);
    if (terms.is_exact) AddDynamicsCurvature(problem, k, linear, matrix);
    AddLegs(problem, linear, matrix);
    AddLoads(problem, linear, matrix);
    CoupleToPreviousForces(problem, matrix);
  }
  for (int i = 3 * (stage.num_slots + stage.num_new); i < stage.num_pivots; ++i) {
    matrix.Column(i)[i] = 1.0;
  }
  AddLocations(problem, terms, matrix);
  AddStates(problem, k, terms, matrix);
}

}  // namespace sidestep::mpc::structured::SIDESTEP_ISA
