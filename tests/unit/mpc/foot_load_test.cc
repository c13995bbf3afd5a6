// SPDX-License-Identifier: BSD-3-Clause
// The cost of what a foot bears above its limit, as both back ends solve it.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "controller/mpc/make_solver.h"
#include "tests/support/honest_solution.h"
#include "tests/support/recorded_problems.h"
#include "tests/unit/mpc/random_ocp.h"

namespace sidestep::mpc::foot_load_test {
namespace {

/// Vertical, N, on foot `i` at knot `k`.
double Load_N(const MpcSolution& solution, std::size_t i, std::size_t k) {
  return solution.contacts[i].force_N[k].row(2).sum();
}

/// Nothing costs but changes of the forces, from 20 N on a sole and 8 N on a point before the only
/// knot; a foot may bear 12 N.
CentroidalOcp OneKnot(double weight) {
  CentroidalOcp ocp = FloatingProblem(1);
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  ocp.weights = {zero, zero, zero, zero, Eigen::Vector3d::Constant(0.2), zero};
  ocp.weights.foot_load = weight;
  ocp.foot_load_limit_N = 12.0;
  ocp.contacts = {Foot("sole", 4), Foot("point", 1)};
  for (OcpContact& contact : ocp.contacts) {
    contact.phases = {FixedPhase(0, 2, zero)};
    contact.has_previous_force = true;
    contact.previous_force_N = Eigen::Matrix3Xd::Zero(3, contact.vertices_m.cols());
  }
  ocp.contacts[0].previous_force_N.row(2).setConstant(5.0);
  ocp.contacts[1].previous_force_N(2, 0) = 8.0;
  return ocp;
}

/// A robot that falls at 1.5 m/s and gets its foot on the ground a knot later; it may bear twice
/// its weight.
CentroidalOcp HardLanding() {
  CentroidalOcp ocp = FloatingProblem(5);
  ocp.initial_p_WC << 0.0, 0.0, 0.65;
  ocp.initial_linear_momentum.z() = -1.5 * ocp.mass_kg;
  ocp.reference_p_WC.row(2).setConstant(0.5);
  ocp.weights.com.z() = 4000.0;
  ocp.contacts = {Foot("foot", 4)};
  ocp.contacts[0].phases = {FixedPhase(1, 6, Eigen::Vector3d::Zero())};
  ocp.foot_load_limit_N = 2.0 * ocp.mass_kg * kStandardGravity_mps2;
  return ocp;
}

/// Of the first foot.
double LargestLoad_N(const MpcSolution& solution) {
  double largest_N = 0.0;
  for (std::size_t k = 0; k < solution.contacts[0].force_N.size(); ++k) {
    largest_N = std::max(largest_N, Load_N(solution, 0, k));
  }
  return largest_N;
}

class FootLoadOfTest : public testing::TestWithParam<MpcBackend> {
 protected:
  static MpcSolution ColdSolve(const CentroidalOcp& ocp) {
    return MakeSolver(GetParam(), {})->Solve(ocp, nullptr);
  }
};

TEST_P(FootLoadOfTest, TheLoadIsWhereItsPriceEqualsThatOfTheChange) {
  // U, the sum of n vertices, ends between S before and the limit L: with r = 0.2 / T^2 = 20 the
  // least of r/2n (U - S)^2 + w/2 (U - L)^2 is at (r/n S + w L) / (r/n + w), here r/n = 5: at
  // w = 5 half-way, at w = 495 a hundredth of the way from L.
  for (const auto& [weight, expected_N] : {std::pair(0.0, 20.0), {5.0, 16.0}, {495.0, 12.08}}) {
    const MpcSolution solution = ColdSolve(OneKnot(weight));
    ASSERT_EQ(solution.status, SolveStatus::kSolved);
    EXPECT_NEAR(Load_N(solution, 0, 0), expected_N, 1e-5) << weight;
    EXPECT_NEAR(Load_N(solution, 1, 0), 8.0, 1e-5) << "each foot has a limit of its own";
    const Eigen::RowVectorXd shares = solution.contacts[0].force_N[0].row(2) / expected_N;
    EXPECT_LT((shares.array() - 0.25).abs().maxCoeff(), 1e-6) << shares;
  }
}

TEST_P(FootLoadOfTest, AHardLandingIsSpreadOverTheKnotsAtTheLimit) {
  CentroidalOcp ocp = HardLanding();
  const double free_N = LargestLoad_N(ColdSolve(ocp));
  EXPECT_GT(free_N, 1.5 * ocp.foot_load_limit_N);
  ocp.weights.foot_load = 1e3;
  const MpcSolution solution = ColdSolve(ocp);
  ASSERT_EQ(solution.status, SolveStatus::kSolved);
  ExpectHonest(ocp, solution);
  EXPECT_NEAR(LargestLoad_N(solution), ocp.foot_load_limit_N, 0.02 * ocp.foot_load_limit_N);
}

TEST_P(FootLoadOfTest, ALimitOutOfReachOrWithoutWeightChangesNothing) {
  CentroidalOcp ocp = ReferenceProblem("icub_forward_40N_double_support");
  const MpcSolution expected = ColdSolve(ocp);
  ocp.foot_load_limit_N = 1.0;
  const MpcSolution without = ColdSolve(ocp);
  EXPECT_EQ(without.cost, expected.cost);
  EXPECT_EQ(without.contacts[0].force_N, expected.contacts[0].force_N);
  ocp.foot_load_limit_N = 1e6;
  ocp.weights.foot_load = 1e3;
  const MpcSolution out_of_reach = ColdSolve(ocp);
  EXPECT_NEAR(out_of_reach.cost, expected.cost, 1e-9 * expected.cost);
  EXPECT_LT((out_of_reach.p_WC - expected.p_WC).cwiseAbs().maxCoeff(), 1e-9);
  ocp.foot_load_limit_N = 1.0;
  EXPECT_GT(ColdSolve(ocp).cost, 1.01 * expected.cost) << "one within reach does";
}

INSTANTIATE_TEST_SUITE_P(BackEnds, FootLoadOfTest, testing::ValuesIn(EnumValues<MpcBackend>()),
                         [](const auto& at) { return std::string(EnumName(at.param)); });

/// Whether some foot bears more than its limit somewhere.
bool IsOverloaded(const CentroidalOcp& ocp, const MpcSolution& solution) {
  for (const ContactSolution& contact : solution.contacts) {
    for (const Eigen::Matrix3Xd& force_N : contact.force_N) {
      if (force_N.cols() > 0 && force_N.row(2).sum() > ocp.foot_load_limit_N) return true;
    }
  }
  return false;
}

/// How many of the problems that the back ends were to agree on ...
struct Agreement {
  int num_overloaded{0};  // ... had the term count at their optimum,
  int num_higher{0};      // and were solved better by Ipopt.
};

void ExpectAgreement(const CentroidalOcp& ocp, Agreement* agreement) {
  const MpcSolution ours = MakeSolver(MpcBackend::kStructured, {})->Solve(ocp, nullptr);
  const MpcSolution theirs = MakeSolver(MpcBackend::kIpopt, {})->Solve(ocp, nullptr);
  ASSERT_EQ(IsUsable(ours.status), IsUsable(theirs.status)) << EnumName(ours.status);
  if (!IsUsable(ours.status)) return;
  ExpectHonest(ocp, ours);
  agreement->num_overloaded += IsOverloaded(ocp, ours) ? 1 : 0;
  agreement->num_higher += ours.cost > theirs.cost * (1.0 + 1e-6) ? 1 : 0;
}

TEST(FootLoadTest, BackEndsAgreeOnRandomProblems) {
  Numbers numbers(13);
  Agreement agreement;
  for (unsigned seed = 3000; seed < 3016; ++seed) {
    SCOPED_TRACE(seed);
    CentroidalOcp ocp = RandomOcp(seed);
    random_ocp::DrawLoads(numbers, &ocp);
    ExpectAgreement(ocp, &agreement);
  }
  EXPECT_GE(agreement.num_overloaded, 6);
  // Pushed robots have several local minima, and either solver may fall into the higher one.
  EXPECT_LE(agreement.num_higher, 1);
}

TEST(FootLoadTest, BackEndsAgreeOnRecordedProblems) {
  Agreement agreement;
  for (const std::string& folder : RecordedFolders()) {
    SCOPED_TRACE(folder);
    CentroidalOcp ocp = ReadProblem(ProblemFiles(RecordedFolder() / folder).at(0));
    ocp.weights.foot_load = 10.0;
    ocp.foot_load_limit_N = 0.9 * ocp.mass_kg * ocp.gravity_mps2.norm();
    ExpectAgreement(ocp, &agreement);
  }
  EXPECT_GE(agreement.num_overloaded, 6);
  EXPECT_LE(agreement.num_higher, 1);
}

}  // namespace
}  // namespace sidestep::mpc::foot_load_test
