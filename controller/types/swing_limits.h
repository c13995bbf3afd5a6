// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// swing_limits: what a foot in the air can do, as far as the planner and the swing care.

#include <limits>

namespace sidestep {

/// Peak acceleration of a move of least jerk over 1 m in 1 s, from rest to rest: 10 / sqrt(3).
inline constexpr double kLeastJerkPeak = 5.773502691896258;

/// Zero: not known, any.
struct SwingLimits {
  double speed_mps{0.0};          ///< A mean over the swing.
  double acceleration_mps2{0.0};  ///< At its peak.

  /// How far (m) a foot at rest gets within `time_s` (>= 0) and be at rest again, by the bound on
  /// acceleration alone.
  double ReachIn(double time_s) const {
    if (acceleration_mps2 == 0.0) return std::numeric_limits<double>::infinity();
    return acceleration_mps2 * time_s * time_s / kLeastJerkPeak;
  }
};

}  // namespace sidestep
