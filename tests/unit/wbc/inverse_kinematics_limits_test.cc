// SPDX-License-Identifier: BSD-3-Clause
// Whatever is asked, the references keep the joints' limits of position and velocity.
#include <gtest/gtest.h>

#include "controller/wbc/inverse_kinematics.h"
#include "tests/support/icub3_stance.h"
#include "tests/support/wild_targets.h"

namespace sidestep::wbc::inverse_kinematics_limits_test {
namespace {

// The QP's relative tolerance of 1e-9 on bounds of at most 10 rad/s.
constexpr double kVelocityTolerance_radps = 1e-7;

constexpr double kNear_rad = 0.02;

Eigen::VectorXd VelocityLimits(const RobotDescription& robot) {
  Eigen::VectorXd limits(robot.joints.size());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    limits[static_cast<Eigen::Index>(i)] = robot.joints[i].velocity_limit_radps;
  }
  return limits;
}

struct Outcomes {
  int exact{0}, soft{0}, failed{0}, at_velocity_limit{0}, near_position_limit{0};
};

class InverseKinematicsLimitsTest : public testing::TestWithParam<std::uint64_t> {
 protected:
  void Check(const ActuatorCommand& command, int tick) {
    const Eigen::ArrayXd down = (command.joint_position - stance_.body.joint_lower()).array();
    const Eigen::ArrayXd up = (stance_.body.joint_upper() - command.joint_position).array();
    ASSERT_TRUE(command.joint_position.allFinite()) << tick;
    EXPECT_GE(down.minCoeff(), 0.0) << tick;
    EXPECT_GE(up.minCoeff(), 0.0) << tick;
    const Eigen::ArrayXd spare = limits_.array() - command.joint_velocity.array().abs();
    EXPECT_GE(spare.minCoeff(), -kVelocityTolerance_radps) << tick;
    outcomes_.at_velocity_limit += spare.minCoeff() < 1e-6 ? 1 : 0;
    outcomes_.near_position_limit += std::min(down.minCoeff(), up.minCoeff()) < kNear_rad ? 1 : 0;
  }

  void Count(const WbcReport& report, const ActuatorCommand& command, int tick) {
    const bool is_solved = report.status == QpStatus::kSolved;
    if (report.ok) {
      EXPECT_TRUE(is_solved) << tick;
      ++outcomes_.exact;
    } else if (is_solved) {
      ++outcomes_.soft;
    } else {
      EXPECT_EQ(command.joint_velocity.norm(), 0.0) << "no answer, no motion: " << tick;
      ++outcomes_.failed;
    }
  }

  IcubStance stance_;
  const Eigen::VectorXd limits_{VelocityLimits(stance_.robot)};
  Outcomes outcomes_;
};

TEST_P(InverseKinematicsLimitsTest, WildTargetsKeepEveryLimitAndEveryStatusIsTold) {
#ifdef __SANITIZE_ADDRESS__
  constexpr int kTicks = 240;
#else
  constexpr int kTicks = 3000;
#endif
  InverseKinematicsParams params;
  params.compensates_deflection = false;
  InverseKinematics ik(stance_.robot, params, kStanceTick_s);
  WildTargets wild(GetParam(), &stance_);
  ActuatorCommand command;
  for (int tick = 0; tick < kTicks; ++tick) {
    wild.Next();
    const WbcReport report =
        ik.Solve(stance_.state, stance_.body, stance_.com, stance_.feet, &command);
    Check(command, tick);
    Count(report, command, tick);
  }
  EXPECT_GT(outcomes_.exact, 0);
  EXPECT_GT(outcomes_.soft + outcomes_.failed, 0) << "not wild enough";
  EXPECT_GT(outcomes_.at_velocity_limit, 0);
  EXPECT_GT(outcomes_.near_position_limit, 0);
}

INSTANTIATE_TEST_SUITE_P(Seeds, InverseKinematicsLimitsTest, testing::Values(1U, 2U, 3U));

TEST(InverseKinematicsLimitTest, ComThatTheLegsCannotFollowGivesWayToTheFeet) {
  IcubStance stance;
  InverseKinematics ik(stance.robot, BareTasks(), kStanceTick_s);
  stance.com.v_WC = {0.0, 0.0, 0.5};  // straight knees are 6 cm away
  ActuatorCommand command;
  WbcReport report;
  int given_way = 0;
  for (int tick = 0; tick < 60; ++tick) {
    report = ik.Solve(stance.state, stance.body, stance.com, stance.feet, &command);
    EXPECT_EQ(report.status, QpStatus::kSolved) << tick;
    given_way += report.ok ? 0 : 1;
  }
  EXPECT_FALSE(report.ok);
  EXPECT_GT(given_way, 10);
  const RobotState state =
      StandOnFoot(0, stance.feet[0].p_WF, command.joint_position, &stance.body);
  EXPECT_LT((state.feet[1].p_WF - stance.feet[1].p_WF).norm(), 5e-4);
  EXPECT_LT(Tilt_rad(state.feet[1].R_WF), 2e-3);
  EXPECT_GT(state.p_WC.z(), stance.state.p_WC.z() + 0.03) << "as far as it goes";
}

TEST(InverseKinematicsLimitTest, JointThatStartsBeyondItsLimitComesBackWithinIt) {
  constexpr Eigen::Index kElbow = 6;
  IcubStance stance;
  const double lower_rad = stance.body.joint_lower()[kElbow];
  stance.state.joint_position[kElbow] = lower_rad - 0.02;  // noise, or a joint that gave way
  stance.body.Update(stance.state);
  InverseKinematics ik(stance.robot, BareTasks(), kStanceTick_s);
  ActuatorCommand command;
  double before_rad = lower_rad - 0.02;
  for (int tick = 0; tick < 20; ++tick) {
    EXPECT_TRUE(ik.Solve(stance.state, stance.body, stance.com, stance.feet, &command).ok) << tick;
    EXPECT_GT(command.joint_position[kElbow], before_rad) << tick;
    before_rad = command.joint_position[kElbow];
  }
  EXPECT_GT(command.joint_position[kElbow], lower_rad);
}

}  // namespace
}  // namespace sidestep::wbc::inverse_kinematics_limits_test
