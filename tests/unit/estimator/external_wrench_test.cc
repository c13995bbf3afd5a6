// SPDX-License-Identifier: BSD-3-Clause
// Who decides what pushes: nobody, the frame, or what arms and momentum tell.
#include "controller/estimator/external_wrench.h"

#include <gtest/gtest.h>

namespace sidestep::external_wrench_test {
namespace {

constexpr double kMass_kg = 50.0;
constexpr double kTick_s = 0.001;

class ExternalWrenchTest : public testing::Test {
 protected:
  ExternalWrenchTest() {
    params_.wrench_deadband_N = 5.0;
    params_.push_cutoff_hz = 0.0;
    state_.feet.resize(2);
    state_.external_wrench = {{9.0, 9.0, 9.0}, {9.0, 9.0, 9.0}};  // of the frame before
  }

  ExternalWrench Make(ExternalWrenchKnowledge knowledge) const {
    return ExternalWrench(knowledge, params_, kMass_kg, kTick_s);
  }

  const Wrench& Feed(ExternalWrench* external, int ticks, const Wrench& arms) {
    for (int i = 0; i < ticks; ++i) external->Update(frame_, arms, &state_);
    return state_.external_wrench;
  }

  /// As Feed(), while the robot speeds up without its feet feeling why.
  const Wrench& FeedPushed(ExternalWrench* external, const Eigen::Vector3d& push_N,
                           const Wrench& arms) {
    for (int i = 0; i < 2000; ++i) {
      state_.v_WC += push_N * kTick_s / kMass_kg;
      external->Update(frame_, arms, &state_);
    }
    return state_.external_wrench;
  }

  EstimatorParams params_;
  RobotState state_;
  SensorFrame frame_;
  const Wrench arms_{{0.0, 100.0, 0.0}, {30.0, 0.0, -6.0}};
  const Wrench said_{{1.0, -2.0, 3.0}, {4.0, -5.0, 6.0}};
};

TEST_F(ExternalWrenchTest, UnknownItIsNoneWhateverIsFeltOrSaid) {
  params_.push_cutoff_hz = 3.0;
  frame_.known_external_wrench = said_;
  ExternalWrench external = Make(ExternalWrenchKnowledge::kUnknown);
  const Wrench& wrench = FeedPushed(&external, {40.0, 0.0, 0.0}, arms_);
  EXPECT_EQ(wrench.force_N, Eigen::Vector3d::Zero());
  EXPECT_EQ(wrench.torque_Nm, Eigen::Vector3d::Zero());
}

TEST_F(ExternalWrenchTest, KnownItIsWhatTheFrameSaysAtOnceWhateverIsFelt) {
  params_.push_cutoff_hz = 3.0;
  frame_.known_external_wrench = said_;
  ExternalWrench external = Make(ExternalWrenchKnowledge::kKnown);
  const Wrench wrench = Feed(&external, 1, arms_);
  EXPECT_EQ(wrench.force_N, said_.force_N);
  EXPECT_EQ(wrench.torque_Nm, said_.torque_Nm);
  frame_.known_external_wrench.reset();
  EXPECT_EQ(Feed(&external, 1, arms_).force_N, Eigen::Vector3d::Zero()) << "the push is over";
}

TEST_F(ExternalWrenchTest, EstimatedItRisesWithinOneTimeConstantOfItsCutoff) {
  params_.wrench_deadband_N = 0.0;
  params_.wrench_cutoff_hz = 10.0;
  frame_.known_external_wrench = said_;  // which it must not read
  ExternalWrench external = Make(ExternalWrenchKnowledge::kEstimated);
  // By hand: 1 / (2 pi 10 Hz) = 15.9 ms, when 1 - 1/e = 63.2 % are there; a step of 1 ms blurs
  // that by half a step, 1.2 %.
  EXPECT_NEAR(Feed(&external, 16, arms_).force_N.y(), 63.2, 1.5);
  EXPECT_NEAR(state_.external_wrench.torque_Nm.x(), 0.632 * 30.0, 0.45);
  EXPECT_NEAR(state_.external_wrench.torque_Nm.z(), 0.632 * -6.0, 0.09);
  EXPECT_NEAR(Feed(&external, 16, arms_).force_N.y(), 86.5, 1.5);
  EXPECT_NEAR(Feed(&external, 16, Wrench{}).force_N.y(), 86.5 * 0.368, 1.5) << "and back";
}

TEST_F(ExternalWrenchTest, ForceWithinTheDeadbandIsTakenForNoneWhateverItsTorque) {
  ExternalWrench external = Make(ExternalWrenchKnowledge::kEstimated);
  const Wrench within = Feed(&external, 1000, {{0.0, 4.9, 0.0}, {30.0, 0.0, 0.0}});
  EXPECT_EQ(within.force_N, Eigen::Vector3d::Zero());
  EXPECT_EQ(within.torque_Nm, Eigen::Vector3d::Zero());
  const Wrench beyond = Feed(&external, 1000, {{0.0, 5.1, 0.0}, {30.0, 0.0, 0.0}});
  EXPECT_LT((beyond.force_N - Eigen::Vector3d(0.0, 5.1, 0.0)).norm(), 1e-9) << "the whole of it";
  EXPECT_NEAR(beyond.torque_Nm.x(), 30.0, 1e-9);
}

TEST_F(ExternalWrenchTest, PushInTheMomentumIsAddedOnceToWhatTheArmsFeel) {
  params_.push_cutoff_hz = 3.0;
  params_.push_deadband_N = 0.0;
  ExternalWrench external = Make(ExternalWrenchKnowledge::kEstimated);
  // Of a push of (40, 10) N the arms feel (25, 0).
  const Wrench arms{{25.0, 0.0, 7.0}, {0.0, 2.0, 0.0}};
  const Wrench& wrench = FeedPushed(&external, {40.0, 10.0, 0.0}, arms);
  EXPECT_LT((wrench.force_N - Eigen::Vector3d(40.0, 10.0, 7.0)).norm(), 1e-6);
  EXPECT_LT((wrench.torque_Nm - arms.torque_Nm).norm(), 1e-9) << "the rest acts at the CoM";
}

TEST_F(ExternalWrenchTest, PlantWithoutSensorsFeelsNothingAndMayBeTold) {
  frame_.known_external_wrench = said_;
  ExternalWrench feeling(ExternalWrenchKnowledge::kEstimated);
  EXPECT_EQ(FeedPushed(&feeling, {40.0, 0.0, 0.0}, arms_).force_N, Eigen::Vector3d::Zero());
  ExternalWrench informed(ExternalWrenchKnowledge::kKnown);
  EXPECT_EQ(Feed(&informed, 1, arms_).force_N, said_.force_N);
}

}  // namespace
}  // namespace sidestep::external_wrench_test
