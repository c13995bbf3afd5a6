// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/knot_grid.h"

#include "models/support/require.h"

namespace sidestep::mpc {

KnotGrid::KnotGrid(Tick start, Tick grid_tick, Tick step) : start_(start), step_(step) {
  SIDESTEP_REQUIRE(step >= 1, step);
  const Tick since_grid = (start - grid_tick) % step;  // Negative if the grid's tick is to come.
  first_ = step - (since_grid + step) % step;
}

int KnotGrid::KnotAt(Tick tick) const {
  const Tick beyond_first = tick - start_ - first_;
  return beyond_first < 0 ? 0 : static_cast<int>(1 + beyond_first / step_);
}

int KnotGrid::NearestKnot(Tick tick) const {
  const int k = KnotAt(tick);
  return 2 * (tick - TickOf(k)) < StepAt(k) ? k : k + 1;
}

}  // namespace sidestep::mpc
