// SPDX-License-Identifier: BSD-3-Clause
// Hard, broken and odd problems: each comes back as a status, never as an exception.
#include <gtest/gtest.h>

#include <limits>

#include "controller/mpc/make_solver.h"
#include "models/support/require.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::solver_status_test {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A hopper that lands on knot 2, five knots, with a box around its nominal place.
CentroidalOcp LandingHopper() {
  CentroidalOcp ocp = FloatingProblem(5);
  ocp.initial_p_WC << 0.0, 0.0, 0.55;
  ocp.reference_p_WC.row(2).setConstant(0.5);
  OcpContact foot = Foot("foot", 1);
  foot.phases = {FreePhase(2, 6, {0.02, 0.0, 0.0}, {0.1, 0.1, 0.0})};
  ocp.contacts = {foot};
  return ocp;
}

class SolverStatusTest : public testing::TestWithParam<MpcBackend> {
 protected:
  static MpcSolution ColdSolve(const CentroidalOcp& ocp, const SolverOptions& options = {}) {
    return MakeSolver(GetParam(), options)->Solve(ocp, nullptr);
  }
};

TEST_P(SolverStatusTest, EveryKindOfNonFiniteDataIsANumericalErrorAtOnce) {
  const std::vector<void (*)(CentroidalOcp&, double)> breakers = {
      [](CentroidalOcp& ocp, double bad) { ocp.mass_kg = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.step_s = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.first_step_s = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.gravity_mps2(2) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.initial_p_WC(0) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.initial_linear_momentum(1) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.initial_angular_momentum(2) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.reference_p_WC(0, 5) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.reference_angular_momentum(0, 0) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.external_force_N(1, 4) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.external_torque_Nm(1, 0) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.weights.com(0) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.weights.new_contact_force(0) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.weights.leg_length = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.weights.foot_load = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.foot_load_limit_N = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.contacts[0].leg.offset_m(1) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.contacts[0].leg.length_m = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.friction_A(3, 2) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.friction_b(3) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.contacts[0].vertices_m(0, 0) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.contacts[0].phases[0].R_WF(0, 0) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.contacts[0].phases[0].nominal_p_WF(0) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.contacts[0].phases[0].box_lower_m(0) = bad; },
      [](CentroidalOcp& ocp, double bad) { ocp.contacts[0].phases[0].box_upper_m(0) = bad; },
      [](CentroidalOcp& ocp, double bad) {
        ocp.contacts[0].has_previous_force = true;
        ocp.contacts[0].previous_force_N = Eigen::Vector3d(0.0, bad, 0.0);
      },
  };
  for (std::size_t b = 0; b < breakers.size(); ++b) {
    for (const double bad : {kNan, kInfinity}) {
      CentroidalOcp ocp = LandingHopper();
      breakers[b](ocp, bad);
      const MpcSolution solution = ColdSolve(ocp);
      EXPECT_EQ(solution.status, SolveStatus::kNumericalError) << b << ", " << bad;
      EXPECT_EQ(solution.iterations, 0);
      EXPECT_EQ(solution.p_WC.cols(), 6);
    }
  }
  EXPECT_EQ(ColdSolve(LandingHopper()).status, SolveStatus::kSolved) << "broken before the break";
}

TEST_P(SolverStatusTest, InvertedBoxIsInfeasibleOnlyIfThePhaseTouchesTheHorizon) {
  CentroidalOcp ocp = LandingHopper();
  ocp.contacts[0].phases[0].box_lower_m.x() = 0.2;
  EXPECT_EQ(ColdSolve(ocp).status, SolveStatus::kInfeasible);
  ocp = LandingHopper();
  ContactPhase beyond = FreePhase(9, 12, Eigen::Vector3d::Zero(), {-0.1, -0.1, -0.1});
  ocp.contacts[0].phases.push_back(beyond);
  EXPECT_EQ(ColdSolve(ocp).status, SolveStatus::kSolved);
}

TEST_P(SolverStatusTest, BoxOfZeroSizeHoldsTheFootAndAThinOneNearlySo) {
  for (const double half_m : {0.0, 1e-12, 1e-9}) {
    CentroidalOcp ocp = LandingHopper();
    ocp.contacts[0].phases[0].box_lower_m.setConstant(0.05 - half_m);
    ocp.contacts[0].phases[0].box_upper_m.setConstant(0.05 + half_m);
    const MpcSolution solution = ColdSolve(ocp);
    EXPECT_EQ(solution.status, SolveStatus::kSolved) << half_m;
    const Eigen::Vector3d expected(0.07, 0.05, 0.05);
    EXPECT_LT((solution.contacts[0].phase_p_WF[0] - expected).cwiseAbs().maxCoeff(), 2e-9);
  }
}

