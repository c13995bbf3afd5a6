// SPDX-License-Identifier: BSD-3-Clause
// Against MuJoCo's inverse dynamics of a model of its own, with the planned forces at the vertices.
#include "controller/wbc/servo_deflection.h"

#include <gtest/gtest.h>

#include "controller/wbc/inverse_kinematics.h"
#include "tests/support/icub3_stance.h"
#include "tests/support/reference_robot.h"

namespace sidestep::wbc::servo_deflection_test {
namespace {

class ServoDeflectionTest : public testing::Test {
 protected:
  ServoDeflectionTest() { stance_.PlanWeightEvenly(); }

  /// Joint torques (order of the actuators) that hold the robot at `state`, accelerations zero,
  /// while each vertex of the soles feels its planned force.
  Eigen::VectorXd HoldingTorque(const RobotState& state) {
    reference_.Set(state);
    const mjModel* model = reference_.model();
    mjData* data = reference_.data();
    mj_inverse(model, data);  // with qacc = 0
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(model->nv);
    const double no_torque_Nm[3] = {};
    for (std::size_t i = 0; i < 2; ++i) {
      const FootDescription& foot = stance_.robot.feet[i];
      const int body = model->site_bodyid[reference_.Site(foot.frame)];
      for (Eigen::Index v = 0; v < foot.vertices_m.cols(); ++v) {
        const Eigen::Vector3d p_WV = reference_.Position(foot.frame) +
                                     reference_.Rotation(foot.frame) * foot.vertices_m.col(v);
        const Eigen::Vector3d force_N = stance_.feet[i].vertex_force_N.col(v);
        mj_applyFT(model, data, force_N.data(), no_torque_Nm, p_WV.data(), body, forces.data());
      }
    }
    Eigen::VectorXd torque_Nm(model->nu);
    for (int i = 0; i < model->nu; ++i) {
      const int dof = model->jnt_dofadr[reference_.Joint(i)];
      torque_Nm[i] = data->qfrc_inverse[dof] - forces[dof];
    }
    return torque_Nm;
  }

  Eigen::VectorXd Torque(const Eigen::VectorXd& deflection_rad) const {
    Eigen::VectorXd torque_Nm = deflection_rad;
    for (std::size_t i = 0; i < stance_.robot.joints.size(); ++i) {
      torque_Nm[static_cast<Eigen::Index>(i)] *= stance_.robot.joints[i].servo_stiffness_Nm_per_rad;
    }
    return torque_Nm;
  }

  Eigen::Index Index(const std::string& joint) const {
    Eigen::Index at = 0;
    while (stance_.robot.joints[static_cast<std::size_t>(at)].name != joint) ++at;
    return at;
  }

