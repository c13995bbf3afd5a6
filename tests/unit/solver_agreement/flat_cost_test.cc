// SPDX-License-Identifier: BSD-3-Clause
// Problems of closed-loop runs whose cost asks nothing of the CoM and the momentum: forces that
// stay as they are cost nothing, however large, and the barrier alone decides how large they get.
#include <gtest/gtest.h>

#include "controller/mpc/make_solver.h"
#include "tests/support/honest_solution.h"
#include "tests/support/recorded_problems.h"

namespace sidestep::mpc::flat_cost_test {
namespace {

TEST(FlatCostTest, NoProblemWithoutWeightsOnItsStatesEndsAtTheIterationLimit) {
  const auto solver = MakeSolver(MpcBackend::kStructured, {});
  for (const std::string& folder : RecordedFolders()) {
    for (const std::filesystem::path& path : ProblemFiles(RecordedFolder() / folder)) {
      SCOPED_TRACE(folder + "/" + path.filename().string());
      CentroidalOcp ocp = ReadProblem(path);
      ocp.weights.com.setZero();
      ocp.weights.angular_momentum.setZero();
      const MpcSolution& solution = solver->Solve(ocp, nullptr);
      EXPECT_TRUE(IsUsable(solution.status)) << EnumName(solution.status);
      EXPECT_LE(solution.kkt_error, 1e-6);
    }
  }
}

TEST(FlatCostTest, TheCostThatIsReportedIsTheProblemsWhicheverWayItWasFound) {
  // Solved the patient way, whose cost is scaled.
  CentroidalOcp ocp = ReadProblem(RecordedFolder() / "icub_second_push/11100.json");
  ocp.weights.com.setZero();
  ocp.weights.angular_momentum.setZero();
  const MpcSolution ours = MakeSolver(MpcBackend::kStructured, {})->Solve(ocp, nullptr);
  const MpcSolution theirs = MakeSolver(MpcBackend::kIpopt, {})->Solve(ocp, nullptr);
  ASSERT_TRUE(IsUsable(ours.status));
  ASSERT_TRUE(IsUsable(theirs.status));
  ExpectHonest(ocp, ours);
  EXPECT_NEAR(ours.cost, theirs.cost, 1e-6 * theirs.cost);
}

}  // namespace
}  // namespace sidestep::mpc::flat_cost_test
