// SPDX-License-Identifier: BSD-3-Clause
// A clone of a back end answers as the original goes on to do, bit for bit: nothing that outlives
// a solve counts. On problems of closed-loop runs, warm as in the loop.
#include <gtest/gtest.h>

#include <tuple>

#include "controller/mpc/make_solver.h"
#include "controller/mpc/shifted_guess.h"
#include "tests/support/recorded_problems.h"

namespace sidestep::mpc::solver_clone_test {
namespace {

bool IsSame(const MpcSolution& a, const MpcSolution& b) {
  bool is_same = a.status == b.status && a.cost == b.cost && a.iterations == b.iterations &&
                 a.kkt_error == b.kkt_error && a.constraint_violation == b.constraint_violation &&
                 a.p_WC == b.p_WC && a.linear_momentum == b.linear_momentum &&
                 a.angular_momentum == b.angular_momentum && a.contacts.size() == b.contacts.size();
  for (std::size_t i = 0; is_same && i < a.contacts.size(); ++i) {
    is_same = a.contacts[i].phase_p_WF == b.contacts[i].phase_p_WF &&
              a.contacts[i].force_N == b.contacts[i].force_N;
  }
  return is_same;
}

class SolverCloneTest : public testing::TestWithParam<std::tuple<MpcBackend, std::string>> {
 protected:
  SolverCloneTest() {
    const auto paths = ProblemFiles(RecordedFolder() / std::get<1>(GetParam()));
    for (std::size_t i = 0; i < 3; ++i) problems_.push_back(ReadProblem(paths.at(i)));
  }

  std::vector<CentroidalOcp> problems_;
};

TEST_P(SolverCloneTest, AfterTwoSolvesTheThirdIsTheClonesToo) {
  const auto original = MakeSolver(std::get<0>(GetParam()), {});
  const MpcSolution first = original->Solve(problems_[0], nullptr);
  MpcSolution guess;
  ShiftedGuess(problems_[0], first, 1, problems_[1], &guess);
  const MpcSolution second = original->Solve(problems_[1], &guess);
  const auto clone = original->Clone();
  ShiftedGuess(problems_[1], second, 1, problems_[2], &guess);
  const MpcSolution of_clone = clone->Solve(problems_[2], &guess);
  const MpcSolution of_original = original->Solve(problems_[2], &guess);
  EXPECT_TRUE(IsSame(of_clone, of_original));
  EXPECT_FALSE(IsSame(of_clone, second)) << "the comparison sees no difference at all";
}

INSTANTIATE_TEST_SUITE_P(Folders, SolverCloneTest,
                         testing::Combine(testing::ValuesIn(EnumValues<MpcBackend>()),
                                          testing::ValuesIn(RecordedFolders())),
                         [](const auto& at) {
                           return std::string(EnumName(std::get<0>(at.param))) + "_" +
                                  std::get<1>(at.param);
                         });

class OptionsOfACloneTest : public testing::TestWithParam<MpcBackend> {};

TEST_P(OptionsOfACloneTest, AreTheOriginals) {
  const CentroidalOcp ocp =
      ReadProblem(ProblemFiles(RecordedFolder() / RecordedFolders().at(0)).at(0));
  SolverOptions options;
  options.max_iterations = 2;
  const auto clone = MakeSolver(GetParam(), options)->Clone();
  EXPECT_EQ(clone->Solve(ocp, nullptr).status, SolveStatus::kIterationLimit);
}

INSTANTIATE_TEST_SUITE_P(BackEnds, OptionsOfACloneTest, testing::ValuesIn(EnumValues<MpcBackend>()),
                         [](const auto& at) { return std::string(EnumName(at.param)); });

}  // namespace
}  // namespace sidestep::mpc::solver_clone_test
