// SPDX-License-Identifier: BSD-3-Clause
// Momentum that balances by construction: v[k + 1] = v[k] + (f[k] + F) dt / m.
#include "controller/estimator/momentum_observer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sidestep::momentum_observer_test {
namespace {

constexpr double kMass_kg = 50.0;
constexpr double kTick_s = 0.005;
constexpr double kRounding = 1e-9;

class MomentumObserverTest : public testing::Test {
 protected:
  MomentumObserverTest() {
    params_.push_cutoff_hz = 3.0;
    params_.push_deadband_N = 0.0;
    state_.feet.resize(2);
  }

  /// What the feet feel in period k: shocks, as in a walk.
  static Eigen::Vector3d Ground(int k) {
    return {200.0 * std::sin(1.7 * k), -150.0 * std::cos(0.9 * k * k), 500.0};
  }

  /// Feeds `periods`, the feet's wrenches `late` periods old and said to be `told` old.
  const RobotState& Feed(int periods, const Eigen::Vector3d& push_N, int late = 0, int told = 0,
                         const Eigen::Vector3d& arms_N = Eigen::Vector3d::Zero()) {
    MomentumObserver observer(params_, kMass_kg, kTick_s);
    Eigen::Vector3d v_WC(0.1, -0.2, 0.0);
    for (int k = 0; k < periods; ++k) {
      v_WC += (Ground(k) + push_N) * kTick_s / kMass_kg;
      state_.v_WC = v_WC;
      state_.external_wrench = {};
      state_.external_wrench.force_N = arms_N;
      state_.feet[0].wrench.force_N = 0.25 * Ground(k - late);
      state_.feet[1].wrench.force_N = 0.75 * Ground(k - late);
      observer.Update(arms_N, told * kTick_s, &state_);
    }
    return state_;
  }

  EstimatorParams params_;
  RobotState state_;
};

TEST_F(MomentumObserverTest, PushIsWhatTheGroundDoesNotExplainAndHorizontal) {
  const Eigen::Vector3d force_N = Feed(400, {30.0, -12.0, 9.0}).external_wrench.force_N;
  EXPECT_LT((force_N - Eigen::Vector3d(30.0, -12.0, 0.0)).norm(), 1e-6);
}

TEST_F(MomentumObserverTest, ShocksOfTheGroundAreNoPush) {
  EXPECT_LT(Feed(400, Eigen::Vector3d::Zero()).external_wrench.force_N.norm(), kRounding);
}

TEST_F(MomentumObserverTest, OldWrenchesAreHeldAgainstTheMomentumOfTheirTime) {
  EXPECT_LT(Feed(400, Eigen::Vector3d::Zero(), 2, 2).external_wrench.force_N.norm(), kRounding);
  EXPECT_GT(Feed(400, Eigen::Vector3d::Zero(), 2, 0).external_wrench.force_N.norm(), 1.0)
      << "else the age shows nothing";
}

TEST_F(MomentumObserverTest, ArmsSensorsShareIsNotCountedTwice) {
  const Eigen::Vector3d push_N(25.0, 10.0, 0.0), arms_N(20.0, 0.0, 3.0);
  const Eigen::Vector3d force_N = Feed(400, push_N, 0, 0, arms_N).external_wrench.force_N;
  EXPECT_LT((force_N - Eigen::Vector3d(25.0, 10.0, 3.0)).norm(), 1e-6);
}

TEST_F(MomentumObserverTest, PushBelowTheDeadbandIsNone) {
  params_.push_deadband_N = 20.0;
  EXPECT_EQ(Feed(400, {19.0, 0.0, 0.0}).external_wrench.force_N, Eigen::Vector3d::Zero());
  EXPECT_NEAR(Feed(400, {21.0, 0.0, 0.0}).external_wrench.force_N.x(), 21.0, 1e-6);
}

TEST_F(MomentumObserverTest, ItRisesAsFastAsItsLowPass) {
  // By hand: after one time constant, 1 / (2 pi 3 Hz) = 53 ms, a first-order low-pass is at 63 %.
  const double force_N = Feed(11, {100.0, 0.0, 0.0}).external_wrench.force_N.x();
  EXPECT_NEAR(force_N, 63.0, 7.0);
}

TEST_F(MomentumObserverTest, WithoutCutoffItLooksForNothing) {
  params_.push_cutoff_hz = 0.0;
  EXPECT_EQ(Feed(400, {100.0, 0.0, 0.0}).external_wrench.force_N, Eigen::Vector3d::Zero());
}

TEST_F(MomentumObserverTest, WrenchesTooOldForItsMemoryAreLeftAlone) {
  EXPECT_EQ(Feed(400, {100.0, 0.0, 0.0}, 0, 60).external_wrench.force_N, Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace sidestep::momentum_observer_test
