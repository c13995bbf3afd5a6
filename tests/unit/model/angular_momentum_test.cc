// SPDX-License-Identifier: BSD-3-Clause
// Angular momentum and turning frames against differences along motions.
#include <gtest/gtest.h>

#include "controller/model/rigid_body.h"
#include "tests/support/icub3.h"
#include "tests/support/reference_robot.h"

namespace sidestep::angular_momentum_test {
namespace {

constexpr double kStep_s = 1e-5;
// kStep_s^2 times third derivatives of up to a few hundred, and rounding of 1e-16 / kStep_s on
// numbers of size 10.
constexpr double kDifferenceTolerance = 3e-7;
constexpr double kRounding = 1e-10;

class AngularMomentumTest : public testing::TestWithParam<int> {
 protected:
  AngularMomentumTest() { body_.Update(state_); }

  Eigen::Vector3d Momentum(const RigidBody& body) const {
    RobotState derived = state_;
    body.FillDerived(&derived);
    return derived.angular_momentum;
  }

  /// d/dt of `quantity` at constant velocities.
  template <typename Quantity>
  Eigen::Vector3d Derivative(Quantity&& quantity) {
    RigidBody after(body_), before(body_);
    after.Update(reference_.Moved(state_, body_.velocity(), kStep_s));
    before.Update(reference_.Moved(state_, body_.velocity(), -kStep_s));
    return (quantity(after) - quantity(before)) / (2.0 * kStep_s);
  }

  const RobotDescription robot_{Icub3()};
  RigidBody body_{robot_};
  ReferenceRobot reference_{robot_};
  const RobotState state_{MovingIcub(body_, GetParam())};
};

INSTANTIATE_TEST_SUITE_P(Variants, AngularMomentumTest, testing::Range(0, 2));

TEST_P(AngularMomentumTest, JacobianTimesTheVelocityIsTheMomentumAboutTheCom) {
  const Eigen::Vector3d h_C_W = Momentum(body_);
  EXPECT_LT((body_.angular_momentum_jacobian() * body_.velocity() - h_C_W).norm(), kRounding);
  EXPECT_GT(h_C_W.norm(), 0.5) << "no momentum proves nothing";
}

TEST_P(AngularMomentumTest, PureTranslationHasNone) {
  EXPECT_LT(body_.angular_momentum_jacobian().leftCols<3>().norm(), kRounding);
}

TEST_P(AngularMomentumTest, BiasIsItsRateAtConstantVelocities) {
  const Eigen::Vector3d rate_Nm = Derivative([&](const RigidBody& body) { return Momentum(body); });
  EXPECT_LT((body_.angular_momentum_bias_Nm() - rate_Nm).norm(), kDifferenceTolerance);
  EXPECT_GT(rate_Nm.norm(), 0.1);
}

// Newton and Euler: M nudot + h = J' f without motors' share in the base's rows.
TEST_P(AngularMomentumTest, ForceAtAFootChangesItByItsMomentAboutTheCom) {
  const Eigen::Vector3d force_N(12.0, -30.0, 90.0);
  const Eigen::VectorXd generalised = body_.foot_jacobian(0).J.transpose() * force_N;
  const Eigen::VectorXd nudot = body_.mass_matrix().ldlt().solve(generalised - body_.bias());
  RobotState derived = state_;
  body_.FillDerived(&derived);
  const Eigen::Vector3d moment_Nm = (derived.feet[0].p_WF - derived.p_WC).cross(force_N);
  const Eigen::Vector3d rate_Nm =
      body_.angular_momentum_jacobian() * nudot + body_.angular_momentum_bias_Nm();
  // Accelerations of up to 1e4 rad/s^2 of the lightest links, to 1e-12 of themselves.
  EXPECT_LT((rate_Nm - moment_Nm).norm(), 1e-7);
  EXPECT_GT(moment_Nm.norm(), 1.0);
}

TEST_P(AngularMomentumTest, AngularBiasOfFootAndTorsoIsTheirTurnsAccelerationAtConstantVelocities) {
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const Eigen::Vector3d wdot =
        Derivative([&](const RigidBody& body) { return body.feet()[foot].w_WF; });
    EXPECT_LT((body_.foot_bias(foot).angular_radps2 - wdot).norm(), kDifferenceTolerance);
    EXPECT_GT(wdot.norm(), 0.1);
  }
  const Eigen::Vector3d wdot = Derivative([](const RigidBody& body) { return body.torso().w_WT; });
  EXPECT_LT((body_.torso_bias_radps2() - wdot).norm(), kDifferenceTolerance);
  EXPECT_GT(wdot.norm(), 0.1);
}

TEST_P(AngularMomentumTest, TorsoTurnsAsItsJacobianSays) {
  EXPECT_LT((body_.torso_jacobian() * body_.velocity() - body_.torso().w_WT).norm(), kRounding);
}

}  // namespace
}  // namespace sidestep::angular_momentum_test
