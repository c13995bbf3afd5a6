// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/plot_script.h"

#include <gtest/gtest.h>

namespace sidestep::plot_script_test {
namespace {

using plot::NiceStep;

TEST(PlotScriptTest, ANiceStepIsTheNextOfOneTwoAndFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(NiceStep(1.0), 1.0);
  EXPECT_DOUBLE_EQ(NiceStep(1.01), 2.0);
  EXPECT_DOUBLE_EQ(NiceStep(2.0), 2.0);
  EXPECT_DOUBLE_EQ(NiceStep(3.0), 5.0);
  EXPECT_DOUBLE_EQ(NiceStep(5.1), 10.0);
  EXPECT_DOUBLE_EQ(NiceStep(9.9), 10.0);
  EXPECT_DOUBLE_EQ(NiceStep(12345.0), 20000.0);
  EXPECT_DOUBLE_EQ(NiceStep(0.04), 0.05) << "a fifth of 0.2";
  EXPECT_DOUBLE_EQ(NiceStep(0.0011), 0.002);
}

TEST(PlotScriptTest, RoundingMakesNoStepTheNextOne) {
  EXPECT_DOUBLE_EQ(NiceStep(0.2 + 1e-12), 0.2);
  EXPECT_DOUBLE_EQ(NiceStep(0.5 / 10.0 + 1e-13), 0.05);
  EXPECT_DOUBLE_EQ(NiceStep(0.2 + 1e-8), 0.5) << "that is no rounding";
}

}  // namespace
}  // namespace sidestep::plot_script_test
