// SPDX-License-Identifier: BSD-3-Clause
// What every course must keep, at every moment of a walk; and that those one looks for are there.
#include "controller/planner/timing_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "controller/planner/gait_generator.h"
#include "tests/unit/planner/planner_test_support.h"

namespace sidestep::timing_candidates_test {
namespace {

constexpr Tick kHorizon = 3000;
const TimingLimits kLimits;

// Walks from 1 s on: 0.2 s on both feet, 0.6 s on one; the left foot begins.
const GaitSetup kWalk = SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kWalk, 1.0)}, 2);
constexpr Tick kBothFeet = 1060, kLeftFlies = 1300;

std::vector<GaitSupport> CandidatesAt(const GaitSetup& setup, Tick now) {
  std::vector<GaitSupport> candidates;
  ListTimingCandidates(setup, SupportAt(setup, now), now, kLimits, &candidates);
  return candidates;
}

ContactSchedule ScheduleOf(const GaitSupport& support, Tick now) {
  ContactSchedule schedule;
  GenerateSchedule(kWalk, support, now, kHorizon, &schedule);
  return schedule;
}

// Of the first contact of `foot` to begin after `now`.
Tick NextLanding(const ContactSchedule& schedule, std::size_t foot, Tick now) {
  for (const NominalContact& nominal : schedule.feet[foot]) {
    if (nominal.contact.start_tick > now) return nominal.contact.start_tick;
  }
  return -1;
}

// Of the first contact of `foot` to end after `now`.
Tick NextLiftOff(const ContactSchedule& schedule, std::size_t foot, Tick now) {
  for (const NominalContact& nominal : schedule.feet[foot]) {
    if (nominal.contact.end_is_known && nominal.contact.end_tick > now) {
      return nominal.contact.end_tick;
    }
  }
  return -1;
}

template <typename Predicate>
bool AnySchedule(Tick now, Predicate&& predicate) {
  const std::vector<GaitSupport> candidates = CandidatesAt(kWalk, now);
  return std::any_of(candidates.begin(), candidates.end(), [&](const GaitSupport& candidate) {
    return predicate(ScheduleOf(candidate, now));
  });
}

TEST(TimingCandidatesTest, AtEveryMomentTheyKeepWhatIsAndWhatFeetCanDo) {
  for (Tick now = 1001; now < 3000; now += 7) {
    const ContactSchedule original = ScheduleOf(SupportAt(kWalk, now), now);
    ASSERT_LE(CandidatesAt(kWalk, now).size(), MostTimingCandidates(kWalk, kLimits)) << now;
    for (const GaitSupport& candidate : CandidatesAt(kWalk, now)) {
      const ContactSchedule schedule = ScheduleOf(candidate, now);
      for (std::size_t foot = 0; foot < 2; ++foot) {
        const NominalContact* stands = ContactAt(original, foot, now);
        ASSERT_EQ(ContactAt(schedule, foot, now) != nullptr, stands != nullptr) << now;
        if (stands == nullptr) {
          EXPECT_GE(NextLanding(schedule, foot, now), now + kLimits.least_rest) << now;
        }
        for (std::size_t i = 1; i < schedule.feet[foot].size(); ++i) {
          const Tick swing = schedule.feet[foot][i].contact.start_tick -
                             schedule.feet[foot][i - 1].contact.end_tick;
          EXPECT_GE(swing, kLimits.least_swing) << now;
        }
      }
      for (Tick tick = now; tick < now + kHorizon; tick += 5) {
        ASSERT_GE(FeetDown(schedule, tick), 1) << now << ": in the air at " << tick;
      }
    }
  }
}

TEST(TimingCandidatesTest, AFootInTheAirMayLandSoonerByKnots) {
  for (const Tick landing : {1750, 1700, 1650, 1600, 1550, 1500, 1450, 1400}) {
    EXPECT_TRUE(AnySchedule(kLeftFlies, [&](const ContactSchedule& schedule) {
      return NextLanding(schedule, 0, kLeftFlies) == landing;
    })) << landing;
  }
}

TEST(TimingCandidatesTest, ItMayBeFollowedByTheOtherFootAtOnceOrByItself) {
  for (const std::size_t foot : {0U, 1U}) {
    EXPECT_TRUE(AnySchedule(kLeftFlies, [&](const ContactSchedule& schedule) {
      return NextLanding(schedule, 0, kLeftFlies) == 1400 &&
             NextLiftOff(schedule, foot, kLeftFlies) == 1450 &&
             NextLanding(schedule, foot, 1450) == 1700;
    })) << foot;
  }
}

TEST(TimingCandidatesTest, OnBothFeetEitherMayLiftOffAtOnceForShorter) {
  for (const std::size_t foot : {0U, 1U}) {
    for (const Tick swing : {600, 250}) {
      EXPECT_TRUE(AnySchedule(kBothFeet,
                              [&](const ContactSchedule& schedule) {
                                return NextLiftOff(schedule, foot, kBothFeet) == kBothFeet + 50 &&
                                       NextLanding(schedule, foot, kBothFeet) ==
                                           kBothFeet + 50 + swing;
                              }))
          << foot << ", " << swing;
    }
  }
}

TEST(TimingCandidatesTest, StandingEitherFootMayStepOutAtOnceAndItEndsStanding) {
  constexpr Tick kStanding = 500;
  const GaitSetup stand = SetupOf({Stretch(GaitType::kStand, 0.0)}, 2);
  const std::vector<GaitSupport> candidates = CandidatesAt(stand, kStanding);
  ASSERT_EQ(candidates.size(), 2U);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    ContactSchedule schedule;
    GenerateSchedule(stand, candidates[foot], kStanding, kHorizon, &schedule);
    EXPECT_EQ(NextLiftOff(schedule, foot, kStanding), kStanding + kLimits.least_support);
    EXPECT_EQ(NextLanding(schedule, foot, kStanding),
              kStanding + kLimits.least_support + kLimits.least_swing);
    EXPECT_GT(NextLiftOff(schedule, 1 - foot, kStanding), NextLanding(schedule, foot, kStanding));
    EXPECT_EQ(FeetDown(schedule, kStanding + 2000), 2);
    EXPECT_EQ(schedule.com.back().p_WC.x(), schedule.com.front().p_WC.x()) << "on the spot";
  }
}

TEST(TimingCandidatesTest, WhatIsNoWalkOnTwoFeetHasNone) {
  const GaitSetup run = SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kRun, 1.0)}, 2);
  const GaitSetup hop = SetupOf({Stretch(GaitType::kStand, 0.0), Stretch(GaitType::kHop, 1.0)}, 1);
  for (Tick now = 1100; now < 2000; now += 50) {
    EXPECT_TRUE(CandidatesAt(run, now).empty()) << now;
    EXPECT_TRUE(CandidatesAt(hop, now).empty()) << now;
  }
}

}  // namespace
}  // namespace sidestep::timing_candidates_test
