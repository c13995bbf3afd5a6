// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/nominal_gait.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "models/support/require.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::nominal_gait_test {
namespace {

constexpr Tick kEnd = 8000;

NominalGait Build(const std::vector<GaitParams>& segments, int num_feet) {
  return BuildNominalGait(segments, Geometry(num_feet), kEnd, kTick_s);
}

NominalGait Walking() {
  return Build({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kWalk, 1.0)}, 2);
}

NominalGait Running() {
  return Build({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kRun, 1.0)}, 2);
}

/// Contacts of all feet by landing, without those from the start; and the foot of each.
std::map<int, std::pair<std::size_t, PlannedContact>> Landings(const NominalGait& gait) {
  std::map<int, std::pair<std::size_t, PlannedContact>> landings;
  for (std::size_t foot = 0; foot < gait.feet.size(); ++foot) {
    for (std::size_t i = 1; i < gait.feet[foot].size(); ++i) {
      const NominalContact& nominal = gait.feet[foot][i];
      EXPECT_EQ(landings.count(nominal.sequence), 0U) << nominal.sequence;
      landings[nominal.sequence] = {foot, nominal.contact};
    }
  }
  return landings;
}

TEST(NominalGaitTest, EveryGaitStartsWithBothFeetDownSideBySide) {
  for (const NominalGait& gait : {Walking(), Running()}) {
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const NominalContact& first = gait.feet[foot].front();
      EXPECT_EQ(first.sequence, 0);
      EXPECT_EQ(first.contact.start_tick, 0);
      const Eigen::Vector3d place(0.0, foot == 0 ? 0.08 : -0.08, kSoleHeight_m);
      EXPECT_LT((first.contact.nominal_p_WF - place).norm(), 1e-12);
    }
  }
}

TEST(NominalGaitTest, LandingsAreCountedInTheirOrderOfTime) {
  for (const NominalGait& gait : {Walking(), Running()}) {
    int expected = 1;
    Tick last = 0;
    for (const auto& [sequence, landing] : Landings(gait)) {
      EXPECT_EQ(sequence, expected++);
      EXPECT_GT(landing.second.start_tick, last);
      last = landing.second.start_tick;
    }
    EXPECT_GT(expected, 8) << "hardly a gait";
  }
}

TEST(NominalGaitTest, IndicesCountEachFootsContacts) {
  const NominalGait gait = Walking();
  for (const auto& contacts : gait.feet) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      EXPECT_EQ(contacts[i].contact.index, static_cast<int>(i));
    }
  }
}

TEST(NominalGaitTest, FeetAlternateLeftFirst) {
  for (const NominalGait& gait : {Walking(), Running()}) {
    std::size_t foot = 0;
    for (const auto& [sequence, landing] : Landings(gait)) {
      EXPECT_EQ(landing.first, foot) << sequence;
      foot = 1 - foot;
    }
  }
}

TEST(NominalGaitTest, EachLandingIsAStepLengthAheadAndHalfAWidthAside) {
  for (const NominalGait& gait : {Walking(), Running()}) {
    for (const auto& [sequence, landing] : Landings(gait)) {
      const Eigen::Vector3d place(0.1 * sequence, landing.first == 0 ? 0.08 : -0.08, kSoleHeight_m);
      EXPECT_LT((landing.second.nominal_p_WF - place).norm(), 1e-12) << sequence;
      EXPECT_EQ(landing.second.adjusted_p_WF, landing.second.nominal_p_WF);
    }
  }
}

TEST(NominalGaitTest, WalkingPutsDoubleSupportBeforeEverySingleSupport) {
  const std::vector<Support> supports = Supports(Walking(), 1000, kEnd);
  ASSERT_GT(supports.size(), 10U);
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const bool is_single = i % 2 == 0;  // the double support at 1 s is cut off by the window
    EXPECT_EQ(supports[i].feet, is_single ? 1 : 2);
    EXPECT_EQ(supports[i].ticks, is_single ? 600 : 200);
  }
}

TEST(NominalGaitTest, StandingLastsUntilTheWalksFirstDoubleSupportEnds) {
  const NominalGait gait = Walking();
  for (Tick tick = 0; tick < 1200; ++tick) ASSERT_EQ(FeetDown(gait, tick), 2) << tick;
  EXPECT_EQ(FeetDown(gait, 1200), 1);
  EXPECT_EQ(ContactAt(gait, 0, 1200), nullptr) << "the left foot goes first";
}

