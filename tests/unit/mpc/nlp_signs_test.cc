// SPDX-License-Identifier: BSD-3-Clause
// Numbers worked by hand. Differences and symmetry cannot see a sign or a factor that is wrong
// everywhere; these can. The robot weighs 2 kg, the step is 0.1 s.
#include <gtest/gtest.h>

#include "controller/mpc/ipopt/centroidal_nlp.h"
#include "controller/mpc/ipopt/nlp_points.h"
#include "controller/mpc/problem/solution_shape.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::nlp_signs_test {
namespace {

constexpr double kTolerance = 1e-12;  // A handful of operations on numbers of order ten.

OcpContact Standing(OcpContact foot, int knots, const Eigen::Vector3d& p_WF) {
  foot.phases = {FixedPhase(0, knots + 1, p_WF)};
  return foot;
}

class NlpSignsTest : public testing::Test {
 protected:
  /// The problem with all weights zero, for one to be set alone.
  static CentroidalOcp Unweighted(int knots) {
    CentroidalOcp ocp = FloatingProblem(knots);
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    ocp.weights = {zero, zero, zero, zero, zero, zero};
    ocp.gravity_mps2.setZero();
    return ocp;
  }

  static Eigen::VectorXd Pack(const CentroidalNlp& nlp, const MpcSolution& point) {
    Eigen::VectorXd x;
    PackPoint(nlp.ocp(), nlp.layout(), point, &x);
    return x;
  }

  static double CostOf(const CentroidalOcp& ocp, const MpcSolution& point) {
    CentroidalNlp nlp;
    nlp.SetProblem(ocp);
    return nlp.Cost(Pack(nlp, point));
  }

  /// The nine values that state 1 must have, in SI: with state 1 at zero the residual is minus
  /// what the dynamics add, divided by the mass for the momenta.
  static Eigen::VectorXd NextState(const CentroidalOcp& ocp, MpcSolution point) {
    CentroidalNlp nlp;
    nlp.SetProblem(ocp);
    point.p_WC.col(1).setZero();
    point.linear_momentum.col(1).setZero();
    point.angular_momentum.col(1).setZero();
    Eigen::VectorXd g(nlp.num_constraints());
    nlp.Constraints(Pack(nlp, point), g);
    Eigen::VectorXd next = -g.head(9);
    next.tail(6) *= ocp.mass_kg;
    return next;
  }

  static MpcSolution ZeroPoint(const CentroidalOcp& ocp) {
    MpcSolution point;
    ResetToShape(ocp, &point);
    return point;
  }

