// SPDX-License-Identifier: BSD-3-Clause
// What the joints' references do to CoM, feet and torso, by forward kinematics from a standing foot
// (the solver's own base pose stays its secret).
#include "controller/wbc/inverse_kinematics.h"

#include <gtest/gtest.h>

#include "models/support/require.h"
#include "tests/support/icub3_stance.h"
#include "tests/support/reference_robot.h"
#include "tests/unit/wbc/foot_velocity.h"

namespace sidestep::wbc::inverse_kinematics_test {
namespace {

class InverseKinematicsTest : public testing::Test {
 protected:
  WbcReport Solve(InverseKinematics* ik) {
    return ik->Solve(stance_.state, stance_.body, stance_.com, stance_.feet, &command_);
  }

  /// Ticks of unchanged targets, each of which must be solved.
  void Run(int ticks, InverseKinematics* ik) {
    for (int tick = 0; tick < ticks; ++tick) {
      const WbcReport report = Solve(ik);
      ASSERT_TRUE(report.ok) << tick;
      ASSERT_EQ(report.status, QpStatus::kSolved) << tick;
    }
  }

  /// The references, on a left foot that stays where it is at home.
  RobotState Commanded() {
    return StandOnFoot(0, stance_.feet[0].contact.adjusted_p_WF, command_.joint_position,
                       &stance_.body);
  }

  IcubStance stance_;
  ActuatorCommand command_;
};

TEST_F(InverseKinematicsTest, JointVelocitiesMeetTheTasksOfBothFeetAndTheCom) {
  const FootKinematics left = stance_.body.feet()[0], right = stance_.body.feet()[1];
  stance_.Lift(1);
  FootTarget& swing = stance_.feet[1];
  swing.p_WF = right.p_WF + Eigen::Vector3d(0.01, -0.02, 0.03);
  swing.v_WF = {0.10, -0.05, 0.20};
  swing.contact.R_WF =
      Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitZ()).toRotationMatrix() * right.R_WF;
  stance_.com.v_WC = {0.03, -0.04, 0.02};
  InverseKinematics ik(stance_.robot, BareTasks(), kStanceTick_s);
  Run(1, &ik);

