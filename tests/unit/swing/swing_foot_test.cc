// SPDX-License-Identifier: BSD-3-Clause
#include "controller/swing/swing_foot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace sidestep::swing_foot_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr Tick kLiftOff = 100;
constexpr Tick kLanding = 500;
constexpr double kRounding = 1e-9;  // 400 quintics in a row, each from the last one's end

const Eigen::Vector3d kStart(0.1, 0.05, 0.02);
const Eigen::Vector3d kTarget(0.3, 0.0, 0.02);
const SwingShape kShape{0.06, 0.3};

struct Sample {
  Eigen::Vector3d p, v, a;
};

/// Samples from lift-off to `end`, one a tick; `target` may depend on the tick.
std::vector<Sample> Fly(const std::function<Eigen::Vector3d(Tick)>& target, Tick end,
                        Tick period = 1) {
  SwingFoot swing(kTick_s);
  swing.LiftOff(kShape, kStart, kLiftOff);
  std::vector<Sample> samples;
  for (Tick tick = kLiftOff; tick <= end; tick += period) {
    swing.Update(target(tick), kLanding, tick);
    samples.push_back({swing.position(), swing.velocity(), swing.acceleration()});
  }
  return samples;
}

std::vector<Sample> FlyTo(const Eigen::Vector3d& target, Tick end) {
  return Fly([&](Tick) { return target; }, end);
}

std::size_t At(Tick tick) { return static_cast<std::size_t>(tick - kLiftOff); }

TEST(SwingFootTest, LeavesTheGroundAtRest) {
  const Sample first = FlyTo(kTarget, kLiftOff).front();
  EXPECT_LT((first.p - kStart).norm(), kRounding);
  EXPECT_LT(first.v.norm() + first.a.norm(), kRounding);
}

TEST(SwingFootTest, RisesNoHigherThanItHasTimeFor) {
  SwingFoot swing(kTick_s, {}, {0.0, 10.0});
  swing.LiftOff(kShape, kStart, kLiftOff);
  constexpr Tick kSoon = kLiftOff + 100;
  double highest_m = 0.0, peak_mps2 = 0.0;
  for (Tick tick = kLiftOff; tick <= kLiftOff + 50; ++tick) {  // the rise
    swing.Update(kStart, kSoon, tick);
    highest_m = std::max(highest_m, swing.position().z() - kStart.z());
    peak_mps2 = std::max(peak_mps2, std::abs(swing.acceleration().z()));
  }
  EXPECT_NEAR(highest_m, 10.0 * 0.05 * 0.05 / kLeastJerkPeak, 1e-4) << "rest to rest in 50 ms";
  EXPECT_LT(peak_mps2, 10.1);
}

TEST(SwingFootTest, ArrivesAtTheTargetAtLandingStraightDown) {
  const Sample last = FlyTo(kTarget, kLanding).back();
  EXPECT_LT((last.p - kTarget).norm(), kRounding);
  EXPECT_LT((last.v - Eigen::Vector3d(0.0, 0.0, -kShape.landing_speed_mps)).norm(), kRounding);
}

TEST(SwingFootTest, UnchangedTargetGivesOneQuintic) {
  const std::vector<Sample> samples = FlyTo(kTarget, kLanding);
  for (Tick tick = kLiftOff; tick < kLanding; ++tick) {
    const double s = static_cast<double>(tick - kLiftOff) / (kLanding - kLiftOff);
    const double share = s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
    const Eigen::Vector3d line = kStart + share * (kTarget - kStart);
    ASSERT_LT((samples[At(tick)].p - line).head<2>().norm(), kRounding) << tick;
  }
}

TEST(SwingFootTest, CurveDoesNotDependOnTheControlRate) {
  const std::vector<Sample> slow = Fly([](Tick) { return kTarget; }, kLanding, 4);
  const std::vector<Sample> fast = FlyTo(kTarget, kLanding);
  for (std::size_t i = 0; i < slow.size(); ++i) {
    ASSERT_LT((slow[i].p - fast[4 * i].p).norm(), kRounding) << i;
  }
}

TEST(SwingFootTest, ApexIsTheSwingHeightAboveTheHigherFootholdAtHalfTime) {
  for (const double target_z_m : {0.02, 0.10, -0.05}) {
    const Eigen::Vector3d target(kTarget.x(), kTarget.y(), target_z_m);
    const std::vector<Sample> samples = FlyTo(target, kLanding);
    double highest_m = 0.0;
    for (const Sample& sample : samples) highest_m = std::max(highest_m, sample.p.z());
    const double apex_m = std::max(kStart.z(), target_z_m) + kShape.height_m;
    EXPECT_NEAR(highest_m, apex_m, kRounding) << target_z_m;
    const Sample& half = samples[At((kLiftOff + kLanding) / 2)];
    EXPECT_NEAR(half.p.z(), apex_m, kRounding) << target_z_m;
    EXPECT_LT(std::abs(half.v.z()), kRounding) << target_z_m;
  }
}

TEST(SwingFootTest, RetargetingKeepsPositionVelocityAndAccelerationContinuous) {
  const Tick jump = 320;  // well before the freeze, just after the apex
  const Eigen::Vector3d moved = kTarget + Eigen::Vector3d(0.1, -0.1, 0.01);
  const std::vector<Sample> samples =
      Fly([&](Tick tick) { return tick < jump ? kTarget : moved; }, kLanding);
  // Jerk stays below 60 d / T^3 with d = 0.25 m and T = 0.18 s left: 2600 m/s^3.
  constexpr double kJerk_mps3 = 2600.0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Sample& before = samples[i - 1];
    const Sample& now = samples[i];
    EXPECT_LT((now.a - before.a).norm(), kJerk_mps3 * kTick_s) << i;
    EXPECT_LT((now.v - before.v - kTick_s * before.a).norm(), 0.5 * kJerk_mps3 * kTick_s * kTick_s)
        << i;
    EXPECT_LT((now.p - before.p - kTick_s * before.v - 0.5 * kTick_s * kTick_s * before.a).norm(),
              kJerk_mps3 / 6.0 * kTick_s * kTick_s * kTick_s + kRounding)
        << i;
  }
  EXPECT_LT((samples.back().p - moved).norm(), kRounding);
}

