// SPDX-License-Identifier: BSD-3-Clause
// Bounds by hand, an approach that is integrated, and a motor that is too weak for its bound.
#include "controller/wbc/joint_limits.h"

#include <gtest/gtest.h>

#include "tests/support/icub3.h"

namespace sidestep::wbc::joint_limits_test {
namespace {

constexpr double kSpeedShare = 0.95;  // of the limit, left for what is not foreseen

class JointLimitsTest : public testing::Test {
 protected:
  JointLimitsTest() { state_ = IcubAtHome(&body_); }

  void Update() {
    body_.Update(state_);
    limits_.Update(state_, body_, OnBase({}, state_));
  }

  double SpeedLimit(Eigen::Index joint) const {
    return kSpeedShare * robot_.joints[static_cast<std::size_t>(joint)].velocity_limit_radps;
  }

  const RobotDescription robot_{Icub3()};
  RigidBody body_{robot_};
  RobotState state_;
  JointLimits limits_{robot_, body_};
};

TEST_F(JointLimitsTest, JointAtItsGreatestSpeedMayNotGainAny) {
  constexpr Eigen::Index kKnee = 14;
  ASSERT_EQ(robot_.joints[kKnee].name, "l_knee");
  // In the middle of its range, which is far: the speed alone counts.
  state_.joint_position[kKnee] = 0.5 * (body_.joint_lower()[kKnee] + body_.joint_upper()[kKnee]);
  for (const double sign : {1.0, -1.0}) {
    state_.joint_velocity[kKnee] = sign * SpeedLimit(kKnee);
    Update();
    EXPECT_NEAR(sign > 0.0 ? limits_.upper()[kKnee] : limits_.lower()[kKnee], 0.0, 1e-9);
    state_.joint_velocity[kKnee] = sign * (SpeedLimit(kKnee) + 0.1);
    Update();
    // 0.1 rad/s too fast: lost at 160 1/s.
    EXPECT_NEAR(sign > 0.0 ? limits_.upper()[kKnee] : -limits_.lower()[kKnee], -16.0, 1e-9);
  }
}

TEST_F(JointLimitsTest, AtTheEndOfItsRangeAJointMayOnlyGoBack) {
  for (Eigen::Index i = 0; i < body_.num_actuators(); ++i) {
    const double home = state_.joint_position[i];
    state_.joint_position[i] = body_.joint_upper()[i];
    Update();
    EXPECT_NEAR(limits_.upper()[i], 0.0, 1e-9) << i;
    state_.joint_position[i] = body_.joint_lower()[i] - 0.001;
    Update();
    EXPECT_NEAR(limits_.lower()[i], 160.0 * 40.0 * 0.001, 1e-6) << i;
    state_.joint_position[i] = home;
  }
}

TEST_F(JointLimitsTest, DrivenAsHardAsAllowedAJointNeitherPassesItsEndNorItsSpeed) {
  constexpr Eigen::Index kKnee = 14;
  for (const double dt_s : {0.001, 0.002, 0.005}) {
    state_ = IcubAtHome(&body_);
    double fastest = 0.0;
    for (double time_s = 0.0; time_s < 2.0; time_s += dt_s) {
      Update();
      state_.joint_velocity[kKnee] += dt_s * limits_.upper()[kKnee];
      state_.joint_position[kKnee] += dt_s * state_.joint_velocity[kKnee];
      fastest = std::max(fastest, state_.joint_velocity[kKnee]);
      ASSERT_LT(state_.joint_position[kKnee], body_.joint_upper()[kKnee] + 1e-9) << dt_s;
    }
    EXPECT_LT(fastest, SpeedLimit(kKnee) + 1e-9) << dt_s;
    EXPECT_GT(fastest, 0.8 * SpeedLimit(kKnee)) << dt_s;
    EXPECT_NEAR(state_.joint_position[kKnee], body_.joint_upper()[kKnee], 1e-6) << dt_s;
  }
}

TEST_F(JointLimitsTest, RobotThatTellsNoSpeedsHasNone) {
  RobotDescription silent = robot_;
  silent.joints.clear();
  JointLimits limits(silent, body_);
  state_.joint_velocity.setConstant(20.0);
  body_.Update(state_);
  limits.Update(state_, body_, OnBase({}, state_));
  for (Eigen::Index i = 0; i < body_.num_actuators(); ++i) {
    const double room = body_.joint_upper()[i] - state_.joint_position[i];
    EXPECT_GE(limits.upper()[i], 160.0 * (40.0 * room - 20.0) - 1e-9) << i;
  }
}

// Bounds and torque limits on M nudot + h = S^T tau + e must have a point in common, without any
// force at the feet: here it is made again, by the torques that come nearest.
TEST_F(JointLimitsTest, BoundThatNoMotorCanKeepGivesWayToWhatItCan) {
  for (int variant = 0; variant < 3; ++variant) {
    state_ = MovingIcub(body_, variant);
    state_.joint_velocity *= 30.0;  // no motor stops that within 1/160 s
    Update();
    int gave_way = 0;
    for (Eigen::Index i = 0; i < body_.num_actuators(); ++i) {
      const double strict = 160.0 * (SpeedLimit(i) - state_.joint_velocity[i]);
      if (state_.joint_velocity[i] > SpeedLimit(i) && limits_.upper()[i] > strict) ++gave_way;
      EXPECT_LT(limits_.lower()[i], limits_.upper()[i]);
    }
    EXPECT_GT(gave_way, 3) << variant;
  }
}

}  // namespace
}  // namespace sidestep::wbc::joint_limits_test
