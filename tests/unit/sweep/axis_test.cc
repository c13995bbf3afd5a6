// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "tests/support/temp_folder.h"

namespace sidestep::axis_test {
namespace {

constexpr char kForce[] = "pushes.0.magnitude_N";
constexpr char kAngle[] = "pushes.0.direction_rad";

std::vector<std::string> Values(const std::string& assignment) {
  return ParseAxis("--vary", assignment).values;
}

std::string ErrorOf(const std::string& assignment) {
  return TempFolder().ErrorOf([&] { ParseAxis("--vary", assignment); });
}

std::string ErrorOfForce(const std::string& values) {
  return ErrorOf(std::string(kForce) + "=" + values);
}

TEST(AxisTest, NumbersMayBeMultiplesOfPi) {
  constexpr double kPi = std::numbers::pi;
  for (const auto& [text, value] : {std::pair<const char*, double>{"2pi", 2 * kPi},
                                    {"pi", kPi},
                                    {"-pi/4", -kPi / 4},
                                    {"3pi/2", 1.5 * kPi},
                                    {"0.5*pi", 0.5 * kPi},
                                    {"1.5e-3", 0.0015},
                                    {"+2", 2.0}}) {
    ASSERT_TRUE(ParseNumber(text)) << text;
    EXPECT_DOUBLE_EQ(*ParseNumber(text), value) << text;
  }
  for (const char* text : {"", "pie", "2pi2", "pi/0", "x", "1 2", "nan", "inf", "/2"}) {
    EXPECT_FALSE(ParseNumber(text)) << text;
  }
}

TEST(AxisTest, TheThirdPartIsACount) {
  EXPECT_EQ(Values("pushes.0.magnitude_N=20:120:5"),
            (std::vector<std::string>{"20", "45", "70", "95", "120"}));
}

TEST(AxisTest, AStepSaysSo) {
  EXPECT_EQ(Values("pushes.0.magnitude_N=0.1:0.5:step=0.1").size(), 5U) << "0.1 * 5 rounds up";
  EXPECT_EQ(Values("pushes.0.magnitude_N=20:50:step=20"), (std::vector<std::string>{"20", "40"}));
}

TEST(AxisTest, ValuesAreTheDecimalsThatAUserMeans) {
  EXPECT_EQ(Values("pushes.0.magnitude_mg=0.2:0.8:4"),
            (std::vector<std::string>{"0.2", "0.4", "0.6", "0.8"}));
  EXPECT_EQ(Values("pushes.0.magnitude_mg=0.1:0.3:step=0.1").back(), "0.3");
  EXPECT_EQ(Values("pushes.0.magnitude_mg=0:1:4")[1], "0.3333333333333333") << "no decimal";
}

TEST(AxisTest, AWholeTurnLeavesOutItsEnd) {
  const auto values = Values(std::string(kAngle) + "=0:2pi:4");
  ASSERT_EQ(values.size(), 4U);
  EXPECT_DOUBLE_EQ(*ParseNumber(values[3]), 1.5 * std::numbers::pi);
  EXPECT_EQ(Values(std::string(kAngle) + "=0:pi:3").back(), "3.141592653589793");
}

TEST(AxisTest, AListHoldsAnyValues) {
  EXPECT_EQ(Values("pushes.0.at_phase=[0.25, mid_swing]"),
            (std::vector<std::string>{"0.25", "mid_swing"}));
  EXPECT_EQ(Values("pushes.0.force_N=[[0, 5, 0], [5, 0, 0]]"),
            (std::vector<std::string>{"[0, 5, 0]", "[5, 0, 0]"}));
  EXPECT_EQ(Values(std::string(kAngle) + "=[pi/2]"),
            std::vector<std::string>{"1.5707963267948966"});
}

TEST(AxisTest, Errors) {
  const std::string option = "--vary pushes.0.magnitude_N=";
  EXPECT_EQ(
      ErrorOf("pushes.0.magnitud_N=1:2:3"),
      "--vary pushes.0.magnitud_N=1:2:3: error: pushes.magnitud_N is not a known key; did you "
      "mean 'magnitude_N'?");
  EXPECT_EQ(ErrorOfForce("2:1:3"),
            option +
                "2:1:3: error: pushes.0.magnitude_N = 2:1:3 is an empty range: it must go "
                "upwards");
  EXPECT_EQ(ErrorOfForce("1:2:0.5"),
            option +
                "1:2:0.5: error: pushes.0.magnitude_N = 1:2:0.5: '0.5' must be a count, a "
                "whole number; for steps write a:b:step=s");
  EXPECT_EQ(ErrorOfForce("1:2:1"),
            option +
                "1:2:1: error: pushes.0.magnitude_N = 1:2:1: a count must be from 2 to "
                "1000000");
  EXPECT_EQ(ErrorOfForce("1:2:sobol=3"),
            option +
                "1:2:sobol=3: error: pushes.0.magnitude_N = 1:2:sobol=3: 'sobol' is not "
                "known; a range ends in n, step=s, random=n or latin=n");
  EXPECT_EQ(ErrorOfForce("[]"),
            option + "[]: error: pushes.0.magnitude_N = [] is empty: it has no values");
  EXPECT_EQ(ErrorOfForce("5"),
            option +
                "5: error: pushes.0.magnitude_N must be a:b:n, a:b:step=s, a:b:random=n, "
                "a:b:latin=n or a list; one value goes under set");
  EXPECT_EQ(ErrorOf("control.mpc.box_lower_m.1=[0]"), "no error") << "an entry of a vector";
}

TEST(AxisTest, ALatinHypercubeHasOneDrawInEachPart) {
  std::vector<Axis> axes;
  for (const char* text : {"world.friction=0.2:1.2:latin=10", "world.mass_scale=0.9:1.1:latin=10",
                           "pushes.0.start_s=1:2:random=3"}) {
    axes.push_back(ParseAxis("--vary", text));
  }
  const auto rows = DrawAxes(axes, AxisKind::kLatin, 1);
  ASSERT_EQ(rows.size(), 10U);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    std::set<int> parts;
    for (const auto& row : rows) {
      ASSERT_EQ(row.size(), 2U);
      const double share = (row[axis] - axes[axis].min) / (axes[axis].max - axes[axis].min);
      parts.insert(static_cast<int>(std::floor(share * 10.0)));
    }
    EXPECT_EQ(parts.size(), 10U) << axes[axis].key;
  }
  EXPECT_EQ(DrawAxes(axes, AxisKind::kLatin, 1), rows) << "the seed decides";
  EXPECT_NE(DrawAxes(axes, AxisKind::kLatin, 2), rows);
  EXPECT_EQ(DrawAxes(axes, AxisKind::kRandom, 1).size(), 3U);
}

}  // namespace
}  // namespace sidestep::axis_test
