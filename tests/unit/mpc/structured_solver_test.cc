// SPDX-License-Identifier: BSD-3-Clause
// The back end "structured" against Ipopt and against the problem itself, on random problems.
#include <gtest/gtest.h>

#include <algorithm>

#include "controller/mpc/make_solver.h"
#include "controller/mpc/problem/solution_shape.h"
#include "controller/mpc/shifted_guess.h"
#include "tests/support/honest_solution.h"
#include "tests/unit/mpc/random_ocp.h"

namespace sidestep::mpc::structured_solver_test {
namespace {

#ifdef __SANITIZE_ADDRESS__  // The unoptimised build is fifty times slower.
constexpr unsigned kNumRandom = 60;
constexpr unsigned kNumAgainstIpopt = 8;
#else
constexpr unsigned kNumRandom = 300;
constexpr unsigned kNumAgainstIpopt = 40;
#endif

TEST(StructuredSolverTest, RandomProblemsAreSolvedOrCalledInfeasibleAndNothingElse) {
  const auto solver = MakeSolver(MpcBackend::kStructured, {});
  int num_infeasible = 0;
  for (unsigned seed = 0; seed < kNumRandom; ++seed) {
    SCOPED_TRACE(seed);
    const CentroidalOcp ocp = RandomOcp(seed);
    const MpcSolution& solution = solver->Solve(ocp, nullptr);
    ASSERT_TRUE(IsFinite(solution));
    if (solution.status == SolveStatus::kInfeasible) {
      ++num_infeasible;
      // The generator makes infeasible problems in these two ways only.
      EXPECT_TRUE(KindOf(seed).has_empty_box || KindOf(seed).has_force_limits);
      continue;
    }
    ASSERT_EQ(solution.status, SolveStatus::kSolved);
    ExpectHonest(ocp, solution);
  }
  EXPECT_GT(num_infeasible, 0);
  EXPECT_LT(num_infeasible, static_cast<int>(kNumRandom) / 10);
}

TEST(StructuredSolverTest, StatusesAgreeWithIpoptAndCostsAreMostlyNoHigher) {
  const auto structured = MakeSolver(MpcBackend::kStructured, {});
  const auto ipopt = MakeSolver(MpcBackend::kIpopt, {});
  int num_higher = 0;
  for (unsigned seed = 1000; seed < 1000 + kNumAgainstIpopt; ++seed) {
    SCOPED_TRACE(seed);
    const CentroidalOcp ocp = RandomOcp(seed);
    const MpcSolution& ours = structured->Solve(ocp, nullptr);
    const MpcSolution& theirs = ipopt->Solve(ocp, nullptr);
    EXPECT_EQ(IsUsable(ours.status), IsUsable(theirs.status)) << EnumName(theirs.status);
    if (IsUsable(ours.status) && ours.cost > theirs.cost * (1.0 + 1e-6)) ++num_higher;
  }
  // Pushed robots have several local minima, and either solver may fall into the higher one.
  EXPECT_LE(num_higher, 1);
}

TEST(StructuredSolverTest, AWildGuessLeadsBackToAnOptimum) {
  const auto solver = MakeSolver(MpcBackend::kStructured, {});
  Numbers numbers(7);
  for (const double size : {1.0, 1e3}) {
    const CentroidalOcp ocp = ReferenceProblem("icub_forward_40N_just_landed");
    const MpcSolution expected = solver->Solve(ocp, nullptr);
    MpcSolution guess = expected;
    for (ContactSolution& contact : guess.contacts) {
      for (Eigen::Matrix3Xd& force_N : contact.force_N) {
        Eigen::Matrix3Xd noise(3, force_N.cols());
        numbers.Fill(noise);
        force_N += 100.0 * size * noise;
      }
    }
    guess.p_WC.array() += 0.1 * size;
    const MpcSolution& solution = solver->Solve(ocp, &guess);
    EXPECT_EQ(solution.status, SolveStatus::kSolved) << size;
    EXPECT_NEAR(solution.cost, expected.cost, 1e-6 * expected.cost) << size;
  }
}

TEST(StructuredSolverTest, ManyFeetWithOtherNumbersOfVerticesAgreeWithIpopt) {
  // Nothing is built for two feet of four vertices: three feet with 1, 3 and 4, of which two land.
  CentroidalOcp ocp = FloatingProblem(9);
  ocp.mass_kg = 20.0;
  ocp.initial_p_WC << 0.0, 0.0, 0.5;
  ocp.initial_linear_momentum << 4.0, -2.0, 0.0;
  ocp.reference_p_WC.row(2).setConstant(0.5);
  OcpContact point = Foot("point", 1), triangle = Foot("triangle", 1), sole = Foot("sole", 4);
  triangle.vertices_m = Eigen::Matrix3Xd::Zero(3, 3);
  triangle.vertices_m.row(0) << 0.1, -0.05, -0.05;
  triangle.vertices_m.row(1) << 0.0, 0.08, -0.08;
  point.phases = {FixedPhase(0, 5, {0.2, 0.0, 0.0}),
                  FreePhase(8, 12, {0.3, 0.0, 0.0}, {0.1, 0.1, 0.0})};
  triangle.phases = {FreePhase(0, 4, {-0.1, 0.1, 0.0}, {0.05, 0.05, 0.01}),
                     FreePhase(6, 12, {0.1, 0.1, 0.0}, {0.05, 0.05, 0.0})};
  sole.phases = {FreePhase(3, 7, {0.0, -0.1, 0.0}, {0.1, 0.0, 0.0}),
                 FreePhase(9, 12, {0.2, -0.1, 0.0}, {0.1, 0.1, 0.1})};
  ocp.contacts = {point, triangle, sole};
  const MpcSolution ours = MakeSolver(MpcBackend::kStructured, {})->Solve(ocp, nullptr);
  const MpcSolution theirs = MakeSolver(MpcBackend::kIpopt, {})->Solve(ocp, nullptr);
  ASSERT_EQ(ours.status, SolveStatus::kSolved);
  ASSERT_EQ(theirs.status, SolveStatus::kSolved);
  EXPECT_NEAR(ours.cost, theirs.cost, 1e-7 * theirs.cost);
  EXPECT_LT((ours.p_WC - theirs.p_WC).cwiseAbs().maxCoeff(), 1e-5);
  for (std::size_t i = 0; i < ocp.contacts.size(); ++i) {
    for (std::size_t q = 0; q < ocp.contacts[i].phases.size(); ++q) {
      const Eigen::Vector3d error =
          ours.contacts[i].phase_p_WF[q] - theirs.contacts[i].phase_p_WF[q];
      EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-4) << i << ", " << q;
    }
  }
}

TEST(StructuredSolverTest, IterationsGrowLittleWithTheHorizon) {
  // The work an iteration is linear in N by construction; so must be the work a solve.
  const auto solver = MakeSolver(MpcBackend::kStructured, {});
  const MpcSolution& small = solver->Solve(ReferenceProblem("icub_nominal_just_landed"), nullptr);
  const int small_iterations = small.iterations;
  const MpcSolution& large = solver->Solve(ReferenceProblem("icub_N30_friction_1"), nullptr);
  EXPECT_LE(large.iterations, small_iterations + 5);
}

}  // namespace
}  // namespace sidestep::mpc::structured_solver_test
