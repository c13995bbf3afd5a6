// SPDX-License-Identifier: BSD-3-Clause
// The symmetry cost with unequal shares of a foot's force: signs by hand, and both back ends.
#include <gtest/gtest.h>

#include "controller/mpc/ipopt/centroidal_nlp.h"
#include "controller/mpc/make_solver.h"
#include "controller/mpc/problem/solution_shape.h"
#include "models/support/require.h"
#include "tests/support/honest_solution.h"
#include "tests/support/recorded_problems.h"
#include "tests/unit/mpc/random_ocp.h"

namespace sidestep::mpc::force_shares_test {
namespace {

/// A robot of 2 kg that stands on a sole of 0.2 m x 0.1 m below its CoM.
CentroidalOcp Standing() {
  CentroidalOcp ocp = FloatingProblem(8);
  ocp.initial_p_WC.z() = 0.5;
  ocp.reference_p_WC.row(2).setConstant(0.5);
  ocp.contacts = {Foot("sole", 4)};
  ocp.contacts[0].phases = {FixedPhase(0, 9, Eigen::Vector3d::Zero())};
  return ocp;
}

/// Gives every foot of more than one vertex shares between 0.5 and 1.5 of an equal one.
void DrawShares(Numbers& numbers, CentroidalOcp* ocp) {
  for (OcpContact& contact : ocp->contacts) {
    const Eigen::Index count = contact.vertices_m.cols();
    if (count < 2) continue;
    Eigen::VectorXd shares(count);
    for (Eigen::Index j = 0; j < count; ++j) shares(j) = 1.0 + 0.5 * numbers.Next();
    contact.force_shares = shares / shares.sum();
  }
}

double CopY_m(const CentroidalOcp& ocp, const MpcSolution& solution, std::size_t k) {
  const Eigen::RowVectorXd load_N = solution.contacts[0].force_N[k].row(2);
  return load_N.dot(ocp.contacts[0].vertices_m.row(1)) / load_N.sum();
}

TEST(ForceSharesTest, CostIsZeroAtTheSharesAndByHandBesideThem) {
  CentroidalOcp ocp = FloatingProblem(1);  // 2 kg
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  ocp.weights = {zero, zero, zero, Eigen::Vector3d(1.0, 1.0, 10.0), zero, zero};
  ocp.contacts = {Foot("foot", 2)};
  ocp.contacts[0].phases = {FixedPhase(0, 2, zero)};
  ocp.contacts[0].force_shares = Eigen::Vector2d(0.75, 0.25);
  CentroidalNlp nlp;
  nlp.SetProblem(ocp);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(nlp.num_variables());
  x(2) = 3.0;  // u_z of the first vertex, f / m
  x(5) = 1.0;
  EXPECT_EQ(nlp.Cost(x), 0.0);
  x(2) = x(5) = 2.0;  // deviations 2 - 0.75 * 4 = -1 and +1
  EXPECT_NEAR(nlp.Cost(x), 0.5 * 10.0 * 2.0, 1e-12);
}

TEST(ForceSharesTest, BrokenSharesAreABrokenContract) {
  CentroidalOcp ocp = Standing();
  ocp.contacts[0].force_shares = Eigen::Vector3d::Constant(1.0 / 3.0);
  EXPECT_THROW(CheckShapes(ocp), ContractViolation) << "three of four";
  ocp.contacts[0].force_shares = Eigen::Vector4d::Constant(0.26);
  EXPECT_THROW(CheckShapes(ocp), ContractViolation) << "1.04 in sum";
  ocp.contacts[0].force_shares = Eigen::Vector4d::Constant(0.25);
  EXPECT_NO_THROW(CheckShapes(ocp));
}

class ForceSharesOfTest : public testing::TestWithParam<MpcBackend> {};

TEST_P(ForceSharesOfTest, PullTheCentreOfPressureWhereTheyPoint) {
  const auto solver = MakeSolver(GetParam(), {});
  CentroidalOcp ocp = Standing();
  const double middle_m = CopY_m(ocp, solver->Solve(ocp, nullptr), 0);
  // Vertices 0 and 3 are on the left: +y.
  ocp.contacts[0].force_shares = Eigen::Vector4d(0.3, 0.2, 0.2, 0.3);
  const double left_m = CopY_m(ocp, solver->Solve(ocp, nullptr), 0);
  ocp.contacts[0].force_shares = Eigen::Vector4d(0.2, 0.3, 0.3, 0.2);
  const double right_m = CopY_m(ocp, solver->Solve(ocp, nullptr), 0);
  EXPECT_NEAR(middle_m, 0.0, 1e-6);
  EXPECT_GT(left_m, 1e-4);
  EXPECT_NEAR(right_m, -left_m, 1e-6);
}

TEST_P(ForceSharesOfTest, EqualOnesWrittenOutChangeNoBit) {
  const auto solver = MakeSolver(GetParam(), {});
  CentroidalOcp ocp = ReferenceProblem("icub_forward_40N_double_support");
  const MpcSolution implied = solver->Solve(ocp, nullptr);
  for (OcpContact& contact : ocp.contacts) {
    ASSERT_EQ(contact.vertices_m.cols(), 4) << "whose quarters are exact";
    contact.force_shares = Eigen::Vector4d::Constant(0.25);
  }
  const MpcSolution written = solver->Solve(ocp, nullptr);
  EXPECT_EQ(written.cost, implied.cost);
  EXPECT_EQ(written.iterations, implied.iterations);
  EXPECT_EQ(written.p_WC, implied.p_WC);
  EXPECT_EQ(written.contacts[0].force_N, implied.contacts[0].force_N);
  ocp.contacts[0].force_shares = Eigen::Vector4d(0.3, 0.2, 0.2, 0.3);
  EXPECT_NE(solver->Solve(ocp, nullptr).cost, implied.cost) << "others do";
}

INSTANTIATE_TEST_SUITE_P(BackEnds, ForceSharesOfTest, testing::ValuesIn(EnumValues<MpcBackend>()),
                         [](const auto& at) { return std::string(EnumName(at.param)); });

void ExpectAgreement(const CentroidalOcp& ocp, int* num_higher) {
  const MpcSolution ours = MakeSolver(MpcBackend::kStructured, {})->Solve(ocp, nullptr);
  const MpcSolution theirs = MakeSolver(MpcBackend::kIpopt, {})->Solve(ocp, nullptr);
  ASSERT_EQ(IsUsable(ours.status), IsUsable(theirs.status)) << EnumName(ours.status);
  if (!IsUsable(ours.status)) return;
  ExpectHonest(ocp, ours);
  *num_higher += ours.cost > theirs.cost * (1.0 + 1e-6) ? 1 : 0;
}

TEST(ForceSharesTest, BackEndsAgreeOnRandomProblemsWithUnequalShares) {
  Numbers numbers(11);
  int num_with_soles = 0;
  int num_higher = 0;
  for (unsigned seed = 2000; seed < 2016; ++seed) {
    SCOPED_TRACE(seed);
    CentroidalOcp ocp = RandomOcp(seed);
    DrawShares(numbers, &ocp);
    num_with_soles += ocp.contacts[0].force_shares.size() > 0 ? 1 : 0;
    ExpectAgreement(ocp, &num_higher);
  }
  EXPECT_GE(num_with_soles, 4);
  // Pushed robots have several local minima, and either solver may fall into the higher one.
  EXPECT_LE(num_higher, 1);
}

TEST(ForceSharesTest, BackEndsAgreeOnRecordedProblemsWithUnequalShares) {
  Numbers numbers(12);
  int num_higher = 0;
  for (const std::string& folder : RecordedFolders()) {
    SCOPED_TRACE(folder);
    CentroidalOcp ocp = ReadProblem(ProblemFiles(RecordedFolder() / folder).at(0));
    if (ocp.contacts[0].vertices_m.cols() < 2) continue;
    DrawShares(numbers, &ocp);
    ExpectAgreement(ocp, &num_higher);
  }
  EXPECT_LE(num_higher, 1);
}

}  // namespace
}  // namespace sidestep::mpc::force_shares_test
