// SPDX-License-Identifier: BSD-3-Clause
// What any solver of the problem must obey, whatever the numbers: mirrors, masses, warm starts.
#include <gtest/gtest.h>

#include <tuple>

#include "controller/mpc/make_solver.h"
#include "controller/mpc/shifted_guess.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::solver_laws_test {
namespace {

// Solutions of two different runs agree to what a tolerance of 1e-8 leaves of the flattest
// direction (measured: 4e-7 of body weight, 1e-6 m).
constexpr double kPlace_m = 1e-5;
constexpr double kForceShare = 1e-5;
constexpr double kGravity_mps2 = 9.81;

const Eigen::Vector3d kPolar(1, -1, 1);   // Mirror in the x-z plane: vectors flip y,
const Eigen::Vector3d kAxial(-1, 1, -1);  // moments flip x and z.

void Flip(const Eigen::Vector3d& signs, Eigen::Matrix3Xd* columns) {
  *columns = signs.asDiagonal() * *columns;
}

CentroidalOcp Mirrored(CentroidalOcp ocp) {
  const Eigen::Matrix3d mirror = kPolar.asDiagonal();
  ocp.gravity_mps2 = mirror * ocp.gravity_mps2;
  ocp.initial_p_WC = mirror * ocp.initial_p_WC;
  ocp.initial_linear_momentum = mirror * ocp.initial_linear_momentum;
  ocp.initial_angular_momentum = kAxial.cwiseProduct(ocp.initial_angular_momentum);
  Flip(kPolar, &ocp.reference_p_WC);
  Flip(kAxial, &ocp.reference_angular_momentum);
  Flip(kPolar, &ocp.external_force_N);
  Flip(kAxial, &ocp.external_torque_Nm);
  ocp.friction_A = ocp.friction_A * mirror;
  for (OcpContact& contact : ocp.contacts) {
    Flip(kPolar, &contact.vertices_m);
    if (contact.has_previous_force) {
      Flip(kPolar, &contact.previous_force_N);
    }
    for (ContactPhase& phase : contact.phases) {
      phase.R_WF = mirror * phase.R_WF * mirror;
      phase.p_WF = mirror * phase.p_WF;
      phase.nominal_p_WF = mirror * phase.nominal_p_WF;
      const double lower_y_m = phase.box_lower_m.y();
      phase.box_lower_m.y() = -phase.box_upper_m.y();
      phase.box_upper_m.y() = -lower_y_m;
    }
  }
  return ocp;
}

/// The same problem for a robot `factor` times as heavy, pushed as much harder.
CentroidalOcp Scaled(CentroidalOcp ocp, double factor) {
  ocp.mass_kg *= factor;
  ocp.initial_linear_momentum *= factor;
  ocp.initial_angular_momentum *= factor;
  ocp.reference_angular_momentum *= factor;
  ocp.external_force_N *= factor;
  ocp.external_torque_Nm *= factor;
  ocp.friction_b *= factor;
  for (OcpContact& contact : ocp.contacts) {
    contact.previous_force_N *= factor;
  }
  return ocp;
}

/// Expects b to be a with vectors multiplied by `polar` and forces also by `factor`.
void ExpectCorresponds(const CentroidalOcp& ocp, const MpcSolution& a, const MpcSolution& b,
                       const Eigen::Vector3d& polar, double factor) {
  ASSERT_EQ(a.status, SolveStatus::kSolved);
  ASSERT_EQ(b.status, SolveStatus::kSolved);
  EXPECT_NEAR(b.cost, a.cost, 1e-7 * a.cost);
  EXPECT_LT((b.p_WC - polar.asDiagonal() * a.p_WC).cwiseAbs().maxCoeff(), kPlace_m);
  const double weight_N = factor * ocp.mass_kg * kGravity_mps2;
  for (std::size_t i = 0; i < a.contacts.size(); ++i) {
    for (std::size_t q = 0; q < a.contacts[i].phase_p_WF.size(); ++q) {
      const Eigen::Vector3d expected = polar.cwiseProduct(a.contacts[i].phase_p_WF[q]);
      EXPECT_LT((b.contacts[i].phase_p_WF[q] - expected).cwiseAbs().maxCoeff(), kPlace_m);
    }
    for (std::size_t k = 0; k < a.contacts[i].force_N.size(); ++k) {
      const Eigen::Matrix3Xd expected_N = factor * polar.asDiagonal() * a.contacts[i].force_N[k];
      EXPECT_LT((b.contacts[i].force_N[k] - expected_N).cwiseAbs().maxCoeff(),
                kForceShare * weight_N)
          << i << ", " << k;
    }
  }
}

/// A back end and a problem.
class SolverLawsTest : public testing::TestWithParam<std::tuple<MpcBackend, const char*>> {
 protected:
  static std::unique_ptr<CentroidalSolver> Solver() {
    return MakeSolver(std::get<0>(GetParam()), {});
  }
  static CentroidalOcp Problem() { return ReferenceProblem(std::get<1>(GetParam())); }
  static MpcSolution ColdSolve(const CentroidalOcp& ocp) { return Solver()->Solve(ocp, nullptr); }
};

TEST_P(SolverLawsTest, MirroredProblemGivesMirroredSolution) {
  const CentroidalOcp ocp = Problem();
  ExpectCorresponds(ocp, ColdSolve(ocp), ColdSolve(Mirrored(ocp)), kPolar, 1.0);
}

TEST_P(SolverLawsTest, DoublingMassAndForcesChangesNoMotion) {
  const CentroidalOcp ocp = Problem();
  ExpectCorresponds(ocp, ColdSolve(ocp), ColdSolve(Scaled(ocp, 2.0)), Eigen::Vector3d::Ones(), 2.0);
}

TEST_P(SolverLawsTest, AFirstStepAsLongAsTheOthersChangesNothing) {
  CentroidalOcp ocp = Problem();
  const MpcSolution without = ColdSolve(ocp);
  ocp.first_step_s = ocp.step_s;
  const MpcSolution with = ColdSolve(ocp);
  EXPECT_EQ(without.p_WC, with.p_WC);
  EXPECT_EQ(without.cost, with.cost);
}

TEST_P(SolverLawsTest, SolvingTwiceGivesTheSameBits) {
  const CentroidalOcp ocp = Problem();
  const auto solver = Solver();
  const MpcSolution first = solver->Solve(ocp, nullptr);
  solver->Solve(ocp, &first);  // A warm start in between must leave no trace.
  const MpcSolution& again = solver->Solve(ocp, nullptr);
  EXPECT_EQ(first.p_WC, again.p_WC);
  EXPECT_EQ(first.cost, again.cost);
  EXPECT_EQ(first.iterations, again.iterations);
}

INSTANTIATE_TEST_SUITE_P(Problems, SolverLawsTest,
                         testing::Combine(testing::ValuesIn(EnumValues<MpcBackend>()),
                                          testing::Values("icub_yawed_step_up_tilted",
                                                          "icub_fast_velocity_error_previous_force",
                                                          "icub_forward_40N_double_support",
                                                          "biped_walk_single_support_left",
                                                          "biped_walk_to_run",
                                                          "hopper_flight_first_travelling")),
                         [](const auto& at) {
                           return std::string(EnumName(std::get<0>(at.param))) + "_" +
                                  std::get<1>(at.param);
                         });

class WarmStartTest : public testing::TestWithParam<MpcBackend> {};

TEST_P(WarmStartTest, ShiftedSolutionReachesTheSameOptimumInFewerIterations) {
  const auto solver = MakeSolver(GetParam(), {});
  int cold_iterations = 0;
  int warm_iterations = 0;
  for (const char* name :
       {"icub_nominal_single_support_early", "icub_lateral_40N_single_support_early",
        "icub_forward_40N_double_support", "icub_N30_friction_1", "hopper_stance_first",
        "biped_walk_double_support", "biped_walk_to_run"}) {
    SCOPED_TRACE(name);
    const CentroidalOcp ocp = ReferenceProblem(name);
    const MpcSolution solution = solver->Solve(ocp, nullptr);
    const CentroidalOcp next = AdvanceProblem(ocp, solution);
    const MpcSolution cold = solver->Solve(next, nullptr);
    MpcSolution guess;
    ShiftedGuess(ocp, solution, 1, next, &guess);
    const MpcSolution& warm = solver->Solve(next, &guess);
    ASSERT_EQ(cold.status, SolveStatus::kSolved);
    ASSERT_EQ(warm.status, SolveStatus::kSolved);
    EXPECT_NEAR(warm.cost, cold.cost, 1e-6 * cold.cost);
    EXPECT_LT((warm.p_WC - cold.p_WC).cwiseAbs().maxCoeff(), 1e-4);
    EXPECT_LE(warm.iterations, cold.iterations + 3);  // No single start may be spoilt.
    cold_iterations += cold.iterations;
    warm_iterations += warm.iterations;
  }
  EXPECT_LT(warm_iterations, cold_iterations);
}

TEST_P(WarmStartTest, WithinAKnotTheSolutionItselfIsTheStart) {
  // A tick after the solve, in the midst of the knot, and a tick before its end.
  const auto solver = MakeSolver(GetParam(), {});
  int cold_iterations = 0;
  int warm_iterations = 0;
  for (const char* name : {"icub_nominal_single_support_early", "icub_forward_40N_double_support",
                           "hopper_stance_first", "biped_walk_double_support"}) {
    const CentroidalOcp ocp = ReferenceProblem(name);
    const MpcSolution solution = solver->Solve(ocp, nullptr);
    for (const double share : {0.01, 0.5, 0.99}) {
      SCOPED_TRACE(testing::Message() << name << " after " << share);
      const CentroidalOcp next = AdvanceWithinAKnot(ocp, solution, share);
      const MpcSolution cold = solver->Solve(next, nullptr);
      MpcSolution guess;
      ShiftedGuess(ocp, solution, 0, next, &guess);
      const MpcSolution& warm = solver->Solve(next, &guess);
      ASSERT_EQ(cold.status, SolveStatus::kSolved);
      ASSERT_EQ(warm.status, SolveStatus::kSolved);
      EXPECT_NEAR(warm.cost, cold.cost, 1e-6 * cold.cost);
      EXPECT_LE(warm.iterations, cold.iterations);
      cold_iterations += cold.iterations;
      warm_iterations += warm.iterations;
    }
  }
  EXPECT_LT(warm_iterations, cold_iterations);
}

TEST_P(WarmStartTest, PushedHopperFollowedOverASecondNeverEndsInAWorseMinimumThanACold) {
  // The foot that has just landed must not stay unloaded at the friction cone's apex.
  const auto solver = MakeSolver(GetParam(), {});
  CentroidalOcp ocp = ReferenceProblem("hopper_pushed_5N_lateral");
  MpcSolution solution = solver->Solve(ocp, nullptr);
  for (int step = 0; step < 10; ++step) {
    SCOPED_TRACE(step);
    const CentroidalOcp next = AdvanceProblem(ocp, solution);
    MpcSolution guess;
    ShiftedGuess(ocp, solution, 1, next, &guess);
    const MpcSolution cold = solver->Solve(next, nullptr);
    const MpcSolution warm = solver->Solve(next, &guess);
    ASSERT_TRUE(IsUsable(cold.status));
    ASSERT_TRUE(IsUsable(warm.status));
    EXPECT_LE(warm.cost, cold.cost * (1.0 + 1e-6));
    ocp = next;
    solution = warm;
  }
}

INSTANTIATE_TEST_SUITE_P(BackEnds, WarmStartTest, testing::ValuesIn(EnumValues<MpcBackend>()),
                         [](const auto& at) { return std::string(EnumName(at.param)); });

}  // namespace
}  // namespace sidestep::mpc::solver_laws_test
