// SPDX-License-Identifier: BSD-3-Clause
// No allocation when the next problem has another schedule but the same horizon and feet.
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "controller/mpc/ipopt/centroidal_nlp.h"
#include "controller/mpc/problem/solution_shape.h"
#include "controller/mpc/shifted_guess.h"
#include "tests/support/allocation_counter.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::nlp_storage_test {
namespace {

constexpr int kKnots = 6;

/// Two feet whose schedule depends on `time`: stances of 4 knots, swings of 2.
CentroidalOcp Walking(int time) {
  CentroidalOcp ocp = FloatingProblem(kKnots);
  for (int i = 0; i < 2; ++i) {
    OcpContact foot = Foot("foot", 4);
    for (int start = -12 + 3 * i; start < 24; start += 6) {
      const int first = std::max(0, start - time);
      const int end = start + 4 - time;
      if (end > first && first <= kKnots) {
        foot.phases.push_back(
            start < time ? FixedPhase(first, end, Eigen::Vector3d::Zero())
                         : FreePhase(first, end, Eigen::Vector3d::Zero(), {0.1, 0.1, 0.0}));
      }
    }
    ocp.contacts.push_back(foot);
  }
  return ocp;
}

TEST(NlpStorageTest, TheCounterSeesEigenAndTheStandardContainers) {
  const std::int64_t before = CountAllocations();
  Eigen::VectorXd vector;
  vector.resize(before + 100);  // A size that the compiler can't know.
  EXPECT_EQ(CountAllocations(), before + 1);
  std::vector<int> list;
  list.reserve(static_cast<std::size_t>(before) + 100);
  EXPECT_EQ(CountAllocations(), before + 2);
}

TEST(NlpStorageTest, ANewScheduleReusesTheStorageOfTheFirst) {
  std::vector<CentroidalOcp> problems;
  for (int time = 0; time < 6; ++time) {
    problems.push_back(Walking(time));
  }
  CentroidalNlp nlp;
  nlp.SetProblem(problems[0]);
  const std::int64_t before = CountAllocations();
  int sizes_seen = 0;
  int last_size = 0;
  for (const CentroidalOcp& ocp : problems) {
    nlp.SetProblem(ocp);
    sizes_seen += nlp.num_variables() != last_size ? 1 : 0;
    last_size = nlp.num_variables();
  }
  EXPECT_EQ(CountAllocations(), before);
  EXPECT_GT(sizes_seen, 1) << "the schedules are all of one size: nothing was tested";
}

TEST(NlpStorageTest, EvaluatingAllocatesNothing) {
  const CentroidalOcp ocp = Walking(1);
  CentroidalNlp nlp;
  nlp.SetProblem(ocp);
  const Eigen::VectorXd x = Eigen::VectorXd::Ones(nlp.num_variables());
  Eigen::VectorXd gradient(nlp.num_variables()), g(nlp.num_constraints());
  std::vector<double> jacobian(static_cast<std::size_t>(nlp.num_jacobian_entries()));
  std::vector<double> hessian(static_cast<std::size_t>(nlp.num_hessian_entries()));
  const std::int64_t before = CountAllocations();
  const double cost = nlp.Cost(x);
  nlp.Gradient(x, gradient);
  nlp.Constraints(x, g);
  nlp.JacobianValues(x, jacobian.data());
  nlp.HessianValues(x, 1.0, g, hessian.data());
  EXPECT_EQ(CountAllocations(), before);
  EXPECT_GT(cost, 0.0);
}

TEST(NlpStorageTest, ShiftingOntoTheSameShapesAllocatesNothing) {
  const CentroidalOcp previous_ocp = Walking(1);
  const CentroidalOcp next_ocp = Walking(2);
  MpcSolution previous;
  ColdStart(previous_ocp, &previous);
  MpcSolution guess;
  ShiftedGuess(previous_ocp, previous, 1, next_ocp, &guess);
  const std::int64_t before = CountAllocations();
  ShiftedGuess(previous_ocp, previous, 1, next_ocp, &guess);
  EXPECT_EQ(CountAllocations(), before);
}

}  // namespace
}  // namespace sidestep::mpc::nlp_storage_test
