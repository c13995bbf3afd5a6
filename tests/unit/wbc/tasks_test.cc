// SPDX-License-Identifier: BSD-3-Clause
// A task's rows against the robot itself: differences along a motion of chosen velocities and
// accelerations.
#include "controller/wbc/tasks.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/support/icub3.h"
#include "tests/support/reference_robot.h"

namespace sidestep::wbc::tasks_test {
namespace {

constexpr double kStep_s = 1e-5;
// kStep_s^2 times third derivatives of a few hundred, and rounding of 1e-16 / kStep_s on numbers of
// size 10.
constexpr double kDifferenceTolerance = 5e-7;

const Eigen::Vector3d kAsked(0.7, -1.1, 0.4);

class TasksTest : public testing::TestWithParam<int> {
 protected:
  TasksTest() {
    body_.Update(state_);
    nudot_ = 3.0 * Eigen::VectorXd::LinSpaced(body_.num_velocities(), -1.0, 1.3).array().sin();
  }

  /// d/dt of `quantity` along the robot's velocity and the acceleration nudot_.
  template <typename Quantity>
  Eigen::Vector3d Rate(Quantity&& quantity) {
    RigidBody after(body_), before(body_);
    after.Update(Along(kStep_s));
    before.Update(Along(-kStep_s));
    return (quantity(after) - quantity(before)) / (2.0 * kStep_s);
  }

  RobotState Along(double time_s) {
    RobotState state = reference_.Moved(state_, body_.velocity() + 0.5 * time_s * nudot_, time_s);
    state.v_WB += time_s * nudot_.head<3>();
    state.w_WB_B += time_s * nudot_.segment<3>(3);
    for (int i = 0; i < body_.num_actuators(); ++i) {
      state.joint_velocity[i] +=
          time_s * nudot_[body_.actuated_velocity()[static_cast<std::size_t>(i)]];
    }
    return state;
  }

  RobotState Derived(const RigidBody& body) const {
    RobotState derived = state_;
    body.FillDerived(&derived);
    return derived;
  }

  /// The task is met by velocities that move the robot as `now`, if that is what is asked.
  void ExpectVelocity(const Task& task, const Eigen::Vector3d& now) {
    EXPECT_EQ(task.target, kAsked);
    EXPECT_LT((task.J * body_.velocity() - now).norm(), 1e-10);
    EXPECT_GT(now.norm(), 0.1) << "at rest nothing is shown";
  }

  /// J nudot - target is by how much the acceleration `rate` differs from what is asked.
  void ExpectAcceleration(const Task& task, const Eigen::Vector3d& rate) {
    EXPECT_LT((task.J * nudot_ - task.target - (rate - kAsked)).norm(), kDifferenceTolerance);
    EXPECT_GT((kAsked - task.target).norm(), 0.1) << "without a bias half of it is not shown";
  }

  const RobotDescription robot_{Icub3()};
  RigidBody body_{robot_};
  ReferenceRobot reference_{robot_};
  const RobotState state_{MovingIcub(body_, GetParam())};
  Eigen::VectorXd nudot_;
};

INSTANTIATE_TEST_SUITE_P(Variants, TasksTest, testing::Range(0, 2));

TEST_P(TasksTest, ComMovesAsAsked) {
  ExpectVelocity(ComVelocity(body_, kAsked), Derived(body_).v_WC);
  ExpectAcceleration(ComAcceleration(body_, kAsked),
                     Rate([&](const RigidBody& body) { return Derived(body).v_WC; }));
}

TEST_P(TasksTest, AngularMomentumChangesAsAsked) {
  ExpectVelocity(AngularMomentum(body_, kAsked), Derived(body_).angular_momentum);
  ExpectAcceleration(AngularMomentumRate(body_, kAsked),
                     Rate([&](const RigidBody& body) { return Derived(body).angular_momentum; }));
}

TEST_P(TasksTest, FeetGoAndTurnAsAsked) {
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const FootTask velocity = FootVelocity(body_, foot, kAsked, kAsked);
    ExpectVelocity(velocity.linear, body_.feet()[foot].v_WF);
    ExpectVelocity(velocity.angular, body_.feet()[foot].w_WF);
    const Eigen::Vector3d a_WF =
        Rate([&](const RigidBody& body) { return body.feet()[foot].v_WF; });
    const FootTask acceleration = FootAcceleration(body_, foot, kAsked, kAsked);
    ExpectAcceleration(acceleration.linear, a_WF);
    ExpectAcceleration(acceleration.angular,
                       Rate([&](const RigidBody& body) { return body.feet()[foot].w_WF; }));
    ExpectAcceleration(FootLinearAcceleration(body_, foot, kAsked), a_WF);
  }
}

TEST_P(TasksTest, LinearAndAngularTargetsOfAFootAreNotSwapped) {
  const Eigen::Vector3d v_WF(1.0, 2.0, 3.0), w_WF(-4.0, -5.0, -6.0);
  const FootTask task = FootVelocity(body_, 1, v_WF, w_WF);
  EXPECT_EQ(task.linear.target, v_WF);
  EXPECT_EQ(task.angular.target, w_WF);
}

TEST_P(TasksTest, TrunkTurnsAsAsked) {
  ExpectVelocity(TrunkVelocity(body_, kAsked), body_.torso().w_WT);
  ExpectAcceleration(TrunkAcceleration(body_, kAsked),
                     Rate([](const RigidBody& body) { return body.torso().w_WT; }));
}

TEST(TrackedAccelerationTest, ErrorsOfPlaceAndSpeedAddToTheFeedForward) {
  const PointTarget target{{0.1, 0.0, 0.5}, {0.0, 0.2, 0.0}, {1.0, 2.0, 3.0}};
  // By hand: 1 + 100 * 0.02, 2 + 20 * 0.05, 3 - 100 * 0.01 - 20 * 0.1.
  const Eigen::Vector3d a =
      TrackedAcceleration(target, {0.08, 0.0, 0.51}, {0.0, 0.15, 0.1}, 100.0, 20.0);
  EXPECT_LT((a - Eigen::Vector3d(3.0, 3.0, 0.0)).norm(), 1e-12);
}

}  // namespace
}  // namespace sidestep::wbc::tasks_test
