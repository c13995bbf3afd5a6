// SPDX-License-Identifier: BSD-3-Clause
// Walking and running aside: step_side_m, to the left where it is positive.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::sideways_gait_test {
namespace {

constexpr Tick kEnd = 8000;
constexpr double kHalfWidth_m = 0.08;
constexpr double kRounding = 1e-12;

/// On the spot, then aside from 1 s on.
NominalGait Aside(GaitType type, double step_side_m, double step_length_m = 0.0) {
  GaitParams aside = Stretch(type, 1.0);
  aside.step_side_m = step_side_m;
  aside.step_length_m = step_length_m;
  return BuildNominalGait({Stretch(GaitType::kStand, 0.0), aside}, Geometry(2), kEnd, kTick_s);
}

/// Contacts after the start by their landing, each with its foot.
std::map<int, std::pair<std::size_t, NominalContact>> Landings(const NominalGait& gait) {
  std::map<int, std::pair<std::size_t, NominalContact>> landings;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    for (const NominalContact& contact : gait.feet[foot]) {
      if (contact.sequence > 0) landings[contact.sequence] = {foot, contact};
    }
  }
  return landings;
}

double Y(const NominalContact& contact) { return contact.contact.nominal_p_WF.y(); }

class SidewaysGaitTest : public testing::TestWithParam<std::pair<GaitType, double>> {
 protected:
  const double side_m_{GetParam().second};
  const NominalGait gait_{Aside(GetParam().first, side_m_)};
};

TEST_P(SidewaysGaitTest, EveryLandingIsAStepFurtherAsideAndHalfAWidthFromThePath) {
  const auto landings = Landings(gait_);
  ASSERT_GT(landings.size(), 6U);
  for (const auto& [sequence, landing] : landings) {
    const double half_width_m = landing.first == 0 ? kHalfWidth_m : -kHalfWidth_m;
    EXPECT_NEAR(Y(landing.second), side_m_ * sequence + half_width_m, kRounding) << sequence;
    EXPECT_EQ(landing.second.contact.nominal_p_WF.x(), 0.0) << sequence;
    EXPECT_EQ(landing.second.contact.adjusted_p_WF, landing.second.contact.nominal_p_WF);
  }
}

TEST_P(SidewaysGaitTest, BothFeetAdvanceByTwoStepsFromOneLandingToTheirNext) {
  for (const auto& contacts : gait_.feet) {
    ASSERT_GT(contacts.size(), 4U);
    for (std::size_t i = 2; i < contacts.size(); ++i) {
      EXPECT_NEAR(Y(contacts[i]) - Y(contacts[i - 1]), 2.0 * side_m_, kRounding) << i;
    }
  }
}

TEST_P(SidewaysGaitTest, FeetAreAWidthApartOnAverageAndNeverCross) {
  const auto landings = Landings(gait_);
  double apart_m = 0.0;
  int pairs = 0;
  for (int sequence = 2; landings.contains(sequence + 1); sequence += 2, ++pairs) {
    // A left landing between two right ones: nearer the one, farther from the other.
    const NominalContact& before = landings.at(sequence - 1).second;
    const NominalContact& at = landings.at(sequence).second;
    const NominalContact& after = landings.at(sequence + 1).second;
    const double to_before_m = std::abs(Y(at) - Y(before));
    const double to_after_m = std::abs(Y(at) - Y(after));
    apart_m += 0.5 * (to_before_m + to_after_m);
    EXPECT_NEAR(std::abs(to_before_m - to_after_m), 2.0 * std::abs(side_m_), kRounding);
    EXPECT_GT(std::min(to_before_m, to_after_m), 0.1);
  }
  EXPECT_NEAR(apart_m / pairs, 2.0 * kHalfWidth_m, kRounding);
}