  // The left foot is where it is to stay, but for its height and tilt: gains of 5 and 4 a second.
  FootTwist stays;
  stays.linear.z() = -5.0 * left.p_WF.z();
  stays.angular = 4.0 * SmallTurn_W(left.R_WF, Eigen::Matrix3d::Identity());
  const Eigen::VectorXd nu = WithBaseTwist(stance_.body, 0, stays, command_.joint_velocity);
  const Eigen::Vector3d v_WF(0.10 + 0.05, -0.05 - 0.10, 0.20 + 0.15);
  EXPECT_LT((stance_.body.foot_jacobian(1).J * nu - v_WF).norm(), 1e-7);
  EXPECT_LT((stance_.body.foot_jacobian(1).J_rot * nu - Eigen::Vector3d(0.0, 0.0, 0.2)).norm(),
            1e-7);
  EXPECT_LT((stance_.body.com_jacobian() * nu - stance_.com.v_WC).norm(), 1e-7);
}

TEST_F(InverseKinematicsTest, ReferencesAreTheVelocitiesIntegrated) {
  InverseKinematics ik(stance_.robot, BareTasks(), kStanceTick_s);
  stance_.com.v_WC = {0.05, 0.05, 0.0};
  Run(1, &ik);
  const Eigen::VectorXd before = command_.joint_position;
  EXPECT_LT((before - stance_.state.joint_position - 0.005 * command_.joint_velocity).norm(), 1e-12)
      << "from the belief's joints at the start";
  stance_.state.joint_position.array() += 0.1;  // what servos make of them is another matter
  Run(1, &ik);
  EXPECT_LT((command_.joint_position - before - 0.005 * command_.joint_velocity).norm(), 1e-12);
  EXPECT_EQ(command_.torque_Nm.size(), 0);
}

TEST_F(InverseKinematicsTest, ComMovesAsAskedOverFeetThatStayUnderAnUprightTorso) {
  InverseKinematics ik(stance_.robot, BareTasks(), kStanceTick_s);
  Run(100, &ik);
  const RobotState start = Commanded();
  EXPECT_LT((start.p_WC - stance_.state.p_WC).norm(), 1e-4) << "home is at rest";
  stance_.com.v_WC = {0.02, 0.05, -0.02};
  for (int tenth = 1; tenth <= 5; ++tenth) {
    Run(20, &ik);
    const RobotState now = Commanded();
    // Half a tick of the CoM's acceleration at constant joint velocities, (0.1 m/s)^2 / 0.1 m.
    const Eigen::Vector3d moved = 0.1 * tenth * stance_.com.v_WC;
    EXPECT_LT((now.p_WC - start.p_WC - moved).norm(), 2e-4) << tenth;
    EXPECT_LT((now.feet[1].p_WF - start.feet[1].p_WF).norm(), 1e-4) << tenth;
    EXPECT_LT(Tilt_rad(now.feet[1].R_WF), 1e-3) << tenth;
    EXPECT_LT(Tilt_rad(stance_.body.torso().R_WT), 0.005) << tenth;
  }
}

TEST_F(InverseKinematicsTest, LeaningTorsoComesUprightWhileTheComStays) {
  stance_.state.joint_position[0] += 0.2;
  stance_.state.joint_position[1] += 0.1;
  stance_.body.Update(stance_.state);
  stance_.body.FillDerived(&stance_.state);
  EXPECT_GT(Tilt_rad(stance_.body.torso().R_WT), 0.2);
  InverseKinematics ik(stance_.robot, BareTasks(), kStanceTick_s);
  Run(40, &ik);
  Commanded();
  // One time constant of the gain, 0.2 s; the posture, at a hundredth, hardly resists.
  EXPECT_NEAR(Tilt_rad(stance_.body.torso().R_WT), 0.2236 * 0.368, 0.01);
  Run(260, &ik);
  const RobotState now = Commanded();
  EXPECT_LT(Tilt_rad(stance_.body.torso().R_WT), 0.001);
  EXPECT_LT((now.p_WC - stance_.state.p_WC).norm(), 2e-4);
}

TEST_F(InverseKinematicsTest, ArmsGoHomeWhichNoTaskHinders) {
  constexpr Eigen::Index kElbow = 6;
  ASSERT_EQ(stance_.robot.joints[kElbow].name, "l_elbow");
  stance_.state.joint_position[kElbow] += 0.4;
  stance_.body.Update(stance_.state);
  InverseKinematics ik(stance_.robot, BareTasks(), kStanceTick_s);
  Run(40, &ik);
  // A gain of 5 a second: after 0.2 s 1/e is left, more or less what the CoM asks of the arm.
  const double home_rad = stance_.robot.home.at("l_elbow");
  EXPECT_NEAR(command_.joint_position[kElbow] - home_rad, 0.4 * 0.368, 0.03);
}

TEST_F(InverseKinematicsTest, BelievedComBehindThePlanIsSentAfterIt) {
  InverseKinematicsParams params = BareTasks();
  params.com_feedback_per_s = 4.0;
  stance_.com.p_WC += Eigen::Vector3d(0.01, -0.005, 0.0);
  InverseKinematics ik(stance_.robot, params, kStanceTick_s);
  Run(20, &ik);
  Commanded();
  const Eigen::VectorXd nu = WithBaseTwist(stance_.body, 0, {}, command_.joint_velocity);
  const Eigen::Vector3d v_WC = stance_.body.com_jacobian() * nu;
  EXPECT_LT((v_WC - Eigen::Vector3d(0.04, -0.02, 0.0)).norm(), 1e-3) << "the belief stays behind";
}

TEST_F(InverseKinematicsTest, GroundThatCarriesAheadOfThePlanSendsTheComAhead) {
  InverseKinematicsParams params = BareTasks();
  params.zmp_feedback_per_s = 0.5;
  stance_.PlanWeightEvenly();  // around the feet's midpoint, for the soles are mirrored
  const double half_weight_N = 0.5 * 9.81 * stance_.body.mass_kg();
  for (FootState& foot : stance_.state.feet) {
    foot.wrench.force_N.z() = half_weight_N;
    foot.wrench.torque_Nm.y() = -0.02 * half_weight_N;  // 2 cm ahead
  }
  InverseKinematics ik(stance_.robot, params, kStanceTick_s);
  Run(20, &ik);
  Commanded();
  const Eigen::VectorXd nu = WithBaseTwist(stance_.body, 0, {}, command_.joint_velocity);
  const Eigen::Vector3d v_WC = stance_.body.com_jacobian() * nu;
  EXPECT_LT((v_WC - Eigen::Vector3d(0.01, 0.0, 0.0)).norm(), 5e-4);
}

TEST_F(InverseKinematicsTest, StandingFootTurnsWithAMomentThatThePlanHasNot) {
  InverseKinematicsParams params = BareTasks();
  params.foot_moment_compliance_radps_per_Nm = 0.002;
  stance_.PlanWeightEvenly();  // the pressure under F, for the soles are symmetric about it
  const Eigen::Vector3d level =
      4.0 * SmallTurn_W(stance_.body.feet()[1].R_WF, Eigen::Matrix3d::Identity());
  FootTwist stays;
  stays.linear.z() = -5.0 * stance_.body.feet()[0].p_WF.z();
  stays.angular = 4.0 * SmallTurn_W(stance_.body.feet()[0].R_WF, Eigen::Matrix3d::Identity());
  for (FootState& foot : stance_.state.feet) foot.wrench.force_N.z() = 200.0;
  stance_.state.feet[1].wrench.torque_Nm = {3.0, 5.0, 7.0};
  InverseKinematics ik(stance_.robot, params, kStanceTick_s);
  Run(1, &ik);
  const Eigen::VectorXd nu = WithBaseTwist(stance_.body, 0, stays, command_.joint_velocity);
  const Eigen::Vector3d w_WF = stance_.body.foot_jacobian(1).J_rot * nu;
  EXPECT_LT((w_WF - level - Eigen::Vector3d(0.006, 0.010, 0.0)).norm(), 1e-7);
}

// Toes 1 rad up is more than the ankle has.
TEST_F(InverseKinematicsTest, WeighedAttitudeOfASwingingFootLeavesTheTorsoAlone) {
  const auto tilt_rad = [this](double weight) {
    stance_ = {};
    stance_.Lift(1);
    stance_.feet[1].contact.R_WF =
        Eigen::AngleAxisd(-1.0, Eigen::Vector3d::UnitY()).toRotationMatrix();
    InverseKinematicsParams params = BareTasks();
    params.swing_attitude_weight = weight;
    InverseKinematics ik(stance_.robot, params, kStanceTick_s);
    for (int tick = 0; tick < 200; ++tick) Solve(&ik);
    Commanded();
    return SmallTurn_W(stance_.body.torso().R_WT, Eigen::Matrix3d::Identity()).norm();
  };
  EXPECT_LT(tilt_rad(0.01), 0.2 * tilt_rad(0.0));
}

TEST_F(InverseKinematicsTest, RobotWithoutServosBreaksTheContract) {
  stance_.robot.joints.clear();
  EXPECT_THROW(InverseKinematics(stance_.robot, BareTasks(), kStanceTick_s), ContractViolation);
}

}  // namespace
}  // namespace sidestep::wbc::inverse_kinematics_test
