// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// push_ticks: the physics steps that a push acts on, in whole or in part.

#include <cmath>

#include "controller/types/tick.h"
#include "sim/scenario/push.h"

namespace sidestep {

/// A push in ticks. On the grid of ticks all four are whole and the same two.
struct PushTicks {
  double start{0.0};  ///< When it begins and ends, in ticks from 0 on.
  double end{0.0};
  Tick first{0};  ///< The first tick on which some of it acts, and the one after the last.
  Tick beyond{0};
};

/// `push` where one tick lasts `tick_s` (> 0). Decimal times are not exact in binary: one that is
/// within a millionth of a tick of a whole one is that.
inline PushTicks TicksOf(const Push& push, double tick_s) {
  constexpr double kRounding = 1e-6;
  const auto snapped = [&](double time_s) {
    const double ticks = time_s / tick_s;
    return std::abs(ticks - std::round(ticks)) < kRounding ? std::round(ticks) : ticks;
  };
  const double start = snapped(push.start_s);
  const double end = snapped(push.start_s + push.duration_s);
  return {start, end, static_cast<Tick>(std::floor(start)), static_cast<Tick>(std::ceil(end))};
}

}  // namespace sidestep