TEST_P(SidewaysGaitTest, ComKnotsOnBothFeetAreInTheirMiddleAndOnOneFootOnThePath) {
  int on_both = 0, on_one = 0;
  for (std::size_t i = 0; i < gait_.com.size(); ++i) {
    const ComKnot& knot = gait_.com[i];
    const NominalContact* left = ContactAt(gait_, 0, knot.tick);
    const NominalContact* right = ContactAt(gait_, 1, knot.tick);
    if (left != nullptr && right != nullptr) {
      EXPECT_NEAR(knot.p_WC.y(), 0.5 * (Y(*left) + Y(*right)), kRounding) << knot.tick;
      ++on_both;
    } else if (left != nullptr || right != nullptr) {
      const double path_m = left != nullptr ? Y(*left) - kHalfWidth_m : Y(*right) + kHalfWidth_m;
      EXPECT_NEAR(knot.p_WC.y(), path_m, kRounding) << knot.tick;
      ++on_one;
    } else {
      ASSERT_EQ(GetParam().first, GaitType::kRun) << "in flight";
      if (i + 1 == gait_.com.size()) continue;
      const double between_m = 0.5 * (gait_.com[i - 1].p_WC.y() + gait_.com[i + 1].p_WC.y());
      EXPECT_NEAR(knot.p_WC.y(), between_m, kRounding) << knot.tick;
    }
  }
  EXPECT_GT(GetParam().first == GaitType::kRun ? on_one : on_both, 5);
}

INSTANTIATE_TEST_SUITE_P(Gaits, SidewaysGaitTest,
                         testing::Values(std::pair(GaitType::kWalk, 0.03),
                                         std::pair(GaitType::kWalk, -0.02),
                                         std::pair(GaitType::kRun, 0.025)));

TEST(SidewaysWalkTest, LengthAndSideAdvanceTogether) {
  for (const auto& [sequence, landing] : Landings(Aside(GaitType::kWalk, 0.02, 0.1))) {
    EXPECT_NEAR(landing.second.contact.nominal_p_WF.x(), 0.1 * sequence, kRounding);
    EXPECT_NEAR(Y(landing.second),
                0.02 * sequence + (landing.first == 0 ? kHalfWidth_m : -kHalfWidth_m), kRounding);
  }
}

TEST(SidewaysWalkTest, ReferenceGoesAsideAtTheGaitsMeanSpeed) {
  const NominalGait gait = Aside(GaitType::kWalk, 0.03);
  const auto reference_at = [&](Tick tick) { return NominalComAt(gait, tick, kTick_s); };
  // From the middle of one double support to that of the next: a step of 0.03 m in 0.8 s.
  for (const Tick middle : {2700, 3500, 4300}) {
    const double from_m = reference_at(middle).p_WC.y();
    EXPECT_NEAR(reference_at(middle + 800).p_WC.y() - from_m, 0.03, kRounding) << middle;
    EXPECT_NEAR(reference_at(middle).v_WC.y(), 0.03 / 0.8, kRounding) << middle;
  }
}

TEST(SidewaysWalkTest, WalkingOnTheSpotAfterwardsStaysThere) {
  GaitParams aside = Stretch(GaitType::kWalk, 0.0), on_the_spot = Stretch(GaitType::kWalk, 4.0);
  aside.step_side_m = 0.03;
  aside.step_length_m = on_the_spot.step_length_m = 0.0;
  const NominalGait gait = BuildNominalGait({aside, on_the_spot}, Geometry(2), kEnd, kTick_s);
  // Five steps of 0.8 s begin before 4 s.
  for (const auto& [sequence, landing] : Landings(gait)) {
    const double path_m = 0.03 * std::min(sequence, 5);
    EXPECT_NEAR(Y(landing.second), path_m + (landing.first == 0 ? kHalfWidth_m : -kHalfWidth_m),
                kRounding)
        << sequence;
  }
  EXPECT_NEAR(gait.com.back().p_WC.y(), 0.15, kRounding);
}

TEST(SidewaysWalkTest, StandingAfterwardsBringsTheFeetTogetherAndRests) {
  GaitParams aside = Stretch(GaitType::kWalk, 0.0);
  aside.step_side_m = 0.03;
  const NominalGait gait =
      BuildNominalGait({aside, Stretch(GaitType::kStand, 3.0)}, Geometry(2), kEnd, kTick_s);
  const Tick last_landing =
      std::max(gait.feet[0].back().contact.start_tick, gait.feet[1].back().contact.start_tick);
  EXPECT_LE(last_landing, 3000 + 2 * 800)
      << "a step under way at 3 s, and one that closes the feet";
  EXPECT_NEAR(Y(gait.feet[0].back()) - Y(gait.feet[1].back()), 2.0 * kHalfWidth_m, kRounding);
  EXPECT_TRUE(gait.com.back().at_rest);
}

}  // namespace
}  // namespace sidestep::sideways_gait_test
