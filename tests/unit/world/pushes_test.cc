// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/pushes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "models/support/require.h"

namespace sidestep::pushes_test {
namespace {

constexpr double kTick_s = 0.001;

Push SidePush() {
  Push push;
  push.body = "com";
  push.force_N = {3.0, 40.0, -5.0};
  push.start_s = 0.1;
  push.duration_s = 0.2;
  return push;
}

// Adds up what a body at rest at `pose` gets over half a second.
Eigen::Vector3d Impulse(const Push& push, const PushedPose& pose, double heading_rad) {
  Pushes pushes({push}, kTick_s);
  Eigen::Vector3d impulse_Ns = Eigen::Vector3d::Zero();
  for (Tick tick = 0; tick < 500; ++tick) {
    impulse_Ns += kTick_s * pushes.Update(tick, {&pose, 1}, heading_rad)[0].force_W_N;
  }
  return impulse_Ns;
}

TEST(PushesTest, ConstantPushGivesForceTimesDuration) {
  const Push push = SidePush();
  EXPECT_LT((Impulse(push, {}, 0.0) - 0.2 * push.force_N).norm(), 1e-12);
}

TEST(PushesTest, HalfSineGivesTwoOverPiOfItsPeakTimesDuration) {
  Push push = SidePush();
  push.profile = PushProfile::kHalfSine;
  const Eigen::Vector3d expected_Ns = 2.0 / std::numbers::pi * 0.2 * push.force_N;
  EXPECT_LT((Impulse(push, {}, 0.0) - expected_Ns).norm(), 1e-12);
  EXPECT_GT(PushShare(push, 200, kTick_s), 0.9999);
  EXPECT_LT(PushShare(push, 100, kTick_s), 0.01);
}

TEST(PushesTest, PushActsFromItsStartUntilJustBeforeItsEnd) {
  const Push push = SidePush();
  EXPECT_EQ(PushShare(push, 99, kTick_s), 0.0);
  EXPECT_EQ(PushShare(push, 100, kTick_s), 1.0);
  EXPECT_EQ(PushShare(push, 299, kTick_s), 1.0);
  EXPECT_EQ(PushShare(push, 300, kTick_s), 0.0);
}

TEST(PushesTest, ImpulseIsExactWhereverAPushBeginsAndEndsBetweenTicks) {
  for (const PushProfile profile : {PushProfile::kConstant, PushProfile::kHalfSine}) {
    for (const double start_s : {0.1, 0.10004, 0.1005, 0.1009, 0.2}) {
      for (const double duration_s : {0.00001, 0.0005, 0.001, 0.0015, 0.0501}) {
        Push push = SidePush();
        push.profile = profile;
        push.start_s = start_s;
        push.duration_s = duration_s;
        const Eigen::Vector3d expected_Ns = MeanShare(profile) * duration_s * push.force_N;
        EXPECT_LT((Impulse(push, {}, 0.0) - expected_Ns).norm(), 1e-12)
            << EnumName(profile) << " from " << start_s << " for " << duration_s;
      }
    }
  }
}

TEST(PushesTest, TickFeelsTheShareOfItThatThePushTakes) {
  Push push = SidePush();
  push.start_s = 0.10025;
  push.duration_s = 0.0015;
  EXPECT_EQ(PushShare(push, 99, kTick_s), 0.0);
  EXPECT_NEAR(PushShare(push, 100, kTick_s), 0.75, 1e-9);
  EXPECT_NEAR(PushShare(push, 101, kTick_s), 0.75, 1e-9);
  EXPECT_EQ(PushShare(push, 102, kTick_s), 0.0);
}

TEST(PushesTest, WorldFrameIgnoresBodyAndHeading) {
  PushedPose turned;
  turned.R_WO = Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX());
  const Push push = SidePush();
  EXPECT_LT((Impulse(push, turned, 0.7) - 0.2 * push.force_N).norm(), 1e-12);
}

TEST(PushesTest, HeadingFrameTurnsForceByYawAtItsStartOnly) {
  Push push = SidePush();
  push.frame = PushFrame::kHeading;
  Pushes pushes({push}, kTick_s);
  const PushedPose pose;
  pushes.Update(99, {&pose, 1}, 0.3);  // not yet acting: this yaw must not stick
  const double quarter_turn = std::numbers::pi / 2.0;
  // By hand: x' = -y, y' = x after a quarter turn to the left.
  const Eigen::Vector3d expected_N(-40.0, 3.0, -5.0);
  const auto force_N = [&](Tick tick, double heading_rad) {
    return pushes.Update(tick, {&pose, 1}, heading_rad)[0].force_W_N;
  };
  EXPECT_LT((force_N(100, quarter_turn) - expected_N).norm(), 1e-12);
  EXPECT_LT((force_N(101, 0.0) - expected_N).norm(), 1e-12);
}

TEST(PushesTest, BodyFrameTurnsWithTheBody) {
  Push push = SidePush();
  push.frame = PushFrame::kBody;
  PushedPose pose;
  Pushes pushes({push}, kTick_s);
  EXPECT_LT((pushes.Update(100, {&pose, 1}, 0.5)[0].force_W_N - push.force_N).norm(), 1e-12);
  pose.R_WO = Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitX());
  // By hand: a quarter turn about x takes y to z and z to -y.
  const Eigen::Vector3d expected_N(3.0, 5.0, 40.0);
  EXPECT_LT((pushes.Update(101, {&pose, 1}, 0.5)[0].force_W_N - expected_N).norm(), 1e-12);
}

TEST(PushesTest, PointIsGivenInTheBodysAxes) {
  Push push = SidePush();
  push.point_m = {0.1, 0.0, 0.0};
  PushedPose pose;
  pose.p_WO = {1.0, 2.0, 3.0};
  pose.R_WO = Eigen::AngleAxisd(std::numbers::pi / 2.0, Eigen::Vector3d::UnitZ());
  Pushes pushes({push}, kTick_s);
  const Eigen::Vector3d expected_W(1.0, 2.1, 3.0);
  EXPECT_LT((pushes.Update(0, {&pose, 1}, 0.0)[0].p_W - expected_W).norm(), 1e-12);
}

TEST(PushesTest, HeadingIsYawWhateverPitchIs) {
  const Eigen::Quaterniond q_WB(Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()) *
                                Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitY()));
  EXPECT_NEAR(HeadingRad(q_WB), 0.4, 1e-12);
}

TEST(PushesTest, PosesMustBeOneAPush) {
  Pushes pushes({SidePush()}, kTick_s);
  EXPECT_THROW(pushes.Update(0, {}, 0.0), ContractViolation);
}

}  // namespace
}  // namespace sidestep::pushes_test
