// SPDX-License-Identifier: BSD-3-Clause
#include "controller/types/tick.h"

#include <gtest/gtest.h>

namespace sidestep::tick_test {
namespace {

TEST(TickTest, TimeGoesToTheNearestTickOnEitherSideOfZero) {
  EXPECT_EQ(TickAt(0.0, 0.001), 0);
  EXPECT_EQ(TickAt(0.0024, 0.001), 2);
  EXPECT_EQ(TickAt(0.0026, 0.001), 3);
  EXPECT_EQ(TickAt(-0.0024, 0.001), -2);
  EXPECT_EQ(TickAt(-0.0026, 0.001), -3);
}

TEST(TickTest, HalfATickGoesAwayFromZero) {
  // Of 1/4 s, for then the half is exact.
  EXPECT_EQ(TickAt(0.125, 0.25), 1);
  EXPECT_EQ(TickAt(0.625, 0.25), 3);
  EXPECT_EQ(TickAt(-0.125, 0.25), -1);
}

TEST(TickTest, ADecimalTimeIsNotCutOffToTheTickBefore) {
  // 0.29 / 0.01 is 28.999999999999996 in binary.
  ASSERT_LT(0.29 / 0.01, 29.0);
  EXPECT_EQ(TickAt(0.29, 0.01), 29);
}

TEST(TickTest, EveryTickOfADayComesBackFromItsSeconds) {
  constexpr Tick kDay = 86'400'000;  // ms
  for (const double tick_s : {0.001, 0.002, 0.0005, 1.0 / 3000.0}) {
    for (Tick tick = -kDay; tick <= kDay; tick += 86'399) {
      ASSERT_EQ(TickAt(SecondsAt(tick, tick_s), tick_s), tick) << tick_s;
    }
  }
}

TEST(TickTest, SecondsAreAProductAndNotASum) {
  EXPECT_EQ(SecondsAt(3, 0.1), 3.0 * 0.1);
  EXPECT_EQ(SecondsAt(-4, 0.25), -1.0);
  double summed_s = 0.0;
  for (int i = 0; i < 1000; ++i) summed_s += 0.001;
  ASSERT_NE(summed_s, 1.0) << "the error that a sum would have";
  EXPECT_EQ(SecondsAt(1000, 0.001), 1.0);
}

}  // namespace
}  // namespace sidestep::tick_test
