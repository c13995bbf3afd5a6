// SPDX-License-Identifier: BSD-3-Clause
// A whole humanoid, read from a URDF: Jacobians against differences of poses, home and limits.
#include <gtest/gtest.h>

#include <limits>

#include "controller/model/rigid_body.h"
#include "models/robot_description/home_pose.h"
#include "tests/support/crooked_robot.h"
#include "tests/support/icub3.h"
#include "tests/support/reference_robot.h"

namespace sidestep::icub3_rigid_body_test {
namespace {

constexpr double kStep = 1e-5;
// Central differences: kStep^2 times a third derivative of at most 100 here, and 1e-16 / kStep of
// rounding on numbers of size 1.
constexpr double kDifferenceTolerance = 2e-8;
constexpr double kDegree = 3.14159265358979 / 180.0;

class Icub3RigidBodyTest : public testing::TestWithParam<int> {
 protected:
  Icub3RigidBodyTest() { body_.Update(state_); }

  /// Calls look(column, after, before) with the robot a step before and after along each velocity.
  template <typename Look>
  void AlongEveryVelocity(Look&& look) {
    RigidBody after(robot_), before(robot_);
    for (int i = 0; i < body_.num_velocities(); ++i) {
      const Eigen::VectorXd nu = Eigen::VectorXd::Unit(body_.num_velocities(), i);
      after.Update(reference_.Moved(state_, nu, kStep));
      before.Update(reference_.Moved(state_, nu, -kStep));
      look(i, after, before);
    }
  }