TEST(SwingFootTest, FootholdIsFrozenNearLanding) {
  const Tick freeze = kLanding - 30;
  const Eigen::Vector3d moved = kTarget + Eigen::Vector3d(0.05, 0.0, 0.0);
  const auto landing_place = [&](Tick jump) {
    return Fly([&](Tick tick) { return tick < jump ? kTarget : moved; }, kLanding).back().p;
  };
  EXPECT_LT((landing_place(freeze) - moved).norm(), kRounding) << "still early enough";
  EXPECT_LT((landing_place(freeze + 2) - kTarget).norm(), kRounding) << "too late to move";
}

TEST(SwingFootTest, LateFootGoesOnDownAtTheLandingSpeedOnItsPlace) {
  const std::vector<Sample> samples = FlyTo(kTarget, kLanding + 100);
  const Sample& late = samples.back();
  const Eigen::Vector3d below = kTarget - Eigen::Vector3d(0.0, 0.0, 0.1 * kShape.landing_speed_mps);
  EXPECT_LT((late.p - below).norm(), kRounding);
  EXPECT_LT((late.v - Eigen::Vector3d(0.0, 0.0, -kShape.landing_speed_mps)).norm(), kRounding);
  EXPECT_LT(late.a.norm(), kRounding);
}

TEST(SwingFootTest, NewSwingForgetsTheLastOne) {
  SwingFoot swing(kTick_s);
  swing.LiftOff(kShape, kStart, 0);
  for (Tick tick = 0; tick <= 250; ++tick) swing.Update(kTarget, 200, tick);
  swing.LiftOff(kShape, kTarget, 300);
  swing.Update(kStart, 500, 300);
  EXPECT_LT((swing.position() - kTarget).norm(), kRounding);
  EXPECT_LT(swing.velocity().norm(), kRounding);
  for (Tick tick = 301; tick <= 500; ++tick) swing.Update(kStart, 500, tick);
  EXPECT_LT((swing.position() - kStart).norm(), kRounding);
}

// Samples of a foot that searches like that, to `end`.
std::vector<Sample> Search(const FloorSearch& search, const Eigen::Vector3d& from, Tick end) {
  SwingFoot swing(kTick_s, search);
  swing.LiftOff(kShape, from, kLiftOff);
  std::vector<Sample> samples;
  for (Tick tick = kLiftOff; tick <= end; ++tick) {
    swing.Update(kTarget, kLanding, tick);
    samples.push_back({swing.position(), swing.velocity(), swing.acceleration()});
  }
  return samples;
}

TEST(SwingFootTest, LateFootLooksForTheFloorDownToTheStatedDepth) {
  const std::vector<Sample> samples = Search({.depth_m = 0.03}, kStart, kLanding + 500);
  EXPECT_NEAR(samples[At(kLanding + 99)].p.z(), kTarget.z() - 0.0297, kRounding) << "0.3 m/s";
  EXPECT_NEAR(samples.back().p.z(), kTarget.z() - 0.03, kRounding);
  EXPECT_EQ(samples.back().v.z(), 0.0);
}

TEST(SwingFootTest, SearchGetsFasterAsItFallsBehind) {
  const std::vector<Sample> samples =
      Search({.depth_m = 0.06, .acceleration_mps2 = 4.0}, kStart, kLanding + 200);
  const Sample& late = samples[At(kLanding + 50)];  // 0.3 * 0.05 + 4 / 2 * 0.05^2 = 0.02
  EXPECT_NEAR(late.p.z(), kTarget.z() - 0.02, kRounding);
  EXPECT_NEAR(late.v.z(), -0.5, kRounding);
  EXPECT_NEAR(late.a.z(), -4.0, kRounding);
  EXPECT_NEAR(samples.back().p.z(), kTarget.z() - 0.06, kRounding);
  EXPECT_EQ(samples.back().a.z(), 0.0);
}

TEST(SwingFootTest, FootInAHoleRisesToItsNextHeightBeforeItMovesOn) {
  const Eigen::Vector3d hole = kStart - Eigen::Vector3d(0.0, 0.0, 0.04);
  const std::vector<Sample> samples = Search({}, hole, kLanding);
  for (const Sample& sample : samples) {
    if (sample.p.z() >= kTarget.z()) break;
    EXPECT_EQ(sample.p.x(), hole.x()) << "at " << sample.p.z();
  }
  EXPECT_LT((samples.back().p - kTarget).norm(), kRounding) << "it is there in time";
  EXPECT_GT(FlyTo(kTarget, kLanding)[20].p.x(), kStart.x()) << "on level ground it does not wait";
}

TEST(SwingFootTest, EachSwingHasItsShape) {
  SwingFoot swing(kTick_s);
  swing.LiftOff({.height_m = 0.15}, kStart, 0);
  for (Tick tick = 0; tick <= 100; ++tick) swing.Update(kTarget, 200, tick);
  EXPECT_NEAR(swing.position().z(), kStart.z() + 0.15, kRounding);
}

}  // namespace
}  // namespace sidestep::swing_foot_test
