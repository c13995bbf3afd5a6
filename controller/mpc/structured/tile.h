// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// tile: products of small matrices by columns, in tiles of up to 12 x 4 that stay in registers.
// Rows come in fours: every stride and row offset is a multiple of four, every array aligned.

#include "controller/mpc/structured/core_math.h"

namespace sidestep::mpc::structured {
namespace {

using Pack = double __attribute__((vector_size(32)));

inline Pack Load(const double* from) { return *reinterpret_cast<const Pack*>(from); }
inline void Store(Pack value, double* to) { *reinterpret_cast<Pack*>(to) = value; }

/// The same anywhere in memory. The attribute stands with the name: with the type, clang passes
/// over it and loads as if the place were aligned.
using LoosePack [[gnu::aligned(8)]] = Pack;
static_assert(alignof(LoosePack) == alignof(double));
inline Pack LoadAnywhere(const double* from) { return *reinterpret_cast<const LoosePack*>(from); }
inline void StoreAnywhere(Pack value, double* to) { *reinterpret_cast<LoosePack*>(to) = value; }

/// A matrix by columns.
struct Columns {
  const double* at;
  long stride;
};

/// The target's tile in registers: `count` packs of four rows, four columns.
template <int count>
struct Tile {
  Pack sum[count][4];

  __attribute__((always_inline)) void Clear() {
    for (int i = 0; i < count; ++i) {
      for (int c = 0; c < 4; ++c) sum[i][c] = Pack{0.0, 0.0, 0.0, 0.0};
    }
  }
  __attribute__((always_inline)) void Read(const double* target, long stride) {
    for (int i = 0; i < count; ++i) {
      for (int c = 0; c < 4; ++c) sum[i][c] = Load(target + c * stride + 4 * i);
    }
  }
  __attribute__((always_inline)) void Write(double* target, long stride) const {
    for (int i = 0; i < count; ++i) {
      for (int c = 0; c < 4; ++c) Store(sum[i][c], target + c * stride + 4 * i);
    }
  }
  /// += (or -=) sum over p in [begin, end) of left(row, p) right(column, p).
  template <bool is_minus>
  __attribute__((always_inline)) void Accumulate(Columns left, Columns right, int begin, int end) {
    const double* rows = left.at + begin * left.stride;
    const double* columns = right.at + begin * right.stride;
#pragma GCC unroll 4
    for (int p = begin; p < end; ++p, rows += left.stride, columns += right.stride) {
      Pack value[count];
      for (int i = 0; i < count; ++i) value[i] = Load(rows + 4 * i);
      // Twelve sums, three rows and one factor: sixteen registers. One more would spill a sum.
      for (int c = 0; c < 4; ++c) {
        const double factor = columns[c];
        for (int i = 0; i < count; ++i) {
          if constexpr (is_minus) {
            sum[i][c] -= value[i] * factor;
          } else {
            sum[i][c] += value[i] * factor;
          }
        }
      }
    }
  }
};

/// Calls visit(empty tile, row) for tiles that cover rows [begin, end), the largest first. Sixteen
/// registers of 16 bytes hold a tile of 4 x 4 only.
template <typename Visit>
inline __attribute__((always_inline)) void ForTiles(int begin, int end, Visit&& visit) {
#ifdef __AVX2__
  int row = begin;
  // Four sums alone wait for each other: sixteen rows are twice eight.
  for (; end - row >= 12 && end - row != 16; row += 12) visit(Tile<3>{}, row);
  for (; end - row >= 8; row += 8) visit(Tile<2>{}, row);
  if (end - row == 4) visit(Tile<1>{}, row);
#else
  for (int row = begin; row < end; row += 4) visit(Tile<1>{}, row);
#endif
}

}  // namespace
}  // namespace sidestep::mpc::structured