  const RobotDescription robot_{Icub3()};
  RigidBody body_{robot_};
  ReferenceRobot reference_{robot_};
  const RobotState state_{MovingIcub(body_, GetParam())};
};

TEST_P(Icub3RigidBodyTest, FootJacobiansAreTheDerivativesOfTheFeetsPoses) {
  AlongEveryVelocity([&](int i, const RigidBody& after, const RigidBody& before) {
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const FootKinematics& from = before.feet()[foot];
      const FootKinematics& to = after.feet()[foot];
      const Eigen::Vector3d v_WF = (to.p_WF - from.p_WF) / (2.0 * kStep);
      const Eigen::Vector3d w_WF = SmallTurn_W(from.R_WF, to.R_WF) / (2.0 * kStep);
      EXPECT_LT((body_.foot_jacobian(foot).J.col(i) - v_WF).norm(), kDifferenceTolerance) << i;
      EXPECT_LT((body_.foot_jacobian(foot).J_rot.col(i) - w_WF).norm(), kDifferenceTolerance) << i;
    }
  });
}

TEST_P(Icub3RigidBodyTest, TorsoJacobianIsTheDerivativeOfItsAttitude) {
  ASSERT_TRUE(body_.has_torso());
  int moved_by_joints = 0;
  AlongEveryVelocity([&](int i, const RigidBody& after, const RigidBody& before) {
    const Eigen::Vector3d w_WT =
        SmallTurn_W(before.torso().R_WT, after.torso().R_WT) / (2.0 * kStep);
    EXPECT_LT((body_.torso_jacobian().col(i) - w_WT).norm(), kDifferenceTolerance) << i;
    moved_by_joints += i >= 6 && w_WT.norm() > 0.5 ? 1 : 0;
  });
  EXPECT_EQ(moved_by_joints, 3) << "pitch, roll and yaw of the torso, nothing else";
}

TEST_P(Icub3RigidBodyTest, ComJacobianIsTheDerivativeOfTheComsPosition) {
  RobotState to = state_, from = state_;
  AlongEveryVelocity([&](int i, const RigidBody& after, const RigidBody& before) {
    after.FillDerived(&to);
    before.FillDerived(&from);
    const Eigen::Vector3d v_WC = (to.p_WC - from.p_WC) / (2.0 * kStep);
    EXPECT_LT((body_.com_jacobian().col(i) - v_WC).norm(), kDifferenceTolerance) << i;
  });
}

TEST_P(Icub3RigidBodyTest, ImuOnTheChestMovesWithTheTorsosJoints) {
  const Eigen::VectorXd nu = body_.velocity();
  RigidBody after(robot_), before(robot_);
  after.Update(reference_.Moved(state_, nu, kStep));
  before.Update(reference_.Moved(state_, nu, -kStep));
  const Eigen::Vector3d v_WU = (after.imu().p_WU - before.imu().p_WU) / (2.0 * kStep);
  const Eigen::Vector3d w_WU = SmallTurn_W(before.imu().R_WU, after.imu().R_WU) / (2.0 * kStep);
  // The joints turn by up to 3 rad/s here: third derivatives of a few hundred.
  EXPECT_LT((body_.imu().v_WU - v_WU).norm(), 10.0 * kDifferenceTolerance);
  EXPECT_LT((body_.imu().w_WU - w_WU).norm(), 10.0 * kDifferenceTolerance);
  EXPECT_GT((w_WU - state_.q_WB * state_.w_WB_B).norm(), 0.5) << "the base's rate is not the IMU's";
}

INSTANTIATE_TEST_SUITE_P(Variants, Icub3RigidBodyTest, testing::Range(0, 2));

TEST(Icub3HomeTest, ControllerAndPlantAgreeOnWhereTheRobotStarts) {
  const RobotDescription robot = Icub3();
  ReferenceRobot plant(robot);
  PlaceAtHome(*plant.model(), robot, plant.data());
  const RigidBody body(robot);
  RobotState home;
  home.v_WB.setOnes();
  home.w_WB_B.setOnes();
  body.WriteHome(&home);
  const mjData* data = plant.data();
  EXPECT_EQ(home.p_WB, Eigen::Vector3d(data->qpos[0], data->qpos[1], data->qpos[2]));
  EXPECT_EQ(home.q_WB.coeffs(), FromMuJoCo(data->qpos + 3).coeffs());
  ASSERT_EQ(home.joint_position.size(), 23);
  for (int i = 0; i < 23; ++i) {
    EXPECT_EQ(home.joint_position[i], data->qpos[plant.model()->jnt_qposadr[plant.Joint(i)]]) << i;
  }
  EXPECT_EQ(home.joint_position[0], robot.home.at("torso_pitch")) << "the first actuator";
  EXPECT_EQ(home.v_WB.norm() + home.w_WB_B.norm(), 0.0);
  EXPECT_EQ(home.joint_velocity, Eigen::VectorXd::Zero(23));
}

TEST(Icub3LimitsTest, JointLimitsAreThoseOfTheUrdfInTheOrderOfTheActuators) {
  const RobotDescription robot = Icub3();
  const RigidBody body(robot);
  // By hand from the URDF: degrees.
  struct Limits {
    const char* joint;
    double lower_deg, upper_deg;
  };
  for (const Limits& limits :
       {Limits{"l_knee", -70.0, 5.0}, Limits{"l_elbow", -3.0, 75.0},
        Limits{"l_shoulder_roll", 12.0, 163.0}, Limits{"l_shoulder_yaw", -50.0, 80.0}}) {
    Eigen::Index at = 0;
    while (robot.joints[static_cast<std::size_t>(at)].name != limits.joint) ++at;
    EXPECT_NEAR(body.joint_lower()[at], limits.lower_deg * kDegree, 1e-9) << limits.joint;
    EXPECT_NEAR(body.joint_upper()[at], limits.upper_deg * kDegree, 1e-9) << limits.joint;
  }
  RobotState home;
  body.WriteHome(&home);
  EXPECT_GT((home.joint_position - body.joint_lower()).minCoeff(), 0.0);
  EXPECT_GT((body.joint_upper() - home.joint_position).minCoeff(), 0.0);
}

TEST(Icub3LimitsTest, JointsWithoutARangeHaveNoLimits) {
  const TempFolder folder;
  const RigidBody body(CrookedRobot(folder));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(body.joint_lower(), Eigen::Vector4d::Constant(-kInfinity));
  EXPECT_EQ(body.joint_upper(), Eigen::Vector4d::Constant(kInfinity));
  EXPECT_FALSE(body.has_torso());
}

TEST(CrookedImuTest, ImuMovesWithItsSite) {
  const TempFolder folder;
  RigidBody body(CrookedRobot(folder));
  RobotState state;
  state.joint_position.setZero(body.num_actuators());
  state.joint_velocity.setZero(body.num_actuators());
  state.p_WB = {1.0, 2.0, 3.0};
  state.v_WB = {0.5, 0.0, 0.0};
  state.w_WB_B = {0.0, 0.0, 2.0};
  body.Update(state);
  const Eigen::Vector3d p_BU(0.05, 0.02, -0.04);
  EXPECT_LT((body.imu().p_WU - state.p_WB - p_BU).norm(), 1e-11);
  EXPECT_LT(Eigen::Quaterniond(body.imu().R_WU)
                .angularDistance(Eigen::Quaterniond(0.8, 0.36, -0.48, 0.0)),
            1e-7);
  // By hand: (0.5, 0, 0) + (0, 0, 2) x (0.05, 0.02, -0.04) = (0.46, 0.1, 0).
  EXPECT_LT((body.imu().v_WU - Eigen::Vector3d(0.46, 0.1, 0.0)).norm(), 1e-11);
  EXPECT_LT((body.imu().w_WU - state.w_WB_B).norm(), 1e-11);
}

// Three torso joints turn the chest's IMU against the base.
TEST_P(Icub3RigidBodyTest, ImuIsLocatedByTheJointsAlone) {
  const ImuInBase located = body_.LocateImu(state_);
  RobotState level = state_;
  level.q_WB.setIdentity();
  level.w_WB_B.setZero();
  body_.Update(level);
  EXPECT_LT((located.R_BU - body_.imu().R_WU).norm(), 1e-12);
  EXPECT_LT((located.w_BU_B - body_.imu().w_WU).norm(), 1e-12);
  EXPECT_GT(located.w_BU_B.norm(), 0.1) << "a resting IMU proves nothing";
}

}  // namespace
}  // namespace sidestep::icub3_rigid_body_test
