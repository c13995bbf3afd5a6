// SPDX-License-Identifier: BSD-3-Clause
// A cost that is only weighed against others: near what a solve finds, infinite above its ceiling.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "controller/mpc/make_solver.h"
#include "controller/mpc/shifted_guess.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::weigh_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAbout = 3e-3;  // What the rough cost may differ by: it is promised to 1e-3.

class WeighTest : public testing::TestWithParam<MpcBackend> {
 protected:
  std::unique_ptr<CentroidalSolver> solver_{MakeSolver(GetParam(), {})};
};

// Reference problems of three robots, pushed hard enough that their costs are of landings that
// move.
const char* const kProblems[] = {
    "icub_nominal_single_support_early", "icub_lateral_40N_single_support_early",
    "icub_forward_40N_double_support",   "hopper_stance_first",
    "biped_walk_double_support",         "biped_walk_to_run"};

TEST_P(WeighTest, FindsTheCostOfASolve) {
  for (const char* name : kProblems) {
    const CentroidalOcp ocp = ReferenceProblem(name);
    const double cost = solver_->Solve(ocp, nullptr).cost;
    EXPECT_NEAR(solver_->Weigh(ocp, nullptr, kInfinity), cost, kAbout * cost) << name;
    EXPECT_NEAR(solver_->Weigh(ocp, nullptr, 1.1 * cost), cost, kAbout * cost) << name;
    EXPECT_EQ(solver_->Weigh(ocp, nullptr, 0.9 * cost), kInfinity) << name;
  }
}

// The way it is used: from the plan before a push, a velocity that the plan knows nothing of.
TEST_P(WeighTest, FindsTheCostOfAPushFromThePlanBeforeIt) {
  for (const char* name : kProblems) {
    const CentroidalOcp ocp = ReferenceProblem(name);
    const MpcSolution solution = solver_->Solve(ocp, nullptr);
    CentroidalOcp pushed = AdvanceProblem(ocp, solution);
    MpcSolution guess;
    ShiftedGuess(ocp, solution, 1, pushed, &guess);
    pushed.initial_linear_momentum.x() += 0.3 * pushed.mass_kg;
    const double cost = solver_->Solve(pushed, &guess).cost;
    EXPECT_NEAR(solver_->Weigh(pushed, &guess, kInfinity), cost, kAbout * cost) << name;
    EXPECT_NEAR(solver_->Weigh(pushed, &guess, 1.1 * cost), cost, kAbout * cost) << name;
    EXPECT_EQ(solver_->Weigh(pushed, &guess, 0.5 * cost), kInfinity) << name;
  }
}

TEST_P(WeighTest, LeavesNoTraceInLaterSolves) {
  const CentroidalOcp ocp = ReferenceProblem(kProblems[0]);
  const MpcSolution before = solver_->Solve(ocp, nullptr);
  solver_->Weigh(ReferenceProblem(kProblems[2]), nullptr, 0.5 * before.cost);
  const MpcSolution& after = solver_->Solve(ocp, nullptr);
  EXPECT_EQ(after.p_WC, before.p_WC);
  EXPECT_EQ(after.cost, before.cost);
  EXPECT_EQ(after.iterations, before.iterations);
}

TEST_P(WeighTest, WhatCannotBeSolvedIsInfinitelyDear) {
  CentroidalOcp broken = ReferenceProblem(kProblems[0]);
  broken.initial_p_WC.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solver_->Weigh(broken, nullptr, kInfinity), kInfinity);
  CentroidalOcp empty = ReferenceProblem("icub_lateral_40N_single_support_early");
  for (OcpContact& contact : empty.contacts) {
    for (ContactPhase& phase : contact.phases) phase.box_lower_m = phase.box_upper_m.array() + 0.1;
  }
  EXPECT_EQ(solver_->Weigh(empty, nullptr, kInfinity), kInfinity);
}

INSTANTIATE_TEST_SUITE_P(BackEnds, WeighTest, testing::ValuesIn(EnumValues<MpcBackend>()),
                         [](const auto& at) { return std::string(EnumName(at.param)); });

}  // namespace
}  // namespace sidestep::mpc::weigh_test
