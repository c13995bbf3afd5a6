// SPDX-License-Identifier: BSD-3-Clause
// How the belief moves the commanded robot, and where feet are held once they have landed.
#include <gtest/gtest.h>

#include "controller/wbc/inverse_kinematics.h"
#include "tests/support/icub3_stance.h"
#include "tests/support/reference_robot.h"
#include "tests/unit/wbc/foot_velocity.h"

namespace sidestep::wbc::inverse_kinematics_anchor_test {
namespace {

constexpr double kAtOnce_per_s = 1.0 / kStanceTick_s;

class InverseKinematicsAnchorTest : public testing::Test {
 protected:
  /// References after `ticks` of the stance's belief and targets.
  const ActuatorCommand& Run(int ticks, InverseKinematics* ik) {
    for (int tick = 0; tick < ticks; ++tick) {
      EXPECT_TRUE(ik->Solve(stance_.state, stance_.body, stance_.com, stance_.feet, &command_).ok)
          << tick;
    }
    return command_;
  }

  /// Turns belief and targets by `yaw_rad` about the world's origin, then shifts them.
  void Displace(double yaw_rad, const Eigen::Vector3d& shift, bool targets_too = true) {
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    const auto move = [&](Eigen::Vector3d* p) { *p = R * *p + shift; };
    move(&stance_.state.p_WB);
    stance_.state.q_WB = Eigen::Quaterniond(R) * stance_.state.q_WB;
    move(&stance_.state.p_WC);
    move(&stance_.com.p_WC);
    stance_.com.v_WC = R * stance_.com.v_WC;
    for (std::size_t i = 0; i < 2; ++i) {
      FootState& foot = stance_.state.feet[i];
      move(&foot.p_WF);
      foot.R_WF = R * foot.R_WF;
      foot.wrench.force_N = R * foot.wrench.force_N;
      foot.wrench.torque_Nm = R * foot.wrench.torque_Nm;
      FootTarget& target = stance_.feet[i];
      if (!targets_too) continue;
      move(&target.p_WF);
      move(&target.contact.adjusted_p_WF);
      target.v_WF = R * target.v_WF;
      target.contact.R_WF = R * target.contact.R_WF;
      target.vertex_force_N = R * target.vertex_force_N;
    }
  }

  /// Left foot swings to a place ahead.
  void SwingLeft() {
    stance_.Lift(0);
    stance_.feet[0].p_WF += Eigen::Vector3d(0.03, 0.01, 0.03);
  }

