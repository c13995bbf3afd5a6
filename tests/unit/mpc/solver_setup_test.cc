// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/problem/solver_setup.h"

#include <gtest/gtest.h>

#include "controller/mpc/make_solver.h"
#include "models/support/config_error.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::solver_setup_test {
namespace {

using nlohmann::json;

CentroidalOcp Problem() { return ReferenceProblem("icub_lateral_40N_double_support"); }

/// Solved loosely, so that it is a guess worth keeping.
SolverSetup SetupWithGuess(const CentroidalOcp& ocp) {
  SolverSetup setup{MpcBackend::kStructured, {1e-7, 33}, std::nullopt};
  setup.guess = MakeSolver(MpcBackend::kStructured, {1e-2, 50})->Solve(ocp, nullptr);
  return setup;
}

std::string ErrorOf(const json& block) {
  try {
    SolverSetupFromJson(Problem(), block);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(SolverSetupTest, ASolveFromItsTextIsTheSameBitForBit) {
  const CentroidalOcp ocp = Problem();
  const SolverSetup setup = SetupWithGuess(ocp);
  const SolverSetup back =
      SolverSetupFromJson(ocp, json::parse(SolverSetupToJson(ocp, setup).dump()));
  EXPECT_EQ(back.backend, setup.backend);
  EXPECT_EQ(back.options.tolerance, 1e-7);
  EXPECT_EQ(back.options.max_iterations, 33);
  const auto answer = [&](const SolverSetup& how) {
    return MpcSolution(MakeSolver(how.backend, how.options)->Solve(ocp, &*how.guess));
  };
  const MpcSolution first = answer(setup), second = answer(back);
  EXPECT_EQ(first.iterations, second.iterations);
  EXPECT_EQ(first.cost, second.cost);
  EXPECT_EQ(first.p_WC, second.p_WC);
}

TEST(SolverSetupTest, AColdStartHasNoGuess) {
  const CentroidalOcp ocp = Problem();
  const json block = SolverSetupToJson(ocp, SolverSetup{});
  EXPECT_FALSE(block.contains("guess"));
  EXPECT_FALSE(SolverSetupFromJson(ocp, block).guess.has_value());
}

TEST(SolverSetupTest, ErrorsNameThePlace) {
  const json good = SolverSetupToJson(Problem(), SetupWithGuess(Problem()));
  EXPECT_EQ(ErrorOf(good), "");
  json bad = good;
  bad["backend"] = "snopt";
  EXPECT_EQ(ErrorOf(bad), "$.solver.backend: expected one of ipopt, structured, got \"snopt\"");
  bad = good;
  bad["guess"]["com_m"].erase(0);
  EXPECT_EQ(ErrorOf(bad).rfind("$.solver.guess.com_m: expected", 0), 0u) << ErrorOf(bad);
  bad = good;
  bad["max_iterations"] = 0;
  EXPECT_EQ(ErrorOf(bad).rfind("$.solver.max_iterations: expected", 0), 0u) << ErrorOf(bad);
  bad = good;
  bad.erase("tolerance");
  EXPECT_NE(ErrorOf(bad), "");
  EXPECT_NE(ErrorOf(json::array()), "");
}

}  // namespace
}  // namespace sidestep::mpc::solver_setup_test
