// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/expectations.h"

#include <gtest/gtest.h>

#include <limits>

namespace sidestep::expectations_test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool Passes(const Expectation& expectation, const MetricValue& value) {
  return CheckExpectations({expectation}, {{expectation.metric, value}}).at(0).pass;
}

TEST(ExpectationsTest, BoundsAreInclusive) {
  const Expectation between{"m", 1.0, 2.0, {}};
  EXPECT_TRUE(Passes(between, 1.0));
  EXPECT_TRUE(Passes(between, 2.0));
  EXPECT_FALSE(Passes(between, 0.999));
  EXPECT_FALSE(Passes(between, 2.001));
}

TEST(ExpectationsTest, WhatWasNotMeasuredMeetsNoBound) {
  EXPECT_FALSE(Passes({"m", {}, 1e9, {}}, kNaN));
  EXPECT_FALSE(Passes({"m", -1e9, {}, {}}, kNaN));
}

TEST(ExpectationsTest, WhatNeverCameMeetsNoUpperBound) {
  EXPECT_FALSE(Passes({"m", {}, 1e9, {}}, kInfinity));
  EXPECT_TRUE(Passes({"m", 3.0, {}, {}}, kInfinity));
}

TEST(ExpectationsTest, TruthValuesAreComparedAsSuch) {
  EXPECT_TRUE(Passes({"m", {}, {}, false}, false));
  EXPECT_FALSE(Passes({"m", {}, {}, false}, true));
  EXPECT_FALSE(Passes({"m", {}, {}, true}, 1.0));
  EXPECT_FALSE(Passes({"m", 0.0, {}, {}}, true));
}

TEST(ExpectationsTest, UnknownMetricMeetsNothingAndIsNamed) {
  const auto results = CheckExpectations({{"wit", {}, 1.0, {}}}, {{"fall", false}});
  EXPECT_FALSE(results.at(0).pass);
  EXPECT_EQ(Describe(results.at(0)), "wit is no metric");
}

TEST(ExpectationsTest, DescriptionTellsMeasureAndBounds) {
  const auto described = [](const Expectation& expectation, const MetricValue& value) {
    return Describe(CheckExpectations({expectation}, {{expectation.metric, value}}).at(0));
  };
  EXPECT_EQ(described({"m", 1.0, 2.0, {}}, 2.5), "m is 2.5, expected at least 1 and at most 2");
  EXPECT_EQ(described({"m", {}, 2.0, {}}, kInfinity), "m is never, expected at most 2");
  EXPECT_EQ(described({"m", {}, 2.0, {}}, kNaN), "m is not measured, expected at most 2");
  EXPECT_EQ(described({"fall", {}, {}, false}, true), "fall is true, expected false");
}

TEST(ExpectationsTest, OnlyAnExpectedTrueCountsAsExpected) {
  EXPECT_TRUE(Expects({{"fall", {}, {}, true}}, "fall"));
  EXPECT_FALSE(Expects({{"fall", {}, {}, false}}, "fall"));
  EXPECT_FALSE(Expects({{"slip", {}, {}, true}}, "fall"));
}

}  // namespace
}  // namespace sidestep::expectations_test