  IcubStance stance_;
  ActuatorCommand command_;
};

TEST_F(InverseKinematicsAnchorTest, TurnedAndShiftedWorldGetsTheSameReferences) {
  InverseKinematicsParams params;  // all feedback, anchors and compensation
  stance_.PlanWeightEvenly();
  stance_.com.v_WC = {0.02, 0.03, -0.01};
  for (FootState& foot : stance_.state.feet) foot.wrench = {{5.0, -8.0, 250.0}, {3.0, -4.0, 1.0}};
  InverseKinematics here(stance_.robot, params, kStanceTick_s);
  Run(10, &here);
  SwingLeft();
  const Eigen::VectorXd references = Run(10, &here).joint_position;

  stance_ = IcubStance();
  stance_.PlanWeightEvenly();
  stance_.com.v_WC = {0.02, 0.03, -0.01};
  for (FootState& foot : stance_.state.feet) foot.wrench = {{5.0, -8.0, 250.0}, {3.0, -4.0, 1.0}};
  // The soles' moments are about a ground at z = 0 in both worlds.
  Displace(0.7, {1.0, -2.0, 0.0});
  InverseKinematics there(stance_.robot, params, kStanceTick_s);
  Run(10, &there);
  stance_.Lift(0);
  stance_.feet[0].p_WF +=
      Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) * Eigen::Vector3d(0.03, 0.01, 0.03);
  // Twenty solves to 1e-9 of numbers of size 1.
  EXPECT_LT((Run(10, &there).joint_position - references).cwiseAbs().maxCoeff(), 1e-7);
}

TEST_F(InverseKinematicsAnchorTest, BeliefThatSlidesAwayLeavesTheJointsOfAStandingRobotAlone) {
  InverseKinematicsParams params = BareTasks();
  params.position_anchor_per_s = 10.0;
  InverseKinematics ik(stance_.robot, params, kStanceTick_s);
  InverseKinematics twin(stance_.robot, params, kStanceTick_s);
  Run(10, &ik);
  const Eigen::VectorXd unmoved = Run(110, &twin).joint_position;
  Displace(0.0, {0.05, -0.03, 0.0}, false);
  EXPECT_LT((Run(100, &ik).joint_position - unmoved).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(InverseKinematicsAnchorTest, AnchoredRobotSwingsToItsTargetFromWhereTheBeliefSeesIt) {
  InverseKinematicsParams params = BareTasks();
  const auto swung = [&](double anchor_per_s, const Eigen::Vector3d& shift) {
    stance_ = IcubStance();
    params.position_anchor_per_s = anchor_per_s;
    InverseKinematics ik(stance_.robot, params, kStanceTick_s);
    Run(1, &ik);
    SwingLeft();
    Displace(0.0, shift);
    return Eigen::VectorXd(Run(20, &ik).joint_position);
  };
  const Eigen::Vector3d shift(0.02, -0.01, 0.0);
  const Eigen::VectorXd plain = swung(kAtOnce_per_s, Eigen::Vector3d::Zero());
  // All has moved: belief, target and, at once, the commanded robot.
  EXPECT_LT((swung(kAtOnce_per_s, shift) - plain).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_GT((swung(0.0, shift) - plain).cwiseAbs().maxCoeff(), 1e-3) << "the target alone moved";
  const double slow = (swung(10.0, shift) - plain).cwiseAbs().maxCoeff();
  EXPECT_GT(slow, 1e-5);
  EXPECT_LT(slow, (swung(0.0, shift) - plain).cwiseAbs().maxCoeff()) << "some of the way";
}

TEST_F(InverseKinematicsAnchorTest, FeetThatAreNotFeltAnchorNothing) {
  InverseKinematicsParams params = BareTasks();
  InverseKinematics twin(stance_.robot, params, kStanceTick_s);
  const Eigen::VectorXd unmoved = Run(20, &twin).joint_position;
  params.position_anchor_per_s = kAtOnce_per_s;
  params.attitude_anchor_per_s = kAtOnce_per_s;
  InverseKinematics ik(stance_.robot, params, kStanceTick_s);
  Run(1, &ik);
  for (FootState& foot : stance_.state.feet) foot.in_contact = false;
  Displace(0.5, {1.0, 1.0, 0.0}, false);
  EXPECT_LT((Run(19, &ik).joint_position - unmoved).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_F(InverseKinematicsAnchorTest, TiltOfTheBeliefTurnsTheSolesFlatAgainUnderTheSameCom) {
  constexpr double kTilt_rad = 0.02;  // forward
  InverseKinematicsParams params = BareTasks();
  params.attitude_anchor_per_s = kAtOnce_per_s;
  InverseKinematics ik(stance_.robot, params, kStanceTick_s);
  Run(1, &ik);
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(kTilt_rad, Eigen::Vector3d::UnitY()));
  const Eigen::Vector3d between = 0.5 * (stance_.feet[0].p_WF + stance_.feet[1].p_WF);
  RobotState tilted = StandOnFoot(0, stance_.feet[0].p_WF, command_.joint_position, &stance_.body);
  tilted.q_WB = tilt * tilted.q_WB;
  tilted.p_WB = between + tilt * (tilted.p_WB - between);
  stance_.body.Update(tilted);
  stance_.state.q_WB = tilted.q_WB;
  Run(1, &ik);

  // By hand: the soles turn back by 4 a second of 0.02 rad; each is held where it stood, to which
  // it returns by 5 a second.
  const FootKinematics left = stance_.body.feet()[0], right = stance_.body.feet()[1];
  const Eigen::Vector3d turns_back(0.0, -4.0 * kTilt_rad, 0.0);
  const auto returns = [&](const FootKinematics& foot, std::size_t i) -> Eigen::Vector3d {
    Eigen::Vector3d from_hold = stance_.feet[i].p_WF - foot.p_WF;
    from_hold.z() = -foot.p_WF.z();
    return 5.0 * from_hold;
  };
  const Eigen::VectorXd nu =
      WithBaseTwist(stance_.body, 0, {returns(left, 0), turns_back}, command_.joint_velocity);
  // The commanded robot is where this one is to the rounding of home, 1e-4 rad and 1e-5 m.
  EXPECT_LT((stance_.body.foot_jacobian(1).J_rot * nu - turns_back).norm(), 1e-3);
  EXPECT_LT((stance_.body.foot_jacobian(1).J * nu - returns(right, 1)).norm(), 1e-3);
  EXPECT_LT((stance_.body.com_jacobian() * nu).norm(), 1e-3);
  // Standing rigidly on the turning sole the CoM, 0.54 m above it, would go back by 0.04 m/s.
  const Eigen::VectorXd stiff =
      WithBaseTwist(stance_.body, 0, {returns(left, 0), turns_back}, Eigen::VectorXd::Zero(23));
  EXPECT_LT((stance_.body.com_jacobian() * stiff).x(), -0.03);
}

class LandingTest : public InverseKinematicsAnchorTest {
 protected:
  /// The left foot in the frame of the right one, by the references.
  Eigen::Vector3d LeftFromRight() {
    const RobotState state =
        StandOnFoot(1, Eigen::Vector3d::Zero(), command_.joint_position, &stance_.body);
    return state.feet[0].p_WF;
  }

  InverseKinematics ik_{stance_.robot, BareTasks(), kStanceTick_s};
};

TEST_F(LandingTest, FootThatLandsIsHeldWhereItWasCommanded) {
  Run(1, &ik_);
  const Eigen::Vector3d home = LeftFromRight();
  SwingLeft();
  Run(20, &ik_);
  const Eigen::Vector3d landing = LeftFromRight();
  EXPECT_GT((landing - home).x(), 0.005) << "under way";
  EXPECT_LT((landing - home).x(), 0.025) << "but not there";
  stance_.feet[0].planned_contact = true;
  stance_.state.feet[0].in_contact = true;
  Run(200, &ik_);
  const Eigen::Vector3d held = LeftFromRight();
  // 1 s of 5 a second: all but e^-5 of the height, 0.1 mm, is gone.
  EXPECT_LT((held - landing).head<2>().norm(), 1e-4);
  EXPECT_LT(std::abs(held.z()), 2e-4) << "flat on the ground";
}

TEST_F(LandingTest, FootThatIsNotFeltYetGoesOnToItsTarget) {
  Run(1, &ik_);
  const Eigen::Vector3d home = LeftFromRight();
  SwingLeft();
  Run(20, &ik_);
  stance_.feet[0].planned_contact = true;
  Run(200, &ik_);
  EXPECT_LT((LeftFromRight() - home - Eigen::Vector3d(0.03, 0.01, 0.03)).norm(), 3e-4);
}

TEST_F(LandingTest, FootThatTouchesBeforeItsTimeGoesOnToItsTarget) {
  Run(1, &ik_);
  const Eigen::Vector3d home = LeftFromRight();
  SwingLeft();
  stance_.state.feet[0].in_contact = true;
  Run(200, &ik_);
  EXPECT_LT((LeftFromRight() - home - Eigen::Vector3d(0.03, 0.01, 0.03)).norm(), 3e-4);
}

}  // namespace
}  // namespace sidestep::wbc::inverse_kinematics_anchor_test
