// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// low_pass: the one filter of the estimators.

#include <numbers>

namespace sidestep {

/// Share of the way to its input that a first-order low-pass goes in one step of `dt_s`.
inline double LowPassShare(double cutoff_hz, double dt_s) {
  const double ratio = 2.0 * std::numbers::pi * cutoff_hz * dt_s;
  return ratio / (1.0 + ratio);
}

}  // namespace sidestep
