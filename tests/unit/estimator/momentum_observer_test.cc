// SPDX-License-Identifier: BSD-3-Clause
// Momentum that balances by construction: v[k + 1] = v[k] + (f[k] + F) dt / m.
#include "controller/estimator/momentum_observer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

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
    params_.push_settle_s = 0.05;
    params_.push_decay_s = 0.15;
  }

  /// What the feet feel in period k: shocks, as in a walk.
  static Eigen::Vector3d Ground(int k) {
    return {200.0 * std::sin(1.7 * k), -150.0 * std::cos(0.9 * k * k), 500.0};
  }

  /// What is seen after `periods`, the feet's wrenches `late` periods old and claimed to be
  /// `claimed` old.
  std::optional<Eigen::Vector2d> Feed(int periods, const Eigen::Vector3d& push_N, int late = 0,
                                      int claimed = 0,
                                      const Eigen::Vector3d& arms_N = Eigen::Vector3d::Zero()) {
    MomentumObserver observer(params_, kMass_kg, kTick_s);
    RobotState state;
    state.feet.resize(2);
    state.v_WC = {0.1, -0.2, 0.0};
    std::optional<Eigen::Vector2d> seen_N;
    for (int k = 0; k < periods; ++k) {
      state.v_WC += (Ground(k) + push_N) * kTick_s / kMass_kg;
      state.feet[0].wrench.force_N = 0.25 * Ground(k - late);
      state.feet[1].wrench.force_N = 0.75 * Ground(k - late);
      seen_N = observer.Update(arms_N, claimed * kTick_s, state);
    }
    return seen_N;
  }

  static double Norm_N(const std::optional<Eigen::Vector2d>& force_N) {
    return force_N ? force_N->norm() : 0.0;
  }

  EstimatorParams params_;
};

TEST_F(MomentumObserverTest, PushIsWhatTheGroundDoesNotExplainAndHorizontal) {
  const std::optional<Eigen::Vector2d> force_N = Feed(400, {30.0, -12.0, 9.0});
  ASSERT_TRUE(force_N);
  EXPECT_LT((*force_N - Eigen::Vector2d(30.0, -12.0)).norm(), 1e-6);
}

TEST_F(MomentumObserverTest, ShocksOfTheGroundAreNoPush) {
  EXPECT_LT(Norm_N(Feed(400, Eigen::Vector3d::Zero())), kRounding);
}

TEST_F(MomentumObserverTest, OldWrenchesAreHeldAgainstTheMomentumOfTheirTime) {
  EXPECT_LT(Norm_N(Feed(400, Eigen::Vector3d::Zero(), 2, 2)), kRounding);
  EXPECT_GT(Norm_N(Feed(400, Eigen::Vector3d::Zero(), 2, 0)), 1.0) << "else the age shows nothing";
}

TEST_F(MomentumObserverTest, ArmsSensorsShareIsTakenOff) {
  const Eigen::Vector3d push_N(25.0, 10.0, 0.0), arms_N(20.0, 0.0, 3.0);
  const std::optional<Eigen::Vector2d> force_N = Feed(400, push_N, 0, 0, arms_N);
  ASSERT_TRUE(force_N);
  EXPECT_LT((*force_N - Eigen::Vector2d(5.0, 10.0)).norm(), 1e-6);
}

TEST_F(MomentumObserverTest, PushBelowTheDeadbandIsNone) {
  params_.push_deadband_N = 20.0;
  EXPECT_FALSE(Feed(400, {19.0, 0.0, 0.0}));
  EXPECT_NEAR(Norm_N(Feed(400, {21.0, 0.0, 0.0})), 21.0, 1e-6);
}

TEST_F(MomentumObserverTest, ItRisesAsFastAsItsLowPass) {
  // By hand: after one time constant, 1 / (2 pi 3 Hz) = 53 ms, a first-order low-pass is at 63 %.
  EXPECT_NEAR(Norm_N(Feed(11, {100.0, 0.0, 0.0})), 63.0, 7.0);
}

TEST_F(MomentumObserverTest, WithoutCutoffItLooksForNothing) {
  params_.push_cutoff_hz = 0.0;
  EXPECT_FALSE(Feed(400, {100.0, 0.0, 0.0}));
}

TEST_F(MomentumObserverTest, WrenchesTooOldForItsMemoryAreLeftAlone) {
  EXPECT_FALSE(Feed(400, {100.0, 0.0, 0.0}, 0, 60));
}

/// One observer through the course of a push, a landing, an end.
class PushCourseTest : public MomentumObserverTest {
 protected:
  PushCourseTest() { state_.feet.resize(2); }

  /// So many periods more under a push; the norm of what is seen in the last one (N).
  double Go(int periods, double push_N) {
    std::optional<Eigen::Vector2d> seen_N;
    for (int k = 0; k < periods; ++k) {
      state_.v_WC.x() += push_N * kTick_s / kMass_kg;
      seen_N = observer_.Update(Eigen::Vector3d::Zero(), 0.0, state_);
    }
    return Norm_N(seen_N);
  }

  void Stand(bool left, bool right) {
    state_.feet[0].in_contact = left;
    state_.feet[1].in_contact = right;
  }

  RobotState state_;
  MomentumObserver observer_{params_, kMass_kg, kTick_s};
};

TEST_F(PushCourseTest, ShockOfALandingIsNotLearnedAndThePushFadesMeanwhile) {
  Stand(true, false);
  EXPECT_NEAR(Go(400, 80.0), 80.0, 1e-6);
  Stand(true, true);
  // By hand: 10 periods, 50 ms, at a time constant of 150 ms.
  EXPECT_NEAR(Go(10, -700.0), 80.0 * std::exp(-1.0 / 3.0), 1e-6);
  EXPECT_NEAR(Go(100, 80.0), 80.0, 0.1) << "it learns again";
}

TEST_F(PushCourseTest, LiftOffIsNoShock) {
  Stand(true, true);
  Go(400, 80.0);
  Stand(true, false);
  EXPECT_NEAR(Go(1, 80.0), 80.0, 1e-6);
}

TEST_F(PushCourseTest, RobotThatStandsFromTheStartHasNotLanded) {
  Stand(true, true);
  EXPECT_GT(Go(5, 100.0), 10.0);
}

TEST_F(PushCourseTest, MoreThanItsWeightIsNoPush) {
  EXPECT_NEAR(Go(400, 3000.0), kMass_kg * 9.81, 0.5);
}

TEST_F(PushCourseTest, EndOfAPushIsSeenBeforeItsLowPassFades) {
  Go(400, 100.0);
  // By hand, after 9 periods: 100 N * 0.914^9 = 44 N are left in the low-pass, 100 N * 0.78^9
  // = 10.7 N, less than a quarter of it, in the one three times as quick.
  EXPECT_NEAR(Go(9, 0.0), 10.7, 0.5);
}

}  // namespace
}  // namespace sidestep::momentum_observer_test
