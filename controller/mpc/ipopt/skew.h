// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// skew: cross products as matrices, and 3x3 blocks as sparse entries.

#include <Eigen/Core>

namespace sidestep::mpc {

/// [a]x: Skew(a) * b = a x b.
inline Eigen::Matrix3d Skew(const Eigen::Vector3d& a) {
  Eigen::Matrix3d skew;
  skew << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return skew;
}

/// Calls emit(row, column, value) for value * identity, three entries.
template <typename Emit>
void EmitDiagonal(int row, int column, double value, Emit&& emit) {
  for (int a = 0; a < 3; ++a) {
    emit(row + a, column + a, value);
  }
}

/// Calls emit for the six entries of [vector]x off the diagonal.
/// The off-diagonal places of the Jacobian of a cross product; the diagonal is zero for every
/// vector and never an entry. `row` and `column` are those of the block's upper left corner.
template <typename Emit>
void EmitSkew(int row, int column, const Eigen::Vector3d& vector, Emit&& emit) {
  emit(row, column + 1, -vector.z());
  emit(row, column + 2, vector.y());
  emit(row + 1, column, vector.z());
  emit(row + 1, column + 2, -vector.x());
  emit(row + 2, column, -vector.y());
  emit(row + 2, column + 1, vector.x());
}

/// Calls emit for all nine entries of `block`.
/// Row by row, zeros included: the structure must not depend on the values.
template <typename Emit>
void EmitDense(int row, int column, const Eigen::Matrix3d& block, Emit&& emit) {
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      emit(row + a, column + b, block(a, b));
    }
  }
}

/// Calls emit for the lower triangle of `block`, six entries, on the diagonal from `first` on.
template <typename Emit>
void EmitLower(int first, const Eigen::Matrix3d& block, Emit&& emit) {
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b <= a; ++b) {
      emit(first + a, first + b, block(a, b));
    }
  }
}

}  // namespace sidestep::mpc
