// SPDX-License-Identifier: BSD-3-Clause
// Wrenches by hand, Jacobians of vertices by differences, cones by forces in and out of them.
#include "controller/wbc/contact_forces.h"

#include <gtest/gtest.h>

#include "tests/support/icub3_stance.h"
#include "tests/support/random_dense_qp.h"
#include "tests/support/reference_robot.h"

namespace sidestep::wbc::contact_forces_test {
namespace {

constexpr double kQuarter_rad = 0.5 * 3.14159265358979323846;
constexpr double kRounding = 1e-12;

TEST(FootWrenchTest, ForceAheadOfASoleThatIsTurnedLeftTurnsAboutX) {
  // 0.1 m ahead in F is 0.1 m to the left in W: 30 N upwards turn by 3 Nm about x.
  const Eigen::Matrix3d R_WF =
      Eigen::AngleAxisd(kQuarter_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  Eigen::Matrix3Xd vertices_m = Eigen::Matrix3Xd::Zero(3, 2), force_N = vertices_m;
  vertices_m(0, 0) = 0.1;
  vertices_m(0, 1) = -0.05;
  force_N.col(0) = Eigen::Vector3d(0.0, 0.0, 30.0);
  force_N.col(1) = Eigen::Vector3d(8.0, 0.0, 0.0);
  Eigen::Matrix<double, 6, 1> wrench;
  // 8 N along x, 0.05 m to the right of F: 0.4 Nm about z.
  wrench << 8.0, 0.0, 30.0, 3.0, 0.0, 0.4;
  EXPECT_LT((FootWrench(R_WF, vertices_m, force_N) - wrench).norm(), kRounding);
}

class ContactForcesTest : public testing::Test {
 protected:
  ContactForcesTest() {
    state_ = MovingIcub(stance_.body, 1);
    stance_.body.Update(state_);
    for (FootState& foot : state_.feet) foot.in_contact = true;
    double force_N = 10.0;
    for (FootTarget& foot : stance_.feet) {
      for (double& entry : foot.vertex_force_N.reshaped()) entry = force_N += 1.0;
    }
  }

  void Update() { forces_.Update(state_, stance_.body, stance_.feet); }

  Eigen::Index Vertices(std::size_t foot) const {
    return stance_.robot.feet[foot].vertices_m.cols();
  }

  Eigen::Vector3d Vertex(const RigidBody& body, std::size_t foot, Eigen::Index vertex) const {
    return body.feet()[foot].p_WF +
           body.feet()[foot].R_WF * stance_.robot.feet[foot].vertices_m.col(vertex);
  }

  IcubStance stance_;
  RobotState state_;
  const int nv_{stance_.body.num_velocities()};
  ContactForces forces_{stance_.robot, nv_, 0.5};
};

TEST_F(ContactForcesTest, JacobianIsTheDerivativeOfEveryVertexInContact) {
  constexpr double kStep = 1e-5;
  Update();
  ASSERT_EQ(forces_.size(), 3 * (Vertices(0) + Vertices(1)));
  ASSERT_GT(Vertices(0), 1) << "a point foot shows no lever";
  ReferenceRobot reference(stance_.robot);
  RigidBody after(stance_.body), before(stance_.body);
  for (int i = 0; i < nv_; ++i) {
    const Eigen::VectorXd nu = Eigen::VectorXd::Unit(nv_, i);
    after.Update(reference.Moved(state_, nu, kStep));
    before.Update(reference.Moved(state_, nu, -kStep));
    Eigen::Index row = 0;
    for (std::size_t foot = 0; foot < 2; ++foot) {
      for (Eigen::Index v = 0; v < Vertices(foot); ++v, row += 3) {
        const Eigen::Vector3d column =
            (Vertex(after, foot, v) - Vertex(before, foot, v)) / (2.0 * kStep);
        // As the feet's own Jacobians: kStep^2 times third derivatives, rounding over kStep.
        EXPECT_LT((forces_.jacobian().col(i).segment<3>(row) - column).norm(), 2e-8) << i;
      }
    }
  }
}

TEST_F(ContactForcesTest, AFootIsHeldAsFirmlyAsItBearsByPlanOrByFeel) {
  const double firm_N = kUnfeltShare * stance_.body.mass_kg() * stance_.body.gravity_mps2().norm();
  FootTarget& foot = stance_.feet[0];
  foot.vertex_force_N.setZero();
  foot.vertex_force_N(2, 0) = foot.vertex_force_N(2, 1) = 0.25 * firm_N;
  state_.feet[0].wrench.force_N.z() = 0.25 * firm_N;
  Update();
  EXPECT_DOUBLE_EQ(forces_.hold(0), 0.5) << "by plan";
  state_.feet[0].wrench.force_N.z() = 0.75 * firm_N;
  Update();
  EXPECT_DOUBLE_EQ(forces_.hold(0), 0.75) << "by feel";
  state_.feet[0].in_contact = false;
  Update();
  EXPECT_DOUBLE_EQ(forces_.hold(0), 0.5) << "what is below the threshold is not felt";
  foot.vertex_force_N.row(2).setConstant(firm_N);
  Update();
  EXPECT_EQ(forces_.hold(0), 1.0);
  foot.vertex_force_N.setZero();
  Update();
  EXPECT_EQ(forces_.hold(0), kLeastHold) << "never nothing: the problem stays regular";
}

TEST_F(ContactForcesTest, VerticesDoTheWorkOfTheirWrench) {
  Update();
  Eigen::VectorXd stacked(forces_.size());
  stacked << stance_.feet[0].vertex_force_N.reshaped(), stance_.feet[1].vertex_force_N.reshaped();
  const Eigen::VectorXd generalised = forces_.jacobian().transpose() * stacked;
  Eigen::VectorXd by_wrenches = Eigen::VectorXd::Zero(nv_);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const Eigen::Matrix<double, 6, 1> wrench =
        FootWrench(stance_.body.feet()[foot].R_WF, stance_.robot.feet[foot].vertices_m,
                   stance_.feet[foot].vertex_force_N);
    by_wrenches += stance_.body.foot_jacobian(foot).J.transpose() * wrench.head<3>() +
                   stance_.body.foot_jacobian(foot).J_rot.transpose() * wrench.tail<3>();
  }
  EXPECT_LT((generalised - by_wrenches).norm(), 1e-10 * by_wrenches.norm());
}

TEST_F(ContactForcesTest, FeetThatSupportAreTakenWhateverTheirSensorsSay) {
  stance_.feet[0].supports = false;
  Update();
  EXPECT_FALSE(forces_.stands(0));
  EXPECT_TRUE(forces_.stands(1));
  EXPECT_EQ(forces_.size(), 3 * Vertices(1));
  const Eigen::MatrixXd right = forces_.jacobian();
  stance_.feet[0].supports = true;
  state_.feet[0].in_contact = false;
  Update();
  EXPECT_TRUE(forces_.stands(0)) << "it bears little, and has not been lifted";
  EXPECT_EQ(forces_.size(), forces_.max_size());
  EXPECT_EQ(Eigen::MatrixXd(forces_.jacobian().bottomRows(3 * Vertices(1))), right);
  stance_.feet[0].supports = stance_.feet[1].supports = false;
  Update();
  EXPECT_EQ(forces_.size(), 0);
}

TEST_F(ContactForcesTest, FootThatIsNotFeltMayBearATenthOfTheWeightInAll) {
  Update();
  state_.feet[1].in_contact = false;
  Update();
  const int size = static_cast<int>(forces_.size());
  QpBuilder qp({nv_ + size, 0, static_cast<int>(forces_.max_rows())});
  qp.Start(nv_ + size);
  forces_.AddLimitsTo(400.0, &qp);
  const DenseQpView view = qp.View();
  ASSERT_EQ(view.C.rows(), 4 * size / 3 + 1);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(nv_ + size);
  EXPECT_EQ((view.C * x).tail(1)[0], static_cast<double>(Vertices(1))) << "of the right foot alone";
  EXPECT_DOUBLE_EQ(view.upper.tail(1)[0], 40.0);
}

TEST_F(ContactForcesTest, MomentAboutTheComIsDrawnToItsTarget) {
  Update();
  const int size = static_cast<int>(forces_.size());
  QpBuilder qp({nv_ + size, 0, 0});
  qp.Start(nv_ + size);
  const Eigen::Vector3d p_WC(0.1, -0.3, 0.8), target_Nm(4.0, -7.0, 2.0);
  forces_.AddMomentTo(p_WC, target_Nm, 0.5, &qp);
  SeededNumbers numbers(2);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(nv_ + size);
  x.tail(size) = numbers.NormalMatrix(size, 1);
  Eigen::Vector3d moment_Nm = Eigen::Vector3d::Zero();
  Eigen::Index at = nv_;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    for (Eigen::Index v = 0; v < Vertices(foot); ++v, at += 3) {
      moment_Nm += (Vertex(stance_.body, foot, v) - p_WC).cross(x.segment<3>(at));
    }
  }
  const DenseQpView view = qp.View();
  const double cost = 0.5 * x.dot(view.H * x) + view.g.dot(x);
  const double wanted = 0.25 * ((moment_Nm - target_Nm).squaredNorm() - target_Nm.squaredNorm());
  EXPECT_NEAR(cost, wanted, 1e-9 * std::abs(wanted));
  EXPECT_EQ(view.H.topRows(nv_).norm(), 0.0);
}

TEST_F(ContactForcesTest, ConesAndPlanStandAtTheForcesOfTheFeetInContact) {
  stance_.feet[0].supports = false;
  Update();
  const int size = static_cast<int>(forces_.size());
  QpBuilder qp({nv_ + size, 0, static_cast<int>(forces_.max_rows())});
  qp.Start(nv_ + size);
  forces_.AddPlanTo(0.25, &qp);
  forces_.AddLimitsTo(500.0, &qp);
  const DenseQpView view = qp.View();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(nv_ + size);
  x.tail(size) = stance_.feet[1].vertex_force_N.reshaped();
  EXPECT_LT((view.H * x + view.g).norm(), kRounding) << "the plan is the optimum";
  EXPECT_EQ(view.H.diagonal().head(nv_).norm(), 0.0);
  EXPECT_EQ(view.H(nv_, nv_), 0.25);

  ASSERT_EQ(view.C.rows(), 4 * size / 3);
  EXPECT_EQ(view.upper, Eigen::VectorXd::Zero(view.C.rows()));
  EXPECT_EQ(view.C.leftCols(nv_).norm(), 0.0);
  for (int vertex = 0; vertex < size / 3; ++vertex) {
    x.setZero();
    x.segment<3>(nv_ + 3 * vertex) = Eigen::Vector3d(3.0, 3.0, 10.0);  // beyond 0.5 * 10 in all
    const Eigen::VectorXd excess = view.C * x;
    EXPECT_NEAR(excess.maxCoeff(), 1.0, kRounding);
    EXPECT_EQ((excess.array() != 0.0).count(), 4) << "of this vertex alone";
  }
}

}  // namespace
}  // namespace sidestep::wbc::contact_forces_test
