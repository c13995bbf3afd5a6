// SPDX-License-Identifier: BSD-3-Clause
#include "sim/apps/commands/progress.h"

#include <gtest/gtest.h>

namespace sidestep::progress_test {
namespace {

TEST(ProgressTextTest, HalfWayHalfTheBarIsFullAndAsMuchTimeIsLeftAsWasTaken) {
  EXPECT_EQ(ProgressText("run", 0.5, "1.0 of 2.0 s", 12.0, 8),
            "run [####----]  50 %, 1.0 of 2.0 s, about 12 s left");
}

TEST(ProgressTextTest, InAPipeThereIsNoBar) {
  EXPECT_EQ(ProgressText("run", 0.25, "", 3.0, 0), "run  25 %, about 9 s left");
}

TEST(ProgressTextTest, NoTimeLeftIsToldTooEarlyOrAtTheEnd) {
  EXPECT_EQ(ProgressText("run", 0.01, "", 3.0, 0), "run   1 %");
  EXPECT_EQ(ProgressText("run", 1.0, "", 3.0, 4), "run [####] 100 %");
}

TEST(ProgressTextTest, AShareOutOfRangeStaysInTheBar) {
  EXPECT_EQ(ProgressText("run", 1.7, "", 3.0, 4), "run [####] 100 %");
  EXPECT_EQ(ProgressText("run", -1.0, "", 3.0, 4), "run [----]   0 %");
}

}  // namespace
}  // namespace sidestep::progress_test
