// SPDX-License-Identifier: BSD-3-Clause
// Feet with several vertices: the answer against MuJoCo's inverse dynamics, and stances whose
// forces are known.
#include <gtest/gtest.h>

#include "controller/wbc/inverse_dynamics.h"
#include "tests/support/icub3_stance.h"
#include "tests/support/random_dense_qp.h"
#include "tests/support/reference_robot.h"

namespace sidestep::wbc::inverse_dynamics_sole_test {
namespace {

constexpr double kGravity_mps2 = 9.81;

class InverseDynamicsSoleTest : public testing::Test {
 protected:
  InverseDynamicsSoleTest() { stance_.PlanWeightEvenly(); }

  void Solve() {
    InverseDynamics dynamics(stance_.robot, params_, stance_.body);
    ASSERT_TRUE(
        dynamics.Solve(stance_.state, stance_.body, stance_.com, stance_.feet, &command_).ok);
    DenseQpSolver solver({100, 10, 120});
    x_ = solver.Solve(dynamics.problem()).x;
  }

  int nv() const { return stance_.body.num_velocities(); }
  double Weight_N() const { return kGravity_mps2 * stance_.body.mass_kg(); }

  Eigen::Vector3d Vertex(std::size_t foot, Eigen::Index v) const {
    return stance_.body.feet()[foot].p_WF +
           stance_.body.feet()[foot].R_WF * stance_.robot.feet[foot].vertices_m.col(v);
  }

  /// Of all vertices in contact: [force; moment about `p_W`].
  Eigen::Matrix<double, 6, 1> GroundWrench(const Eigen::Vector3d& p_W) const {
    Eigen::Matrix<double, 6, 1> wrench = Eigen::Matrix<double, 6, 1>::Zero();
    Eigen::Index at = nv();
    for (std::size_t foot = 0; foot < 2; ++foot) {
      if (!stance_.feet[foot].planned_contact) continue;
      for (Eigen::Index v = 0; v < stance_.robot.feet[foot].vertices_m.cols(); ++v, at += 3) {
        wrench.head<3>() += x_.segment<3>(at);
        wrench.tail<3>() += (Vertex(foot, v) - p_W).cross(x_.segment<3>(at));
      }
    }
    return wrench;
  }

  /// Plans that the feet bear the weight at `cop_F` of each sole, by forces that point to the CoM
  /// and so do not turn the robot, and what that makes of the CoM.
  void PlanCop(const Eigen::Vector2d& cop_F) {
    const Eigen::Vector3d& p_WC = stance_.state.p_WC;
    const Eigen::Vector2d slope = (p_WC.head<2>() - cop_F) / p_WC.z();
    stance_.com.a_WC << kGravity_mps2 * slope, 0.0;
    for (std::size_t foot = 0; foot < 2; ++foot) {
      const Eigen::Matrix3Xd& at = stance_.robot.feet[foot].vertices_m;
      const Eigen::Vector2d half = at.topRows<2>().rowwise().maxCoeff();
      for (Eigen::Index v = 0; v < 4; ++v) {  // shares bilinear over a centred rectangle
        const double share_x = 0.5 + 0.5 * cop_F.x() * at(0, v) / (half.x() * half.x());
        const double share_y = 0.5 + 0.5 * cop_F.y() * at(1, v) / (half.y() * half.y());
        const double force_N = 0.5 * Weight_N() * share_x * share_y;
        stance_.feet[foot].vertex_force_N.col(v) << force_N * slope, force_N;
      }
    }
  }

