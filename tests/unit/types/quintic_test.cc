// SPDX-License-Identifier: BSD-3-Clause
#include "controller/types/quintic.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sidestep::quintic_test {
namespace {

// Sums of half a dozen terms of order one.
constexpr double kRounding = 1e-13;

// p(t) = 1 + 2t - 3t^2 + 4t^3 - 5t^4 + 6t^5, differentiated by hand.
QuinticState Polynomial(double t) {
  return {1 + t * (2 + t * (-3 + t * (4 + t * (-5 + t * 6)))),
          2 + t * (-6 + t * (12 + t * (-20 + t * 30))), -6 + t * (24 + t * (-60 + t * 120))};
}

TEST(QuinticTest, IsTheOnePolynomialOfDegreeFiveThroughItsEnds) {
  constexpr double kDuration_s = 0.7;
  const Quintic quintic(Polynomial(0.0), Polynomial(kDuration_s), kDuration_s);
  for (const double t : {0.0, 0.1, 0.35, 0.6, kDuration_s}) {
    EXPECT_NEAR(quintic.At(t).position, Polynomial(t).position, 10 * kRounding) << t;
    EXPECT_NEAR(quintic.At(t).velocity, Polynomial(t).velocity, 100 * kRounding) << t;
    EXPECT_NEAR(quintic.At(t).acceleration, Polynomial(t).acceleration, 1000 * kRounding) << t;
  }
}

TEST(QuinticTest, FromRestToRestItIsTheMinimumJerkMotion) {
  // x = d (10 s^3 - 15 s^4 + 6 s^5): half way at half time, where it is fastest, 15/8 of the mean.
  constexpr double kDistance_m = 0.4, kDuration_s = 0.5;
  const Quintic quintic({}, {kDistance_m, 0.0, 0.0}, kDuration_s);
  const QuinticState middle = quintic.At(0.5 * kDuration_s);
  EXPECT_NEAR(middle.position, 0.5 * kDistance_m, kRounding);
  EXPECT_NEAR(middle.velocity, 15.0 / 8.0 * kDistance_m / kDuration_s, 10 * kRounding);
  EXPECT_NEAR(middle.acceleration, 0.0, 100 * kRounding);
  // The acceleration is greatest at s = 1/2 - sqrt(3)/6: 10/sqrt(3) d / T^2.
  const double peak_s = (0.5 - std::sqrt(3.0) / 6.0) * kDuration_s;
  EXPECT_NEAR(quintic.At(peak_s).acceleration,
              10.0 / std::sqrt(3.0) * kDistance_m / (kDuration_s * kDuration_s), 100 * kRounding);
}

TEST(QuinticTest, MovedMirroredAndReversedEndsGiveThatMotion) {
  const QuinticState from{0.1, -0.5, 2.0}, to{0.4, 0.3, -1.0};
  constexpr double kDuration_s = 0.3;
  const Quintic quintic(from, to, kDuration_s);
  const Quintic reversed({to.position, -to.velocity, to.acceleration},
                         {from.position, -from.velocity, from.acceleration}, kDuration_s);
  const Quintic mirrored({1.0 - from.position, -from.velocity, -from.acceleration},
                         {1.0 - to.position, -to.velocity, -to.acceleration}, kDuration_s);
  for (const double t : {0.03, 0.12, 0.29}) {
    EXPECT_NEAR(reversed.At(kDuration_s - t).position, quintic.At(t).position, kRounding);
    EXPECT_NEAR(reversed.At(kDuration_s - t).velocity, -quintic.At(t).velocity, 100 * kRounding);
    EXPECT_NEAR(mirrored.At(t).position, 1.0 - quintic.At(t).position, kRounding);
  }
}

}  // namespace
}  // namespace sidestep::quintic_test