TEST_P(SolverStatusTest, LowerCornerOfTheBoxIsWhereAFootPulledBeyondItEnds) {
  // Nothing but the position cost acts on a foot at the horizon's end; the box excludes its
  // nominal place by 0.05 m along its own x, which is world y.
  CentroidalOcp ocp = FloatingProblem(3);
  OcpContact foot = Foot("foot", 4);
  foot.phases = {FreePhase(3, 4, {1.0, 1.0, 0.0}, {0.1, 0.1, 0.0})};
  foot.phases[0].R_WF << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  foot.phases[0].box_lower_m.x() = 0.05;
  ocp.contacts = {foot};
  const MpcSolution solution = ColdSolve(ocp);
  ASSERT_EQ(solution.status, SolveStatus::kSolved);
  EXPECT_LT((solution.contacts[0].phase_p_WF[0] - Eigen::Vector3d(1.0, 1.05, 0.0)).norm(), 1e-6);
}

TEST_P(SolverStatusTest, FlightOverTheWholeHorizonIsSolvedBallistically) {
  CentroidalOcp ocp = FloatingProblem(4);
  ocp.initial_linear_momentum << 2.0, 0.0, 0.0;  // 1 m/s.
  ocp.external_force_N.row(1).setConstant(4.0);  // 2 m/s^2.
  for (const bool has_foot : {false, true}) {
    if (has_foot) {
      OcpContact foot = Foot("foot", 4);
      foot.phases = {FreePhase(7, 9, Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones())};
      ocp.contacts = {foot};
    }
    const MpcSolution solution = ColdSolve(ocp);
    ASSERT_EQ(solution.status, SolveStatus::kSolved);
    // Explicit Euler: p[4] = p[0] + T sum v[k] with v[k] = v[0] + k T a, sum k = 6.
    const Eigen::Vector3d expected(0.4, 0.01 * 6 * 2.0, -0.01 * 6 * kStandardGravity_mps2);
    EXPECT_LT((solution.p_WC.col(4) - expected).norm(), 1e-9);
    EXPECT_LT(solution.constraint_violation, 1e-9);
  }
}

TEST_P(SolverStatusTest, IterationLimitKeepsTheIterateAndSaysSo) {
  SolverOptions options;
  options.max_iterations = 2;
  const MpcSolution solution = ColdSolve(ReferenceProblem("icub_forward_40N_just_landed"), options);
  EXPECT_EQ(solution.status, SolveStatus::kIterationLimit);
  EXPECT_EQ(solution.iterations, 2);
  EXPECT_TRUE(solution.p_WC.allFinite());
  EXPECT_GT(solution.constraint_violation + solution.kkt_error, 1e-8);
}

TEST_P(SolverStatusTest, ANonFiniteGuessIsIgnored) {
  const CentroidalOcp ocp = LandingHopper();
  const auto solver = MakeSolver(GetParam(), {});
  MpcSolution guess = solver->Solve(ocp, nullptr);
  const double cost = guess.cost;
  guess.contacts[0].force_N[3](0, 0) = kNan;
  const MpcSolution& solution = solver->Solve(ocp, &guess);
  EXPECT_EQ(solution.status, SolveStatus::kSolved);
  EXPECT_NEAR(solution.cost, cost, 1e-9 * cost);
}

TEST_P(SolverStatusTest, AGuessMayBeTheSolversOwnLastAnswer) {
  const CentroidalOcp ocp = LandingHopper();
  const auto solver = MakeSolver(GetParam(), {});
  const MpcSolution& first = solver->Solve(ocp, nullptr);
  const double cost = first.cost;
  const MpcSolution& second = solver->Solve(ocp, &first);
  EXPECT_EQ(second.status, SolveStatus::kSolved);
  EXPECT_NEAR(second.cost, cost, 1e-6 * cost);
}

TEST_P(SolverStatusTest, BrokenContractsThrow) {
  const CentroidalOcp ocp = LandingHopper();
  const auto solver = MakeSolver(GetParam(), {});
  const MpcSolution of_other_shapes = ColdSolve(FloatingProblem(3));
  EXPECT_THROW(solver->Solve(ocp, &of_other_shapes), ContractViolation);
  CentroidalOcp broken = ocp;
  broken.external_force_N.resize(3, 2);
  EXPECT_THROW(solver->Solve(broken, nullptr), ContractViolation);
  EXPECT_THROW(MakeSolver(static_cast<MpcBackend>(7), {}), ContractViolation);
}

INSTANTIATE_TEST_SUITE_P(BackEnds, SolverStatusTest, testing::ValuesIn(EnumValues<MpcBackend>()),
                         [](const auto& at) { return std::string(EnumName(at.param)); });

TEST(SolveStatusTest, StatusesHaveTheirOwnNames) {
  EXPECT_EQ(EnumName(SolveStatus::kNotSolved), "not_solved");
  EXPECT_EQ(EnumName(SolveStatus::kSolved), "solved");
  EXPECT_EQ(EnumName(SolveStatus::kAcceptable), "acceptable");
  EXPECT_EQ(EnumName(SolveStatus::kInfeasible), "infeasible");
  EXPECT_EQ(EnumName(SolveStatus::kIterationLimit), "iteration_limit");
  EXPECT_EQ(EnumName(SolveStatus::kNumericalError), "numerical_error");
}

}  // namespace
}  // namespace sidestep::mpc::solver_status_test
