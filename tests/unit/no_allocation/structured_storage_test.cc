// SPDX-License-Identifier: BSD-3-Clause
// The structured back end takes no memory once it has met its largest problem.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "controller/mpc/centroidal_mpc.h"
#include "controller/mpc/make_solver.h"
#include "controller/mpc/shifted_guess.h"
#include "tests/support/allocation_counter.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::structured_storage_test {
namespace {

TEST(StructuredStorageTest, AHundredConsecutiveSolvesOfChangingSchedulesAllocateNothing) {
  // Prepared beforehand: a walk followed for 25 steps, whose contacts come and go.
  const auto solver = MakeSolver(MpcBackend::kStructured, {});
  std::vector<CentroidalOcp> problems{ReferenceProblem("biped_walk_double_support")};
  std::vector<MpcSolution> solutions;
  for (int step = 0; step < 24; ++step) {
    solutions.push_back(solver->Solve(problems.back(), nullptr));
    ASSERT_TRUE(IsUsable(solutions.back().status)) << step;
    problems.push_back(AdvanceProblem(problems.back(), solutions.back()));
  }
  solutions.push_back(solver->Solve(problems.back(), nullptr));
  std::vector<MpcSolution> guesses(problems.size());
  for (std::size_t i = 1; i < problems.size(); ++i) {
    ShiftedGuess(problems[i - 1], solutions[i - 1], 1, problems[i], &guesses[i]);
  }
  const auto fresh = MakeSolver(MpcBackend::kStructured, {});
  // The answer's own list of phases may grow by one within the first schedules.
  for (const CentroidalOcp& ocp : problems) fresh->Solve(ocp, nullptr);
  const std::int64_t before = CountAllocations();
  int num_usable = 0;
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < problems.size(); ++i) {
      num_usable += IsUsable(fresh->Solve(problems[i], nullptr).status) ? 1 : 0;
      const MpcSolution* guess = i == 0 ? nullptr : &guesses[i];
      num_usable += IsUsable(fresh->Solve(problems[i], guess).status) ? 1 : 0;
    }
  }
  EXPECT_EQ(CountAllocations(), before);
  EXPECT_EQ(num_usable, 100);
}

/// A walk on the spot with stances of 450 ticks and swings of 150, from `tick` on.
ContactPlan WalkAt(Tick tick) {
  constexpr Tick kPeriod = 600, kHorizon = 1200;
  ContactPlan plan;
  plan.feet.resize(2);
  for (int i = 0; i < 2; ++i) {
    for (int n = 0; n < 40; ++n) {
      PlannedContact contact;
      contact.index = n;
      contact.nominal_p_WF.y() = i == 0 ? 0.1 : -0.1;
      contact.adjusted_p_WF = contact.nominal_p_WF;
      contact.start_tick = n == 0 ? 0 : n * kPeriod + i * kPeriod / 2 - kPeriod / 2;
      contact.end_tick = n * kPeriod + i * kPeriod / 2 + kPeriod / 4;
      contact.box_lower_m = {-0.1, -0.1, 0.0};
      contact.box_upper_m = {0.1, 0.1, 0.0};
      if (contact.end_tick > tick && contact.start_tick < tick + kHorizon) {
        plan.feet[static_cast<std::size_t>(i)].push_back(contact);
      }
    }
  }
  return plan;
}

TEST(StructuredStorageTest, TheWholeStageOfTheControlChainAllocatesNothingOnceItHasWalked) {
  constexpr double kTick_s = 0.001;
  constexpr Tick kSolve = 20;  // 50 Hz.
  MpcParams params;
  params.rate_hz = 50.0;
  params.knots = 12;
  params.step_s = 0.1;
  params.friction = 0.6;
  params.latency_s = 0.02;
  params.backend = MpcBackend::kStructured;
  RobotModel robot;
  robot.mass_kg = 30.0;
  robot.foot_names = {"left", "right"};
  robot.vertices_m = {Foot("", 4).vertices_m, Foot("", 4).vertices_m};
  std::vector<ContactPlan> plans;
  for (int solve = 0; solve < 200; ++solve) plans.push_back(WalkAt(solve * kSolve));
  RobotState state;
  state.p_WC = {0.0, 0.01, 0.5};
  GridReferences references;
  references.p_WC.setZero(3, params.knots + 1);
  references.p_WC.row(2).setConstant(0.5);
  references.angular_momentum.setZero(3, params.knots + 1);
  CentroidalMpc mpc(params, robot, kTick_s);
  long before = 0;
  int num_fallbacks = 0;
  for (int solve = 0; solve < 200; ++solve) {
    if (solve == 100) before = CountAllocations();  // By then every schedule has been seen.
    const Tick tick = solve * kSolve;
    state.p_WC.y() = 0.01 * (solve % 3);
    mpc.Solve(state, plans[static_cast<std::size_t>(solve)], references, tick);
    mpc.Activate(tick);
    num_fallbacks += mpc.report().fell_back ? 1 : 0;
  }
  EXPECT_EQ(CountAllocations(), before);
  EXPECT_EQ(num_fallbacks, 0);
}

}  // namespace
}  // namespace sidestep::mpc::structured_storage_test
