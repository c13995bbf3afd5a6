// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/gait_generator.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "models/support/require.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::gait_generator_test {
namespace {

constexpr Tick kEnd = 9000;
constexpr Tick kHorizon = 1100;

struct Gait {
  std::string name;
  std::vector<GaitParams> segments;
  int num_feet{2};
  double com_sway{0.0};

  friend void PrintTo(const Gait& gait, std::ostream* out) { *out << gait.name; }
};

GaitParams Aside(GaitParams gait, double step_side_m) {
  gait.step_side_m = step_side_m;
  gait.step_length_m = 0.0;
  return gait;
}

// Supports shorter than a tick's half, longer than the horizon, and all changes of gait.
std::vector<Gait> Gaits() {
  const GaitParams stand = Stretch(GaitType::kStand, 0.0), hop = Stretch(GaitType::kHop, 0.5);
  GaitParams slow = Stretch(GaitType::kWalk, 0.0), quick = Stretch(GaitType::kRun, 2.0);
  slow.swing_s = 1.0;
  slow.double_support_s = 1.3;
  quick.stance_s = 0.05;
  quick.flight_s = 0.05;
  GaitParams far = hop;
  far.flight_s = 1.5;
  return {
      {"stand", {stand}},
      {"walk", {stand, Stretch(GaitType::kWalk, 1.0)}},
      {"walk_at_once", {Stretch(GaitType::kWalk, 0.0)}},
      {"run", {stand, Stretch(GaitType::kRun, 1.0)}},
      {"hop", {stand, hop}, 1},
      {"hop_far", {stand, far}, 1},
      {"hop_and_stand", {stand, hop, Stretch(GaitType::kStand, 4.0)}, 1},
      {"walk_run_stand",
       {Stretch(GaitType::kWalk, 0.0), Stretch(GaitType::kRun, 3.0),
        Stretch(GaitType::kStand, 6.0)}},
      {"run_walk_stand_walk",
       {stand, Stretch(GaitType::kRun, 0.5), Stretch(GaitType::kWalk, 3.0),
        Stretch(GaitType::kStand, 5.0), Stretch(GaitType::kWalk, 7.5)}},
      {"sideways_and_stand",
       {Aside(Stretch(GaitType::kWalk, 0.0), 0.03), Stretch(GaitType::kStand, 4.0)}},
      {"slow_and_quick", {slow, quick}},
      {"sway", {stand, Stretch(GaitType::kWalk, 0.7), Stretch(GaitType::kStand, 5.0)}, 2, 0.3},
  };
}

class GaitGeneratorTest : public testing::TestWithParam<Gait> {
 protected:
  GaitGeneratorTest() : setup_(SetupOf(GetParam().segments, GetParam().num_feet)) {
    setup_.geometry.sway.share = GetParam().com_sway;
    film_ = BuildNominalGait(setup_.segments, setup_.geometry, kEnd + 5 * kHorizon, kTick_s);
  }

