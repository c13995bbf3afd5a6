// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/wilson.h"

#include <gtest/gtest.h>

#include "models/support/require.h"

namespace sidestep::wilson_test {
namespace {

// By hand, with z = 1.96: 8 of 10 gives (0.8 + 0.192) / 1.384 +- 1.4163 * sqrt(0.016 + 0.0096).
TEST(WilsonTest, IsTheIntervalByHand) {
  const RateInterval rate = WilsonInterval(8, 10);
  EXPECT_NEAR(rate.lower, 0.4902, 1e-4);
  EXPECT_NEAR(rate.upper, 0.9433, 1e-4);
}

TEST(WilsonTest, KnowsThatFewRunsTellLittle) {
  EXPECT_NEAR(WilsonInterval(1, 1).lower, 0.2065, 1e-4);
  EXPECT_DOUBLE_EQ(WilsonInterval(1, 1).upper, 1.0);
  EXPECT_DOUBLE_EQ(WilsonInterval(0, 5).lower, 0.0);
  EXPECT_EQ(WilsonInterval(0, 0).upper, 1.0);
  EXPECT_NEAR(WilsonInterval(3, 7).lower, 1.0 - WilsonInterval(4, 7).upper, 1e-12);
  EXPECT_THROW(WilsonInterval(2, 1), ContractViolation);
}

}  // namespace
}  // namespace sidestep::wilson_test
