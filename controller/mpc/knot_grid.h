// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// knot_grid: which tick is which knot of a horizon.
//
//   solve
//     0      1             2             3                 k >= 1: on the grid
//     |------|-------------|-------------|---- ...
//      first       T             T
//
// Gaits change contacts on a grid of steps T, but solves need not fall on it: a foot lands when it
// does, and solves may be more frequent than knots. So knot 0 lasts from the solve until the next
// point of the grid, 0 < first <= T, and all others T.

#include "controller/types/tick.h"

namespace sidestep::mpc {

class KnotGrid {
 public:
  KnotGrid() = default;

  /// @param start      Knot 0: the solve.
  /// @param grid_tick  Any point of the grid, before or after the start.
  /// @param step       T (ticks), >= 1.
  KnotGrid(Tick start, Tick grid_tick, Tick step);

  Tick start() const { return start_; }

  /// Tick of knot k >= 0.
  Tick TickOf(int k) const { return k == 0 ? start_ : start_ + first_ + (k - 1) * step_; }

  /// Ticks from knot k >= 0 to the next.
  Tick StepAt(int k) const { return k == 0 ? first_ : step_; }

  /// Time from the start to knot k >= 0, in steps T: k itself if the start is on the grid.
  double StepsTo(int k) const {
    return k == 0 ? 0.0 : k - 1 + static_cast<double>(first_) / static_cast<double>(step_);
  }

  /// The last knot that is not after `tick`; 0 before the start.
  int KnotAt(Tick tick) const;

  /// The knot nearest to `tick`, the later of two that are equally near; 0 before the start.
  int NearestKnot(Tick tick) const;

 private:
  Tick start_{0};
  Tick first_{1};  ///< Of knot 0, 1 to step_.
  Tick step_{1};
};

}  // namespace sidestep::mpc
