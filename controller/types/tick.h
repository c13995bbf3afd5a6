// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// tick: integer time. One tick is one physics step; seconds are derived, never summed.

#include <cmath>
#include <cstdint>

namespace sidestep {

using Tick = std::int64_t;

/// Nearest tick to `time_s` when one tick lasts `tick_s` (> 0).
inline Tick TickAt(double time_s, double tick_s) {
  return static_cast<Tick>(std::llround(time_s / tick_s));
}

/// Seconds at `tick`.
inline double SecondsAt(Tick tick, double tick_s) { return static_cast<double>(tick) * tick_s; }

}  // namespace sidestep
