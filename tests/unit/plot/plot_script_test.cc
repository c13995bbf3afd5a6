// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/plot_script.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <utility>

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

// The two ends of the range that a script sets.
std::pair<double, double> RangeOf(const plot::Span& span) {
  const std::string lines = plot::AxisLines("y", span, 20.0);
  double from = 0.0, to = 0.0;
  EXPECT_EQ(std::sscanf(lines.c_str(), "set yrange [%lf:%lf]", &from, &to), 2) << lines;
  return {from, to};
}

TEST(PlotScriptTest, AnAxisHoldsWhatMoves) {
  for (const plot::Span& span :
       {plot::Span{0.0, 2e-6}, {-3.0, 5.0}, {0.62, 0.6202}, {1000.0, 1001.0}}) {
    const auto [from, to] = RangeOf(span);
    EXPECT_LT(from, span.min);
    EXPECT_GT(to, span.max);
    EXPECT_LT(to - from, 1.2 * span.length()) << span.max << ": and little else";
  }
}

TEST(PlotScriptTest, WhatMovesLessThanItsNumbersTellStandsStill) {
  for (const plot::Span& span : {plot::Span{1000.0, 1000.002},
                                 {-80000.01, -80000.0},
                                 {1e6, 1e6 + 0.1},
                                 {5e-7, 8e-7},
                                 {3.0, 3.0},
                                 {0.0, 0.0}}) {
    const auto [from, to] = RangeOf(span);
    EXPECT_LT(from, span.min);
    EXPECT_GT(to, span.max);
    EXPECT_GT(to - from, 100.0 * span.length()) << span.max << ": a flat line";
    EXPECT_GT(to - from, 0.0) << span.max;
  }
}

}  // namespace
}  // namespace sidestep::plot_script_test
