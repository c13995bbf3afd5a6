// SPDX-License-Identifier: BSD-3-Clause
// The back end "structured" against Ipopt on problems of closed-loop runs (tests/data/mpc), each
// started as the loop starts it: the first of a folder cold, the others from the answer before,
// moved on by one knot. Ipopt solves each cold and from the same start, and the lower answer
// counts, so that a structured back end which falls into the worse of two minima fails here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/mpc/make_solver.h"
#include "controller/mpc/shifted_guess.h"
#include "tests/support/honest_solution.h"
#include "tests/support/recorded_problems.h"
#include "tests/support/solution_difference.h"

namespace sidestep::mpc::recorded_problems_test {
namespace {

constexpr double kCostTolerance = 1e-6;     // Relative.
constexpr double kKktTolerance = 1e-6;      // Scaled as Ipopt scales; both solvers aim at 1e-8.
constexpr double kForceTolerance = 1e-4;    // Of body weight; measured: at most 4e-6.
constexpr double kPlaceTolerance_m = 1e-4;  // Measured: at most 2e-6.

const MpcSolution& Better(const MpcSolution& a, const MpcSolution& b) {
  if (IsUsable(a.status) != IsUsable(b.status)) return IsUsable(a.status) ? a : b;
  return b.cost < a.cost ? b : a;
}

void ExpectAgreement(const CentroidalOcp& ocp, const MpcSolution& ours, const MpcSolution& theirs) {
  if (!IsUsable(ours.status) || !IsUsable(theirs.status)) {
    EXPECT_EQ(EnumName(ours.status), EnumName(theirs.status));
    return;
  }
  ExpectHonest(ocp, ours);
  EXPECT_LE(theirs.kkt_error, kKktTolerance);
  const Difference difference = Compare(ocp, theirs, ours);
  EXPECT_LE(difference.cost, kCostTolerance) << ours.cost << " against " << theirs.cost;
  if (difference.is_other_minimum()) return;
  EXPECT_LT(difference.force, kForceTolerance);
  EXPECT_LT(difference.place_m, kPlaceTolerance_m);
}

class RecordedProblemsTest : public testing::TestWithParam<std::string> {
 protected:
  static std::vector<std::filesystem::path> Files() {
    return ProblemFiles(RecordedFolder() / GetParam());
  }
};

TEST_P(RecordedProblemsTest, FollowedWarmTheAnswersAreIpoptsOrLower) {
  const auto structured = MakeSolver(MpcBackend::kStructured, {});
  const auto ipopt = MakeSolver(MpcBackend::kIpopt, {});
  CentroidalOcp before;
  MpcSolution answer;
  for (const std::filesystem::path& path : Files()) {
    SCOPED_TRACE(path.filename().string());
    const CentroidalOcp ocp = ReadProblem(path);
    MpcSolution theirs = ipopt->Solve(ocp, nullptr);
    if (IsUsable(answer.status)) {
      MpcSolution guess;
      ShiftedGuess(before, answer, 1, ocp, &guess);
      theirs = Better(theirs, ipopt->Solve(ocp, &guess));
      answer = structured->Solve(ocp, &guess);
    } else {
      answer = structured->Solve(ocp, nullptr);
    }
    ExpectAgreement(ocp, answer, theirs);
    before = ocp;
  }
}

TEST_P(RecordedProblemsTest, FilesAreOneStepOfTheHorizonApart) {
  // Named by their step of the loop or by their time in ms; a gap would spoil the warm starts.
  const std::vector<std::filesystem::path> files = Files();
  ASSERT_GE(files.size(), 4U);
  const CentroidalOcp first = ReadProblem(files[0]);
  const bool is_time = files[0].stem().string().size() > 3;
  const long step = is_time ? std::lround(1e3 * first.step_s) : 1;
  for (std::size_t i = 1; i < files.size(); ++i) {
    SCOPED_TRACE(files[i].filename().string());
    const long gap = std::stol(files[i].stem().string()) - std::stol(files[i - 1].stem().string());
    EXPECT_EQ(gap, step);
    const CentroidalOcp ocp = ReadProblem(files[i]);
    EXPECT_EQ(ocp.knots, first.knots);
    EXPECT_EQ(ocp.step_s, first.step_s);
  }
}

INSTANTIATE_TEST_SUITE_P(Folders, RecordedProblemsTest, testing::ValuesIn(RecordedFolders()),
                         [](const auto& folder) { return folder.param; });

TEST(RecordedProblemsFolderTest, HoldsTheProblemsThatTheseTestsAreWorth) {
  std::size_t num_files = 0;
  for (const std::string& folder : RecordedFolders()) {
    num_files += ProblemFiles(RecordedFolder() / folder).size();
  }
  EXPECT_GE(RecordedFolders().size(), 23U);
  EXPECT_GE(num_files, 190U);
}

}  // namespace
}  // namespace sidestep::mpc::recorded_problems_test