TEST(NominalGaitTest, RunningAlternatesOneFootAndFlight) {
  const std::vector<Support> supports = Supports(Running(), 1000, kEnd);
  ASSERT_GT(supports.size(), 10U);
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const bool is_flight = i % 2 == 0;
    EXPECT_EQ(supports[i].feet, is_flight ? 0 : 1);
    EXPECT_EQ(supports[i].ticks, is_flight ? 150 : 250);
  }
}

TEST(NominalGaitTest, StandThenHopLeavesAfterOneStanceAndKeepsItsPeriods) {
  const NominalGait gait = Build({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kHop, 0.5)}, 1);
  const auto& contacts = gait.feet[0];
  EXPECT_EQ(contacts[0].contact.start_tick, 0);
  EXPECT_EQ(contacts[0].contact.end_tick, 500 + 250);
  ASSERT_GT(contacts.size(), 10U);
  for (std::size_t i = 1; i + 1 < contacts.size(); ++i) {
    const PlannedContact& contact = contacts[i].contact;
    EXPECT_EQ(contact.start_tick, 500 + 400 * static_cast<Tick>(i));
    EXPECT_EQ(contact.end_tick, contact.start_tick + 250);
    EXPECT_NEAR(contact.nominal_p_WF.x(), 0.1 * static_cast<double>(i), 1e-12);
    EXPECT_EQ(contact.nominal_p_WF.y(), 0.0);
  }
}

TEST(NominalGaitTest, WalkingIntoARunEndsWithFlightAndNoMoreDoubleSupport) {
  const NominalGait gait = Build(
      {Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kWalk, 0.5), Stretch(GaitType::kRun, 3.0)},
      2);
  const std::vector<Support> supports = Supports(gait, 500, kEnd);
  const auto first_flight =
      std::find_if(supports.begin(), supports.end(), [](const Support& s) { return s.feet == 0; });
  ASSERT_NE(first_flight, supports.end());
  ASSERT_GT(first_flight - supports.begin(), 3);
  for (auto support = first_flight; support != supports.end(); ++support) {
    EXPECT_LT(support->feet, 2);
  }
  // The rear foot is still down when the run begins: it leaves before the front foot's stance ends.
  const Support& last_single = *(first_flight - 1);
  const Support& last_double = *(first_flight - 2);
  EXPECT_EQ(last_single.feet, 1);
  EXPECT_EQ(last_double.feet, 2);
  EXPECT_EQ(last_single.ticks + last_double.ticks, 250) << "one stance of the run";
}

TEST(NominalGaitTest, RunningIntoAWalkNeverFliesAgain) {
  const NominalGait gait = Build(
      {Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kRun, 0.5), Stretch(GaitType::kWalk, 3.0)},
      2);
  Tick first_double = 3000;
  while (first_double < kEnd && FeetDown(gait, first_double) < 2) ++first_double;
  ASSERT_LT(first_double, 3000 + 400 + 600) << "a step of the run and a swing after 3 s";
  for (Tick tick = first_double; tick < kEnd; ++tick) ASSERT_GT(FeetDown(gait, tick), 0) << tick;
  for (const Support& support : Supports(gait, first_double, kEnd)) {
    EXPECT_EQ(support.ticks, support.feet == 1 ? 600 : 200);
  }
}

TEST(NominalGaitTest, BackToStandClosesTheFeetAndStaysThere) {
  for (const GaitType type : {GaitType::kWalk, GaitType::kRun}) {
    const NominalGait gait = Build(
        {Stretch(GaitType::kStand, 0.0), Stretch(type, 0.5), Stretch(GaitType::kStand, 3.0)}, 2);
    const PlannedContact& left = gait.feet[0].back().contact;
    const PlannedContact& right = gait.feet[1].back().contact;
    EXPECT_EQ(left.nominal_p_WF.x(), right.nominal_p_WF.x());
    for (const PlannedContact& last : {left, right}) {
      EXPECT_FALSE(last.end_is_known);
      EXPECT_GE(last.end_tick, kEnd);
    }
    EXPECT_LE(std::max(left.start_tick, right.start_tick), 3000 + 800 + 800)
        << "a step may be under way at 3 s, and one closes the feet";
    const ComKnot& last = gait.com.back();
    EXPECT_TRUE(last.at_rest);
    EXPECT_NEAR(last.p_WC.x(), left.nominal_p_WF.x(), 1e-12);
  }
}

