// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/wilson.h"

#include <algorithm>
#include <cmath>

#include "models/support/require.h"

namespace sidestep {

RateInterval WilsonInterval(int successes, int trials) {
  SIDESTEP_REQUIRE(successes >= 0 && successes <= trials, successes);
  if (trials == 0) return {};
  constexpr double kZ = 1.959963984540054;  // quantile 0.975 of the normal distribution
  const double n = trials;
  const double rate = successes / n;
  const double center = (rate + kZ * kZ / (2.0 * n)) / (1.0 + kZ * kZ / n);
  const double half =
      kZ / (1.0 + kZ * kZ / n) * std::sqrt(rate * (1.0 - rate) / n + kZ * kZ / (4.0 * n * n));
  return {std::max(0.0, center - half), std::min(1.0, center + half)};
}

}  // namespace sidestep