  IcubStance stance_;
  ReferenceRobot reference_{stance_.robot};
  ServoDeflection servos_{stance_.robot, kStanceTick_s};
};

TEST_F(ServoDeflectionTest, AtRestOnBothFeetItHoldsWhatInverseDynamicsAsks) {
  const Eigen::VectorXd torque_Nm = HoldingTorque(stance_.state);
  EXPECT_LT((Torque(servos_.Update(stance_.body, stance_.feet)) - torque_Nm).norm(), 1e-8);
  // Bent knees under half the weight each, about 0.1 m behind the line from CoM to foot.
  EXPECT_GT(std::abs(torque_Nm[Index("l_knee")]), 10.0);
  EXPECT_NEAR(torque_Nm[Index("l_knee")], torque_Nm[Index("r_knee")], 0.5) << "both alike";
}

TEST_F(ServoDeflectionTest, ReferenceLeadsTheKneeAgainstTheWeight) {
  // iCub's knee flexes negative: the weight bends it, the servo must push towards straight.
  EXPECT_GT(servos_.Update(stance_.body, stance_.feet)[Index("l_knee")], 0.0);
}

TEST_F(ServoDeflectionTest, ForcesAtOneVertexAndInMotionHoldTheSame) {
  RobotState state = MovingIcub(stance_.body, 1);
  state.joint_velocity *= 0.1;  // torques stay within the motors'
  state.w_WB_B.setZero();
  stance_.body.Update(state);
  stance_.feet[0].vertex_force_N.setZero();
  stance_.feet[0].vertex_force_N.col(1) = Eigen::Vector3d(12.0, -7.0, 40.0);
  stance_.feet[1].vertex_force_N.setZero();
  stance_.feet[1].vertex_force_N.col(3) = Eigen::Vector3d(-5.0, 9.0, 60.0);
  const Eigen::VectorXd torque_Nm = HoldingTorque(state);
  ASSERT_LT((torque_Nm.cwiseAbs() - stance_.body.torque_limit_Nm()).maxCoeff(), 0.0);
  EXPECT_LT((Torque(servos_.Update(stance_.body, stance_.feet)) - torque_Nm).norm(), 1e-8);
}

TEST_F(ServoDeflectionTest, TorquesStopAtTheMotorsLimits) {
  for (FootTarget& foot : stance_.feet) foot.vertex_force_N *= 100.0;
  const Eigen::VectorXd wanted_Nm = HoldingTorque(stance_.state);
  const Eigen::VectorXd torque_Nm = Torque(servos_.Update(stance_.body, stance_.feet));
  int clamped = 0;
  for (Eigen::Index i = 0; i < wanted_Nm.size(); ++i) {
    const double limit_Nm = stance_.body.torque_limit_Nm()[i];
    if (std::abs(wanted_Nm[i]) > limit_Nm) {
      EXPECT_NEAR(torque_Nm[i], wanted_Nm[i] > 0.0 ? limit_Nm : -limit_Nm, 1e-9) << i;
      ++clamped;
    } else {
      EXPECT_NEAR(torque_Nm[i], wanted_Nm[i], 1e-6) << i;
    }
  }
  EXPECT_GE(clamped, 6) << "hardly any torque";
  EXPECT_EQ(stance_.body.torque_limit_Nm()[Index("l_knee")], 110.0);
}

TEST_F(ServoDeflectionTest, ChangedPlanArrivesWithinATenthOfASecondAndWithoutAJump) {
  const Eigen::Index knee = Index("l_knee");
  const double first_Nm = Torque(servos_.Update(stance_.body, stance_.feet))[knee];
  stance_.feet[0].vertex_force_N *= 2.0;
  stance_.feet[1].vertex_force_N.setZero();
  const double last_Nm = HoldingTorque(stance_.state)[knee];
  ASSERT_GT(std::abs(last_Nm - first_Nm), 10.0);
  double share = 0.0;
  for (int tick = 1; tick <= 30; ++tick) {
    const double now_Nm = Torque(servos_.Update(stance_.body, stance_.feet))[knee];
    const double before = share;
    share = (now_Nm - first_Nm) / (last_Nm - first_Nm);
    EXPECT_GT(share, before);
    EXPECT_LT(share - before, 0.2) << "a jump";
    if (tick == 6) {
      EXPECT_NEAR(share, 0.632, 0.05) << "30 ms: 1 - 1/e, blurred by half a tick of 5 ms";
    }
  }
  EXPECT_GT(share, 0.98);
}

TEST_F(ServoDeflectionTest, InverseKinematicsAddsItToItsReferences) {
  InverseKinematicsParams params = BareTasks();
  InverseKinematics bare(stance_.robot, params, kStanceTick_s);
  params.compensates_deflection = true;
  InverseKinematics compensating(stance_.robot, params, kStanceTick_s);
  ActuatorCommand without, with;
  bare.Solve(stance_.state, stance_.body, stance_.com, stance_.feet, &without);
  compensating.Solve(stance_.state, stance_.body, stance_.com, stance_.feet, &with);
  // The reference moves by 1e-4 rad from home in a tick, and its torques by as little.
  const Eigen::VectorXd torque_Nm = Torque(with.joint_position - without.joint_position);
  EXPECT_LT((torque_Nm - HoldingTorque(stance_.state)).cwiseAbs().maxCoeff(), 0.05);
  EXPECT_EQ(with.joint_velocity, without.joint_velocity);
}

}  // namespace
}  // namespace sidestep::wbc::servo_deflection_test
