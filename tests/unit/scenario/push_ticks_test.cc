// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/push_ticks.h"

#include <gtest/gtest.h>

namespace sidestep::push_ticks_test {
namespace {

PushTicks Ticks(double start_s, double duration_s, double tick_s) {
  Push push;
  push.start_s = start_s;
  push.duration_s = duration_s;
  return TicksOf(push, tick_s);
}

TEST(PushTicksTest, PushBetweenTicksActsOnEveryTickItTouches) {
  const PushTicks ticks = Ticks(1.0005, 0.002, 0.001);
  EXPECT_NEAR(ticks.start, 1000.5, 1e-6);
  EXPECT_NEAR(ticks.end, 1002.5, 1e-6);
  EXPECT_EQ(ticks.first, 1000);
  EXPECT_EQ(ticks.beyond, 1003);
}

TEST(PushTicksTest, DecimalTimesOnTheGridAreWholeTicks) {
  for (const double tick_s : {0.001, 0.0005, 0.002, 0.0001}) {
    for (Tick start = 0; start < 30000; start += 7) {
      const PushTicks ticks = Ticks(SecondsAt(start, tick_s), SecondsAt(3, tick_s), tick_s);
      ASSERT_EQ(ticks.first, start);
      ASSERT_EQ(ticks.beyond, start + 3);
      ASSERT_EQ(ticks.start, static_cast<double>(start));
      ASSERT_EQ(ticks.end, static_cast<double>(start + 3));
    }
  }
}

}  // namespace
}  // namespace sidestep::push_ticks_test