  static void ExpectNear(const Eigen::VectorXd& value, const Eigen::VectorXd& expected) {
    ASSERT_EQ(value.size(), expected.size());
    EXPECT_LT((value - expected).cwiseAbs().maxCoeff(), kTolerance)
        << value.transpose() << " is not " << expected.transpose();
  }
};

TEST_F(NlpSignsTest, UpwardForceAheadOfTheComPitchesTheNoseUp) {
  // x^ x z^ = -y^: 100 N up, 0.2 m ahead, 0.1 s long is -20 N m * 0.1 s = -2 kg m^2/s about y.
  CentroidalOcp ocp = Unweighted(1);
  ocp.contacts = {Standing(Foot("foot", 1), 1, {0.2, 0.0, 0.0})};
  MpcSolution point = ZeroPoint(ocp);
  point.contacts[0].force_N[0] = Eigen::Vector3d(0.0, 0.0, 100.0);
  Eigen::VectorXd expected(9);
  expected << 0, 0, 0, 0, 0, 10, 0, -2, 0;
  ExpectNear(NextState(ocp, point), expected);
}

TEST_F(NlpSignsTest, AForceActsAtItsVertexInTheTiltedContactFrame) {
  // Foot at (1, 0, 0), vertex 0.3 m along its own x, which points along world y after 90 degrees
  // of yaw: arm (1, 0.3, 0) - (0.5, 0, 0) = (0.5, 0.3, 0). Force (0, 0, 10) N: moment
  // (0.3 * 10, -0.5 * 10, 0) = (3, -5, 0) N m, a tenth of that a step.
  CentroidalOcp ocp = Unweighted(1);
  ocp.initial_p_WC << 0.5, 0.0, 0.0;
  OcpContact foot = Standing(Foot("foot", 1), 1, {1.0, 0.0, 0.0});
  foot.vertices_m.col(0) << 0.3, 0.0, 0.0;
  foot.phases[0].R_WF << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  ocp.contacts = {foot};
  MpcSolution point = ZeroPoint(ocp);
  point.contacts[0].force_N[0] = Eigen::Vector3d(0.0, 0.0, 10.0);
  Eigen::VectorXd expected(9);
  expected << 0.5, 0, 0, 0, 0, 1, 0.3, -0.5, 0;
  ExpectNear(NextState(ocp, point), expected);
}

TEST_F(NlpSignsTest, GravityMomentumAndMeasuredWrenchAdvanceTheState) {
  // p: (1, 2, 3) + 0.1 * (4, 6, 8) / 2. hp: (4, 6, 8) + 0.1 (2 * (0, 0, -10) + (40, 0, 0)).
  // hw: (1, 1, 1) + 0.1 * (0, 7, -3).
  CentroidalOcp ocp = Unweighted(1);
  ocp.gravity_mps2 << 0, 0, -10;
  ocp.initial_p_WC << 1, 2, 3;
  ocp.initial_linear_momentum << 4, 6, 8;
  ocp.initial_angular_momentum << 1, 1, 1;
  ocp.external_force_N.col(0) << 40, 0, 0;
  ocp.external_torque_Nm.col(0) << 0, 7, -3;
  Eigen::VectorXd expected(9);
  expected << 1.2, 2.3, 3.4, 8, 6, 6, 1, 1.7, 0.7;
  ExpectNear(NextState(ocp, ZeroPoint(ocp)), expected);
}

TEST_F(NlpSignsTest, TheFirstKnotMayBeShorterThanTheOthers) {
  // As above for 0.02 s: p + 0.02 * (4, 6, 8) / 2, hp + 0.02 (2 * (0, 0, -10) + (40, 0, 0)) and
  // hw + 0.02 * (0, 7, -3).
  CentroidalOcp ocp = Unweighted(2);
  ocp.first_step_s = 0.02;
  ocp.gravity_mps2 << 0, 0, -10;
  ocp.initial_p_WC << 1, 2, 3;
  ocp.initial_linear_momentum << 4, 6, 8;
  ocp.initial_angular_momentum << 1, 1, 1;
  ocp.external_force_N.col(0) << 40, 0, 0;
  ocp.external_torque_Nm.col(0) << 0, 7, -3;
  Eigen::VectorXd expected(9);
  expected << 1.04, 2.06, 3.08, 4.8, 6, 7.6, 1, 1.14, 0.94;
  ExpectNear(NextState(ocp, ZeroPoint(ocp)), expected);
}

TEST_F(NlpSignsTest, StateCostsCountEveryKnotWithTheHalf) {
  // CoM 0.2 m off along y at knots 0 and 1: 2 * 0.5 * 4 * 0.04 = 0.16. Angular momentum 6 against
  // a reference of 2 kg m^2/s about x at knot 1 only: 0.5 * 3 * (4 / 2)^2 = 6.
  CentroidalOcp ocp = Unweighted(1);
  ocp.weights.com << 1, 4, 1;
  ocp.weights.angular_momentum << 3, 1, 1;
  ocp.reference_p_WC.row(1).setConstant(-0.2);
  ocp.reference_angular_momentum(0, 1) = 2.0;
  MpcSolution point = ZeroPoint(ocp);
  point.angular_momentum(0, 1) = 6.0;
  EXPECT_NEAR(CostOf(ocp, point), 6.16, kTolerance);
}

TEST_F(NlpSignsTest, ForceRateIsPerMassAndStep) {
  // 3 N more from knot to knot: 0.5 * 0.2 * (3 / (2 * 0.1))^2 = 22.5, and once more from the
  // previous force, which is 3 N above: 45.
  CentroidalOcp ocp = Unweighted(2);
  ocp.weights.force_rate << 0, 0, 0.2;
  ocp.contacts = {Standing(Foot("foot", 1), 2, Eigen::Vector3d::Zero())};
  MpcSolution point = ZeroPoint(ocp);
  point.contacts[0].force_N[0] = Eigen::Vector3d(5.0, 0.0, 10.0);
  point.contacts[0].force_N[1] = Eigen::Vector3d(9.0, 0.0, 13.0);
  EXPECT_NEAR(CostOf(ocp, point), 22.5, kTolerance);
  ocp.contacts[0].has_previous_force = true;
  ocp.contacts[0].previous_force_N = Eigen::Vector3d(0.0, 0.0, 13.0);
  EXPECT_NEAR(CostOf(ocp, point), 45.0, kTolerance);
  ocp.first_step_s = 0.01;  // Rates are of the changes over T all the same.
  EXPECT_NEAR(CostOf(ocp, point), 45.0, kTolerance);
}

TEST_F(NlpSignsTest, ForceRateDoesNotReachAcrossPhasesThatTouch) {
  CentroidalOcp ocp = Unweighted(2);
  ocp.weights.force_rate << 0, 0, 0.2;
  OcpContact foot = Foot("foot", 1);
  foot.phases = {FixedPhase(0, 1, Eigen::Vector3d::Zero()),
                 FixedPhase(1, 3, Eigen::Vector3d::UnitX())};
  ocp.contacts = {foot};
  MpcSolution point = ZeroPoint(ocp);
  point.contacts[0].force_N[1] = Eigen::Vector3d(0.0, 0.0, 13.0);
  EXPECT_EQ(CostOf(ocp, point), 0.0);
}

TEST_F(NlpSignsTest, SymmetryCountsTheDistanceOfEveryVertexFromTheMean) {
  // 10 and 4 N: mean 7, both 3 N off. 2 * 0.5 * 20 * (3 / 2)^2 = 45.
  CentroidalOcp ocp = Unweighted(1);
  ocp.weights.force_symmetry << 0, 0, 20;
  ocp.contacts = {Standing(Foot("foot", 2), 1, Eigen::Vector3d::Zero())};
  MpcSolution point = ZeroPoint(ocp);
  point.contacts[0].force_N[0].row(2) << 10.0, 4.0;
  EXPECT_NEAR(CostOf(ocp, point), 45.0, kTolerance);
}

TEST_F(NlpSignsTest, AFootsLoadCountsAboveItsLimitOnceAKnot) {
  // 10 and 4 N bear 14 N, 6 above the limit: 0.5 * 3 * (6 / 2)^2 = 13.5, and at the other knot
  // nothing, nor for pulling or lateral forces, nor for the other foot within its limit.
  CentroidalOcp ocp = Unweighted(2);
  ocp.weights.foot_load = 3.0;
  ocp.foot_load_limit_N = 8.0;
  ocp.contacts = {Standing(Foot("foot", 2), 2, Eigen::Vector3d::Zero()),
                  Standing(Foot("other", 1), 2, Eigen::Vector3d::Zero())};
  ocp.contacts[0].phases[0].R_WF << 1, 0, 0, 0, 0, -1, 0, 1, 0;  // z is the world's all the same
  MpcSolution point = ZeroPoint(ocp);
  point.contacts[0].force_N[0].row(2) << 10.0, 4.0;
  point.contacts[0].force_N[0].row(0) << 100.0, 100.0;
  point.contacts[0].force_N[1].row(2) << 10.0, -14.0;
  point.contacts[1].force_N[0] = Eigen::Vector3d(0.0, 20.0, 8.0);
  EXPECT_NEAR(CostOf(ocp, point), 13.5, kTolerance);
  ocp.weights.foot_load = 0.0;
  EXPECT_EQ(CostOf(ocp, point), 0.0);
}

TEST_F(NlpSignsTest, NewContactForceCountsOnlyForATouchDownAtTheLastInput) {
  // (6 / 2)^2 * 0.5 * 0.01 = 0.045.
  CentroidalOcp ocp = Unweighted(2);
  ocp.weights.new_contact_force << 0, 0, 0.01;
  OcpContact foot = Foot("foot", 1);
  foot.phases = {FixedPhase(1, 3, Eigen::Vector3d::Zero())};
  ocp.contacts = {foot};
  MpcSolution point = ZeroPoint(ocp);
  point.contacts[0].force_N[1] = Eigen::Vector3d(0.0, 0.0, 6.0);
  EXPECT_NEAR(CostOf(ocp, point), 0.045, kTolerance);
  ocp.contacts[0].phases[0].first_knot = 0;
  EXPECT_EQ(CostOf(ocp, point), 0.0);
}

TEST_F(NlpSignsTest, ContactPositionCountsOncePerKnotUpToTheEndInWorldAxes) {
  // Knots 1, 2 (the end included, beyond it not) at 0.1 m along world y: 2 * 0.5 * 400 * 0.01 = 4.
  CentroidalOcp ocp = Unweighted(2);
  ocp.weights.contact_position << 1, 400, 1;
  OcpContact foot = Foot("foot", 1);
  foot.phases = {FreePhase(1, 9, {1.0, 0.0, 0.0}, Eigen::Vector3d::Ones())};
  foot.phases[0].R_WF << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  ocp.contacts = {foot};
  MpcSolution point = ZeroPoint(ocp);
  point.contacts[0].phase_p_WF[0] << 1.0, 0.1, 0.0;
  EXPECT_NEAR(CostOf(ocp, point), 4.0, kTolerance);
}

TEST_F(NlpSignsTest, AFootAtTheEndOfTheHorizonCostsOnceAndHasNoForce) {
  CentroidalOcp ocp = Unweighted(2);
  ocp.weights.contact_position << 0, 400, 0;
  OcpContact foot = Foot("foot", 1);
  foot.phases = {FreePhase(2, 9, Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones())};
  ocp.contacts = {foot};
  CentroidalNlp nlp;
  nlp.SetProblem(ocp);
  EXPECT_EQ(nlp.num_variables(), 2 * 9 + 3);
  EXPECT_EQ(nlp.num_constraints(), 2 * 9);
  MpcSolution point = ZeroPoint(ocp);
  point.contacts[0].phase_p_WF[0] << 0.0, 0.1, 0.0;
  EXPECT_NEAR(CostOf(ocp, point), 2.0, kTolerance);
}

TEST_F(NlpSignsTest, TheBoxBoundsTheFootInItsOwnFrameAwayFromTheNominal) {
  // After 90 degrees of yaw the foot's x is world y: 0.1 m along world y is +0.1 m along x_F.
  CentroidalOcp ocp = Unweighted(1);
  OcpContact foot = Foot("foot", 1);
  foot.phases = {FreePhase(0, 2, {1.0, 1.0, 0.0}, Eigen::Vector3d::Zero())};
  foot.phases[0].R_WF << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  foot.phases[0].box_upper_m << 0.07, 0.0, 0.0;
  ocp.contacts = {foot};
  CentroidalNlp nlp;
  nlp.SetProblem(ocp);
  MpcSolution point = ZeroPoint(ocp);
  point.contacts[0].phase_p_WF[0] << 1.0, 1.1, 0.0;
  const Eigen::VectorXd x = Pack(nlp, point);
  ExpectNear(x.tail(3), Eigen::Vector3d(0.1, 0.0, 0.0));
  Eigen::VectorXd lower(nlp.num_variables()), upper(nlp.num_variables());
  nlp.VariableBounds(lower, upper);
  EXPECT_EQ(upper(upper.size() - 3), 0.07);
  EXPECT_NEAR(nlp.ConstraintViolation(x), 0.03, kTolerance);
}

TEST_F(NlpSignsTest, FrictionIsViolatedInNewtonsInTheContactFrame) {
  // One face: x_F + y_F <= 0.5 z_F. Force (3, 0, 4) N is 1 N outside if the frames agree; after 90
  // degrees of pitch (x_F = -z, z_F = x) it is (-4, 0, 3) N, inside.
  CentroidalOcp ocp = Unweighted(1);
  ocp.friction_A = Eigen::RowVector3d(1.0, 1.0, -0.5);
  ocp.friction_b = Eigen::VectorXd::Zero(1);
  ocp.contacts = {Standing(Foot("foot", 1), 1, Eigen::Vector3d::Zero())};
  MpcSolution point = ZeroPoint(ocp);
  point.contacts[0].force_N[0] = Eigen::Vector3d(3.0, 0.0, 4.0);
  // Everything else must not violate: state 1 follows the dynamics.
  point.linear_momentum.col(1) << 0.3, 0.0, 0.4;
  CentroidalNlp nlp;
  nlp.SetProblem(ocp);
  EXPECT_NEAR(nlp.ConstraintViolation(Pack(nlp, point)), 1.0, kTolerance);
  ocp.contacts[0].phases[0].R_WF << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  nlp.SetProblem(ocp);
  EXPECT_NEAR(nlp.ConstraintViolation(Pack(nlp, point)), 0.0, kTolerance);
}

}  // namespace
}  // namespace sidestep::mpc::nlp_signs_test
