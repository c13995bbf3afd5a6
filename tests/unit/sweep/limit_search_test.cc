// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/limit_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace sidestep::limit_search_test {
namespace {

LimitSpec Ladder() { return {"pushes.0.magnitude_N", {40, 80, 120, 160, 200, 240}, 5.0}; }

LimitResult Search(const std::function<bool(double)>& survives) {
  return SearchLimit(Ladder(), [&](double strength, SearchStage) {
    return survives(strength) ? Survival::kSurvived : Survival::kLost;
  });
}

TEST(LimitSearchTest, FindsAThresholdToTheResolution) {
  const LimitResult result = Search([](double strength) { return strength <= 137.0; });
  const Bracket bracket = BracketOf(result.tested);
  EXPECT_TRUE(result.is_complete);
  EXPECT_LE(bracket.survived, 137.0);
  EXPECT_GT(bracket.lost, 137.0);
  EXPECT_LE(bracket.lost - bracket.survived, 5.0);
  EXPECT_DOUBLE_EQ(bracket.ladder_share, 0.5);
}

// As measured once: 120 N and 200 to 280 N survived, 160 N not.
TEST(LimitSearchTest, WhatSurvivesAboveALossDoesNotRaiseTheLimit) {
  const LimitResult result =
      Search([](double strength) { return strength < 130.0 || strength > 190.0; });
  const Bracket bracket = BracketOf(result.tested);
  EXPECT_LT(bracket.survived, 130.0);
  EXPECT_GE(bracket.lost, 130.0);
  EXPECT_LE(bracket.lost, 135.0);
  EXPECT_NEAR(bracket.ladder_share, 5.0 / 6.0, 1e-12) << "160 alone is lost, and told";
}

TEST(LimitSearchTest, AConfirmationThatIsLostLowersTheLimit) {
  // A hole of the ladder's: only 0.75 of the limit, 140 or so, is in it.
  const LimitResult result = Search(
      [](double strength) { return strength < 187.0 && (strength < 130 || strength > 150); });
  const Bracket bracket = BracketOf(result.tested);
  EXPECT_EQ(result.tested[3].strength, 160.0);
  EXPECT_EQ(result.tested[3].survival, Survival::kSurvived);
  EXPECT_GT(bracket.lost, 130.0);
  EXPECT_LT(bracket.lost, 150.0);
  EXPECT_EQ(bracket.survived, 120.0) << "what is not proven is not told";
}

TEST(LimitSearchTest, AllAndNothingHaveOpenBrackets) {
  const LimitResult all = Search([](double) { return true; });
  EXPECT_TRUE(std::isinf(BracketOf(all.tested).lost));
  EXPECT_EQ(BracketOf(all.tested).survived, 240.0);
  const LimitResult nothing = Search([](double) { return false; });
  EXPECT_EQ(BracketOf(nothing.tested).survived, 0.0);
  EXPECT_LE(BracketOf(nothing.tested).lost, 5.0);
}

TEST(LimitSearchTest, NoStrengthIsTriedTwice) {
  std::multiset<double> tried;
  SearchLimit(Ladder(), [&](double strength, SearchStage) {
    tried.insert(strength);
    return strength < 161.0 ? Survival::kSurvived : Survival::kLost;
  });
  for (const double strength : tried) EXPECT_EQ(tried.count(strength), 1U) << strength;
}

TEST(LimitSearchTest, AnInvalidRunNeitherRaisesNorLowersTheLimit) {
  const LimitResult result = SearchLimit(Ladder(), [](double strength, SearchStage) {
    if (strength == 120.0) return Survival::kInvalid;
    return strength < 200.0 ? Survival::kSurvived : Survival::kLost;
  });
  const Bracket bracket = BracketOf(result.tested);
  EXPECT_EQ(bracket.survived, 80.0) << "120 was not shown to survive";
  EXPECT_GT(bracket.lost, 120.0);
  EXPECT_NEAR(bracket.ladder_share, 3.0 / 5.0, 1e-12);
}

TEST(LimitSearchTest, StopsWhereNothingIsKnown) {
  int asked = 0;
  const LimitResult result = SearchLimit(Ladder(), [&](double, SearchStage) {
    return ++asked < 3 ? Survival::kSurvived : Survival::kUnknown;
  });
  EXPECT_FALSE(result.is_complete);
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(result.tested.size(), 2U);
}

}  // namespace
}  // namespace sidestep::limit_search_test
