// SPDX-License-Identifier: BSD-3-Clause
// A solver copied between two problems: both solve on bit for bit.
#include <gtest/gtest.h>

#include "tests/support/random_dense_qp.h"

namespace sidestep::wbc::dense_qp_copy_test {
namespace {

constexpr int kTicks = 12;

DenseQpProblem ProblemAt(QpFamily family, int tick) {
  const DenseQpProblem first = MakeRandomQp(family, 1);
  return tick == 0 ? first : MakeNeighbourQp(first, static_cast<std::uint64_t>(tick));
}

void ExpectSame(const DenseQpSolution& a, const DenseQpSolution& b) {
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.equality_multipliers, b.equality_multipliers);
  EXPECT_EQ(a.inequality_multipliers, b.inequality_multipliers);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.passes, b.passes);
}

class DenseQpCopyTest : public testing::TestWithParam<QpFamily> {};

INSTANTIATE_TEST_SUITE_P(Families, DenseQpCopyTest, testing::ValuesIn(kAllQpFamilies),
                         [](const auto& test) { return std::string(ToString(test.param)); });

// Each solve starts from the solver's own last answer, which is memory that a copy must bring
// along.
TEST_P(DenseQpCopyTest, CopyAndOriginalSolveOnAsOneThatWasNeverCopied) {
  for (int copied_at = 1; copied_at < 6; ++copied_at) {
    DenseQpSolver never_copied(RandomQpMaxima());
    auto original = std::make_unique<DenseQpSolver>(RandomQpMaxima());
    DenseQpSolver assigned({1, 0, 0});
    const DenseQpSolution *expected = nullptr, *last = nullptr;
    for (int tick = 0; tick < copied_at; ++tick) {
      const DenseQpProblem problem = ProblemAt(GetParam(), tick);
      expected = &never_copied.Solve(problem, expected);
      last = &original->Solve(problem, last);
    }
    DenseQpSolver copy(*original);
    assigned = *original;
    ASSERT_NE(last, nullptr);
    const DenseQpSolution at_copy = *last;
    original.reset();
    const DenseQpSolution *of_copy = &at_copy, *of_assigned = &at_copy;
    for (int tick = copied_at; tick < kTicks; ++tick) {
      const DenseQpProblem problem = ProblemAt(GetParam(), tick);
      expected = &never_copied.Solve(problem, expected);
      of_copy = &copy.Solve(problem, of_copy);
      of_assigned = &assigned.Solve(problem, of_assigned);
      ExpectSame(*of_copy, *expected);
      ExpectSame(*of_assigned, *expected);
    }
  }
}

}  // namespace
}  // namespace sidestep::wbc::dense_qp_copy_test
