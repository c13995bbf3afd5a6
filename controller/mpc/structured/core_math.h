// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// core_math: the few scalar helpers of the numerical core, with internal linkage on purpose (see
// isa.h).

namespace sidestep::mpc::structured {
namespace {

inline double Max(double a, double b) { return a > b ? a : b; }
inline double Min(double a, double b) { return a < b ? a : b; }
inline int Min(int a, int b) { return a < b ? a : b; }
inline double Abs(double a) { return __builtin_fabs(a); }
inline double Sqrt(double a) { return __builtin_sqrt(a); }
inline bool IsFinite(double a) { return __builtin_isfinite(a); }

inline void Fill(double* values, long count, double value) {
  for (long i = 0; i < count; ++i) values[i] = value;
}

/// out = a x b.
inline void Cross(const double* a, const double* b, double* out) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

/// Entry (row, column) of [a]x.
inline double SkewEntry(const double* a, int row, int column) {
  if (row == column) return 0.0;
  const int third = 3 - row - column;
  return (column - row + 3) % 3 == 1 ? -a[third] : a[third];
}

/// out = R v with R row-major.
inline void Rotate(const double* R, const double* v, double* out) {
  for (int a = 0; a < 3; ++a) out[a] = R[3 * a] * v[0] + R[3 * a + 1] * v[1] + R[3 * a + 2] * v[2];
}

/// out = R^T v with R row-major.
inline void RotateBack(const double* R, const double* v, double* out) {
  for (int a = 0; a < 3; ++a) out[a] = R[a] * v[0] + R[3 + a] * v[1] + R[6 + a] * v[2];
}

}  // namespace
}  // namespace sidestep::mpc::structured
