// SPDX-License-Identifier: BSD-3-Clause
// Agreement with Ipopt on 1000 random problems.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "controller/wbc/qp/dense_qp.h"
#include "tests/support/ipopt_dense_qp.h"
#include "tests/support/random_dense_qp.h"

namespace sidestep::wbc::dense_qp_ipopt_test {
namespace {

// Ipopt stops at this scaled optimality error.
constexpr double kIpoptTolerance = 1e-10;

// Ipopt's duality gap is about (number of bounds) * tolerance * scaling; 1e-7 leaves a margin.
constexpr double kCostTolerance = 1e-7;

// x errs by about sqrt(cost error / smallest curvature), hence far more than the cost.
constexpr double kPointTolerance = 1e-4;

double Cost(const DenseQpProblem& problem, const Eigen::VectorXd& x) {
  return 0.5 * x.dot(problem.H * x) + problem.g.dot(x);
}

class DenseQpIpoptTest : public testing::TestWithParam<QpFamily> {};

TEST_P(DenseQpIpoptTest, CostAndPointAgreeWithIpopt) {
  // The 59-variable family is slow in Ipopt; the others make up for its smaller number.
  // The optimised build runs the full number; sanitizers look for other mistakes.
#ifdef __SANITIZE_ADDRESS__
  const int problems = GetParam() == QpFamily::kTorque ? 6 : 24;
#else
  const int problems = GetParam() == QpFamily::kTorque ? 30 : 120;
#endif
  DenseQpSolver solver(RandomQpMaxima());
  int compared = 0;
  double worst_cost = 0.0;
  double worst_point = 0.0;
  for (int seed = 0; seed < problems; ++seed) {
    const DenseQpProblem problem = MakeRandomQp(GetParam(), static_cast<std::uint64_t>(seed));
    const IpoptQpResult reference = SolveWithIpopt(problem, kIpoptTolerance);
    const DenseQpSolution& solution = solver.Solve(problem);
    ASSERT_EQ(solution.status, QpStatus::kSolved) << "seed " << seed;
    if (!reference.is_solved) {
      continue;  // counted below
    }
    ++compared;
    const double expected = Cost(problem, reference.x);
    const double cost_error =
        std::abs(Cost(problem, solution.x) - expected) / (1.0 + std::abs(expected));
    EXPECT_LE(cost_error, kCostTolerance) << "seed " << seed;
    worst_cost = std::max(worst_cost, cost_error);
    if (IsStrictlyConvex(GetParam())) {
      const double point_error =
          (Eigen::VectorXd(solution.x) - reference.x).norm() / (1.0 + reference.x.norm());
      EXPECT_LE(point_error, kPointTolerance) << "seed " << seed;
      worst_point = std::max(worst_point, point_error);
    }
  }
  RecordProperty("compared", compared);
  RecordProperty("worst_cost_error_e12", static_cast<int>(1e12 * worst_cost));
  RecordProperty("worst_point_error_e12", static_cast<int>(1e12 * worst_point));
  EXPECT_GE(compared, problems * 9 / 10) << "Ipopt gave up too often for a comparison";
}

INSTANTIATE_TEST_SUITE_P(AllFamilies, DenseQpIpoptTest, testing::ValuesIn(kAllQpFamilies),
                         [](const auto& param) { return std::string(ToString(param.param)); });

}  // namespace
}  // namespace sidestep::wbc::dense_qp_ipopt_test