TEST(NominalGaitTest, TimesThatAreMultiplesOfTheGridStayOnIt) {
  GaitParams run = Stretch(GaitType::kRun, 3.0);
  run.stance_s = 0.3;  // its half, when the walk's rear foot leaves, is on the grid of 50 ms too
  const NominalGait gait = Build({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kWalk, 0.5),
                                  run, Stretch(GaitType::kWalk, 5.0)},
                                 2);
  for (const auto& contacts : gait.feet) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      EXPECT_EQ(contacts[i].contact.start_tick % 50, 0);
      if (contacts[i].contact.end_tick < kEnd) {
        EXPECT_EQ(contacts[i].contact.end_tick % 50, 0);
      }
      if (i > 0) {
        EXPECT_GE(contacts[i].contact.start_tick, contacts[i - 1].contact.end_tick);
      }
    }
  }
}

TEST(NominalGaitTest, RightFootsBoxIsTheLeftOnesMirrored) {
  const NominalGait gait = Walking();
  const PlannedContact& left = gait.feet[0][2].contact;
  const PlannedContact& right = gait.feet[1][2].contact;
  EXPECT_EQ(left.box_lower_m, Eigen::Vector3d(-0.1, -0.05, -0.01));
  EXPECT_EQ(left.box_upper_m, Eigen::Vector3d(0.2, 0.15, 0.02));
  EXPECT_EQ(right.box_lower_m, Eigen::Vector3d(-0.1, -0.15, -0.01));
  EXPECT_EQ(right.box_upper_m, Eigen::Vector3d(0.2, 0.05, 0.02));
}

TEST(NominalGaitTest, ComKnotsAdvanceInTimeAndLieBetweenTheFeetThatStand) {
  const NominalGait hop = Build({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kHop, 0.5)}, 1);
  for (const NominalGait& gait : {Walking(), Running(), hop}) {
    ASSERT_GT(gait.com.size(), 5U);
    for (std::size_t i = 0; i < gait.com.size(); ++i) {
      const ComKnot& knot = gait.com[i];
      if (i > 0) {
        EXPECT_GT(knot.tick, gait.com[i - 1].tick);
      }
      double x_sum_m = 0.0;
      int newest = 0;
      for (std::size_t foot = 0; foot < gait.feet.size(); ++foot) {
        const NominalContact* nominal = ContactAt(gait, foot, knot.tick);
        if (nominal == nullptr) continue;
        x_sum_m += nominal->contact.nominal_p_WF.x();
        newest = std::max(newest, nominal->sequence);
      }
      EXPECT_EQ(knot.p_WC.y(), 0.0);
      if (FeetDown(gait, knot.tick) == 0) {
        if (i + 1 == gait.com.size()) continue;
        const double between_m = 0.5 * (gait.com[i - 1].p_WC.x() + gait.com[i + 1].p_WC.x());
        EXPECT_NEAR(knot.p_WC.x(), between_m, 1e-12) << "in flight, at " << knot.tick;
        EXPECT_GT(knot.p_WC.z(), kComHeight_m);
        continue;
      }
      EXPECT_NEAR(knot.p_WC.x(), x_sum_m / FeetDown(gait, knot.tick), 1e-12) << knot.tick;
      EXPECT_LE(knot.p_WC.z(), kComHeight_m);
      EXPECT_EQ(knot.sequence, newest) << knot.tick;
    }
  }
}

TEST(NominalGaitTest, StandingOnlyHasTwoRestingKnots) {
  const NominalGait gait = Build({Stretch(GaitType::kStand, 0.0)}, 2);
  ASSERT_GE(gait.com.size(), 2U);
  for (const ComKnot& knot : gait.com) EXPECT_TRUE(knot.at_rest);
  EXPECT_EQ(FeetDown(gait, kEnd + 1000), 2);
}

TEST(NominalGaitTest, NoSegmentsBreakTheContract) { EXPECT_THROW(Build({}, 2), ContractViolation); }

}  // namespace
}  // namespace sidestep::nominal_gait_test
