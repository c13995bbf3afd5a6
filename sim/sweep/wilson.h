// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// wilson: how well some runs tell a rate of survival.

namespace sidestep {

/// Bounds of a rate, in [0, 1].
struct RateInterval {
  double lower{0.0};
  double upper{1.0};
};

/// Wilson's score interval of 95 % for `successes` of `trials`; [0, 1] without trials.
/// Source: E. B. Wilson, "Probable inference, the law of succession, and statistical inference",
/// Journal of the American Statistical Association 22 (1927), 209-212.
RateInterval WilsonInterval(int successes, int trials);

}  // namespace sidestep