  GaitSetup setup_;
  NominalGait film_;
};

// What the schedule at `tick` must hold of the film's contacts of a foot.
std::vector<const NominalContact*> Ahead(const std::vector<NominalContact>& contacts, Tick tick) {
  std::vector<const NominalContact*> ahead;
  for (const NominalContact& nominal : contacts) {
    if (nominal.contact.end_tick <= tick) continue;
    if (nominal.contact.start_tick <= tick + kHorizon || ahead.empty()) ahead.push_back(&nominal);
  }
  return ahead;
}

bool IsSame(const NominalContact& made, const NominalContact& filmed, Tick tick) {
  const PlannedContact& a = made.contact;
  const PlannedContact& b = filmed.contact;
  const bool same_end = b.end_is_known ? a.end_tick == b.end_tick : a.end_tick > tick + kHorizon;
  return made.sequence == filmed.sequence && a.index == b.index && a.start_tick == b.start_tick &&
         a.end_is_known == b.end_is_known && same_end && a.nominal_p_WF == b.nominal_p_WF &&
         a.adjusted_p_WF == b.adjusted_p_WF && a.box_lower_m == b.box_lower_m &&
         a.box_upper_m == b.box_upper_m;
}

bool IsSame(const ComReference& made, const ComReference& filmed) {
  return made.p_WC == filmed.p_WC && made.v_WC == filmed.v_WC && made.a_WC == filmed.a_WC;
}

TEST_P(GaitGeneratorTest, ScheduleOfEveryTickIsThatStretchOfTheNominalGait) {
  GaitSupport support = StandingSupport(setup_);
  auto next = NextSupport(setup_, support);
  ContactSchedule schedule;
  for (Tick tick = 0; tick < kEnd; ++tick) {
    if (next && next->tick <= tick) {
      support = *next;
      next = NextSupport(setup_, support);
    }
    GenerateSchedule(setup_, support, tick, kHorizon, &schedule);
    ASSERT_EQ(schedule.feet.size(), film_.feet.size());
    for (std::size_t foot = 0; foot < film_.feet.size(); ++foot) {
      const auto ahead = Ahead(film_.feet[foot], tick);
      ASSERT_EQ(schedule.feet[foot].size(), ahead.size()) << foot << " at " << tick;
      for (std::size_t i = 0; i < ahead.size(); ++i) {
        ASSERT_TRUE(IsSame(schedule.feet[foot][i], *ahead[i], tick))
            << "contact " << ahead[i]->contact.index << " of foot " << foot << " at " << tick;
      }
    }
    for (const Tick ask : {tick, tick + 430, tick + kHorizon}) {
      ASSERT_TRUE(IsSame(NominalComAt(schedule, ask, kTick_s), NominalComAt(film_, ask, kTick_s)))
          << ask << " from " << tick;
    }
  }
}

TEST_P(GaitGeneratorTest, HoldsNoMoreKnotsAndContactsThanAHorizonNeeds) {
  ContactSchedule schedule;
  GenerateSchedule(setup_, SupportAt(setup_, kEnd), kEnd, kHorizon, &schedule);
  EXPECT_LE(schedule.com.size(), 2U * kHorizon / 100U + 8U) << "quickest: 100 ticks a step";
}

INSTANTIATE_TEST_SUITE_P(Gaits, GaitGeneratorTest, testing::ValuesIn(Gaits()),
                         [](const auto& gait) { return gait.param.name; });

TEST(NextSupportTest, BeginsStandingWithIndicesAndLandingZero) {
  const GaitSupport begin = StandingSupport(SetupOf({Stretch(GaitType::kWalk, 0.0)}, 2));
  EXPECT_EQ(begin.tick, 0);
  EXPECT_EQ(begin.sequence, 0);
  for (const FootSupport& foot : begin.feet) {
    EXPECT_TRUE(foot.stands());
    EXPECT_EQ(foot.nominal.contact.index, 0);
    EXPECT_EQ(foot.nominal.sequence, 0);
  }
}

TEST(NextSupportTest, WalksOnFromTouchDownToTouchDown) {
  const GaitSetup setup =
      SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kWalk, 1.0)}, 2);
  EXPECT_EQ(SupportAt(setup, 999).tick, 0);
  EXPECT_EQ(SupportAt(setup, 1000).sequence, 0) << "a stand ends without a landing";
  // A double support of 0.2 s and a swing of 0.6 s a step.
  const GaitSupport first = SupportAt(setup, 1800), third = SupportAt(setup, 3999);
  EXPECT_EQ(first.tick, 1800);
  EXPECT_EQ(first.sequence, 1);
  EXPECT_EQ(first.next_foot, 1);
  EXPECT_EQ(third.tick, 3400);
  EXPECT_EQ(third.sequence, 3);
  EXPECT_NEAR(third.path_x_m, 0.3, 1e-15);
  EXPECT_TRUE(third.feet[0].stands() && third.feet[1].stands());
}

TEST(NextSupportTest, StandingForGoodLeadsNowhere) {
  const GaitSetup setup =
      SetupOf({Stretch(GaitType::kWalk, 0.0), Stretch(GaitType::kStand, 1.0)}, 2);
  const GaitSupport last = SupportAt(setup, 1000000);
  EXPECT_EQ(last.sequence, 3) << "two landings before 1 s of walk are over, and the closing step";
  EXPECT_FALSE(NextSupport(setup, last).has_value());
}

TEST(NextSupportTest, NoLengthOfAnEpisodeEndsAWalk) {
  const GaitSetup setup = SetupOf({Stretch(GaitType::kWalk, 0.0)}, 2);
  EXPECT_EQ(SupportAt(setup, 8000000).sequence, 10000);
}

TEST(NextSupportTest, GaitForOtherFeetBreaksTheContract) {
  for (const auto& [type, num_feet] : {std::pair(GaitType::kHop, 2), std::pair(GaitType::kWalk, 1),
                                       std::pair(GaitType::kRun, 1)}) {
    const GaitSetup setup = SetupOf({Stretch(type, 0.0)}, num_feet);
    EXPECT_THROW(NextSupport(setup, StandingSupport(setup)), ContractViolation);
  }
  EXPECT_THROW(StandingSupport(SetupOf({}, 2)), ContractViolation);
}

}  // namespace
}  // namespace sidestep::gait_generator_test