  IcubStance stance_;
  InverseDynamicsParams params_;
  ActuatorCommand command_;
  Eigen::VectorXd x_;  // [nudot; f]
};

TEST_F(InverseDynamicsSoleTest, AccelerationsAndForcesAreWhatMuJoCosInverseDynamicsMakesOfThem) {
  for (int variant = 0; variant < 3; ++variant) {
    RobotState moving = MovingIcub(stance_.body, variant);
    stance_.body.Update(moving);
    stance_.body.FillDerived(&moving);
    for (FootState& foot : moving.feet) foot.in_contact = true;
    moving.external_wrench = {{20.0, -30.0, 5.0}, {2.0, 1.0, -3.0}};
    stance_.state = moving;
    if (variant == 2) stance_.Lift(0);
    Solve();

    ReferenceRobot reference(stance_.robot);
    reference.Set(moving);
    mj_forward(reference.model(), reference.data());
    Eigen::Map<Eigen::VectorXd>(reference.data()->qacc, nv()) = x_.head(nv());
    mj_inverse(reference.model(), reference.data());
    Eigen::VectorXd left = Eigen::Map<const Eigen::VectorXd>(reference.data()->qfrc_inverse, nv());
    for (int i = 0; i < stance_.body.num_actuators(); ++i) {
      left[reference.model()->jnt_dofadr[reference.Joint(i)]] -= command_.torque_Nm[i];
    }
    Eigen::VectorXd applied = Eigen::VectorXd::Zero(nv());
    const auto apply = [&](int body, const Eigen::Vector3d& at, const Eigen::Vector3d& force_N,
                           const Eigen::Vector3d& torque_Nm) {
      mj_applyFT(reference.model(), reference.data(), force_N.data(), torque_Nm.data(), at.data(),
                 body, applied.data());
    };
    Eigen::Index at = nv();
    for (std::size_t foot = 0; foot < 2; ++foot) {
      if (!stance_.feet[foot].planned_contact) continue;
      const int body =
          reference.model()->site_bodyid[reference.Site(stance_.robot.feet[foot].frame)];
      for (Eigen::Index v = 0; v < stance_.robot.feet[foot].vertices_m.cols(); ++v, at += 3) {
        apply(body, Vertex(foot, v), x_.segment<3>(at), Eigen::Vector3d::Zero());
      }
    }
    ASSERT_EQ(at, x_.size());
    apply(RequireId(*reference.model(), mjOBJ_BODY, stance_.robot.base), moving.p_WC,
          moving.external_wrench.force_N, moving.external_wrench.torque_Nm);
    // The rows hold to 1e-9 of terms of up to 1e4 N m.
    EXPECT_LT((left - applied).norm(), 1e-4) << variant;
    EXPECT_GT(applied.norm(), 10.0);
  }
}

TEST_F(InverseDynamicsSoleTest, StillStanceBearsTheWeightBelowTheCom) {
  Solve();
  const Eigen::Matrix<double, 6, 1> wrench = GroundWrench(stance_.state.p_WC);
  EXPECT_LT((wrench.head<3>() - Eigen::Vector3d(0.0, 0.0, Weight_N())).norm(), 0.01 * Weight_N());
  EXPECT_LT(wrench.segment<2>(3).norm(), 0.002 * Weight_N()) << "2 mm";
  EXPECT_LT(x_.head(nv()).norm(), 0.2) << "nothing accelerates";
}

TEST_F(InverseDynamicsSoleTest, CentreOfPressureIsWhereThePlanHasIt) {
  for (const Eigen::Vector2d& cop_F :
       {Eigen::Vector2d(0.03, 0.0), Eigen::Vector2d(-0.05, 0.01), Eigen::Vector2d(0.0, -0.03)}) {
    PlanCop(cop_F);
    Solve();
    const Eigen::Matrix<double, 6, 1> wrench = GroundWrench(Eigen::Vector3d::Zero());
    const Eigen::Vector2d cop(-wrench[4] / wrench[2], wrench[3] / wrench[2]);
    // What the trunk's and the posture's soft tasks take of it: a few millimetres.
    EXPECT_NEAR(wrench[2], Weight_N(), 0.01 * Weight_N());
    EXPECT_LT((cop - cop_F).norm(), 0.007) << cop_F.transpose() << " became " << cop.transpose();
  }
}

TEST_F(InverseDynamicsSoleTest, PushThatIsKnownIsBorneByTheGround) {
  stance_.state.external_wrench.force_N = {40.0, 0.0, 0.0};
  stance_.state.external_wrench.torque_Nm = {0.0, 5.0, 0.0};
  // What the plan says then: the CoM stays, and the momentum does.
  for (FootTarget& foot : stance_.feet) {
    foot.vertex_force_N.row(0).setConstant(-40.0 / 8.0);
  }
  Solve();
  const Eigen::Matrix<double, 6, 1> wrench = GroundWrench(stance_.state.p_WC);
  EXPECT_NEAR(wrench[0], -40.0, 2.0);
  EXPECT_NEAR(wrench[4], -5.0, 1.0);
}

TEST_F(InverseDynamicsSoleTest, StandingSolesNeitherSlideNorTurn) {
  stance_.PlanWeightEvenly();
  stance_.com.a_WC = {0.5, 0.3, 0.2};
  Solve();
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const FrameJacobian& jacobian = stance_.body.foot_jacobian(foot);
    EXPECT_LT((jacobian.J * x_.head(nv())).norm(), 1e-2);
    EXPECT_LT((jacobian.J_rot * x_.head(nv())).norm(), 5e-2);
  }
  EXPECT_LT((stance_.body.com_jacobian() * x_.head(nv()) - stance_.com.a_WC).norm(), 0.15)
      << "what the soft tasks take";
}

TEST_F(InverseDynamicsSoleTest, SwingingSoleTurnsTowardsItsTargetAndGoesThere) {
  stance_.Lift(0);
  stance_.PlanWeightEvenly();
  stance_.feet[1].vertex_force_N *= 2.0;
  stance_.feet[0].p_WF += Eigen::Vector3d(0.001, 0.0, 0.002);
  stance_.feet[0].contact.R_WF =
      Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  Solve();
  const FrameJacobian& jacobian = stance_.body.foot_jacobian(0);
  // By hand: 900 times 1 and 2 mm, 400 times 0.01 rad; soft tasks take a tenth.
  EXPECT_LT((jacobian.J * x_.head(nv()) - Eigen::Vector3d(0.9, 0.0, 1.8)).norm(), 0.2);
  EXPECT_LT((jacobian.J_rot * x_.head(nv()) - Eigen::Vector3d(0.0, 0.0, 4.0)).norm(), 0.4);
}

TEST_F(InverseDynamicsSoleTest, FootThatLostTheGroundBearsLittleUntilItIsFeltAgain) {
  InverseDynamics dynamics(stance_.robot, params_, stance_.body);
  DenseQpSolver solver({100, 10, 120});
  const auto right_N = [&] {
    EXPECT_TRUE(
        dynamics.Solve(stance_.state, stance_.body, stance_.com, stance_.feet, &command_).ok);
    const Eigen::VectorXd x = solver.Solve(dynamics.problem()).x;
    double sum_N = 0.0;
    for (Eigen::Index v = 4; v < 8; ++v) sum_N += x[nv() + 3 * v + 2];
    return sum_N;
  };
  EXPECT_GT(right_N(), 0.4 * Weight_N());
  stance_.state.feet[1].in_contact = false;
  EXPECT_LT(right_N(), 0.1 * Weight_N() + 1e-6);
  stance_.state.feet[1].in_contact = true;
  EXPECT_GT(right_N(), 0.4 * Weight_N());
}

// Two vertices in one place bear what one bears: each half of it, at half the price of moving both.
TEST_F(InverseDynamicsSoleTest, SolesOfOnePlaceAreFeetOfOnePoint) {
  const auto torques = [&](Eigen::Index vertices) {
    RobotDescription robot = stance_.robot;
    params_ = {};
    params_.stand_rotation_weight = params_.swing_rotation_weight = 0.0;
    params_.planned_force_weight *= static_cast<double>(vertices);
    std::vector<FootTarget> feet = stance_.feet;
    for (std::size_t foot = 0; foot < 2; ++foot) {
      robot.feet[foot].vertices_m.setZero(3, vertices);
      feet[foot].vertex_force_N.setZero(3, vertices);
      feet[foot].vertex_force_N.row(2).setConstant(0.5 * Weight_N() /
                                                   static_cast<double>(vertices));
    }
    InverseDynamics dynamics(robot, params_, stance_.body);
    ActuatorCommand command;
    EXPECT_TRUE(dynamics.Solve(stance_.state, stance_.body, stance_.com, feet, &command).ok);
    return command.torque_Nm;
  };
  stance_.com.a_WC = {0.3, -0.2, 0.5};
  const Eigen::VectorXd one = torques(1);
  EXPECT_LT((torques(2) - one).norm(), 1e-6 * one.norm());
  EXPECT_GT(one.norm(), 10.0);
}

}  // namespace
}  // namespace sidestep::wbc::inverse_dynamics_sole_test
