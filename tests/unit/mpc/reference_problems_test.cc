// SPDX-License-Identifier: BSD-3-Clause
// Agreement with the reference problems, which an independent program solved by automatic
// differentiation to 1e-10 from several starting points.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "controller/mpc/ipopt/centroidal_nlp.h"
#include "controller/mpc/ipopt/nlp_points.h"
#include "controller/mpc/make_solver.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::reference_problems_test {
namespace {

constexpr double kCostTolerance = 1e-6;       // Relative; files carry ten digits.
constexpr double kComTolerance_m = 1e-4;      // Ten times what the files' makers ask for.
constexpr double kFootTolerance_m = 1e-4;     // Five times what the files' makers ask for.
constexpr double kForceTolerance = 1e-4;      // Of body weight.
constexpr double kKktTolerance = 1e-6;        // Scaled as Ipopt scales.
constexpr double kViolationTolerance = 1e-6;  // SI.

std::vector<std::string> FilesOf(const std::filesystem::path& folder, const std::string& prefix) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") {
      names.push_back(prefix + entry.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The files of the reference folder that hold a solution.
std::vector<std::string> SolvedFiles() {
  std::vector<std::string> names = FilesOf(ReferenceFolder(), "");
  std::erase_if(names, [](const std::string& name) {
    return ReferenceJson(name)["solution"]["status"] != "solved";
  });
  return names;
}

std::string CaseName(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

/// A back end and a file.
using Case = std::tuple<MpcBackend, std::string>;

std::string PairName(const testing::TestParamInfo<Case>& info) {
  std::string name = std::string(EnumName(std::get<0>(info.param))) + "_" + std::get<1>(info.param);
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

const auto kBackEnds = testing::ValuesIn(EnumValues<MpcBackend>());

void ExpectSameMotion(const CentroidalOcp& ocp, const MpcSolution& solution,
                      const MpcSolution& expected) {
  EXPECT_LT((solution.p_WC - expected.p_WC).cwiseAbs().maxCoeff(), kComTolerance_m);
  const double weight_N = ocp.mass_kg * kStandardGravity_mps2;
  for (std::size_t i = 0; i < ocp.contacts.size(); ++i) {
    const ContactSolution& part = solution.contacts[i];
    for (std::size_t q = 0; q < part.phase_p_WF.size(); ++q) {
      const Eigen::Vector3d error = part.phase_p_WF[q] - expected.contacts[i].phase_p_WF[q];
      EXPECT_LT(error.cwiseAbs().maxCoeff(), kFootTolerance_m) << i << ", " << q;
    }
    for (std::size_t k = 0; k < part.force_N.size(); ++k) {
      const Eigen::Matrix3Xd error_N = part.force_N[k] - expected.contacts[i].force_N[k];
      EXPECT_LT(error_N.cwiseAbs().maxCoeff(), kForceTolerance * weight_N) << i << ", " << k;
    }
  }
}

class ReferenceProblemTest : public testing::TestWithParam<Case> {};

TEST_P(ReferenceProblemTest, ColdStartReachesTheReferenceSolution) {
  const auto [back_end, file] = GetParam();
  const nlohmann::json json = ReferenceJson(file);
  const CentroidalOcp ocp = OcpFromJson(json);
  const MpcSolution expected = SolutionFromJson(ocp, json["solution"]);
  const auto solver = MakeSolver(back_end, {});
  const MpcSolution& solution = solver->Solve(ocp, nullptr);
  ASSERT_EQ(EnumName(solution.status), EnumName(expected.status));
  if (expected.status == SolveStatus::kInfeasible) {
    return;
  }
  EXPECT_LT(solution.constraint_violation, kViolationTolerance);
  EXPECT_LE(solution.kkt_error, kKktTolerance);
  EXPECT_LE(solution.cost, expected.cost + kCostTolerance * expected.cost);
  if (solution.cost > expected.cost - kCostTolerance * expected.cost) {
    ExpectSameMotion(ocp, solution, expected);
  } else {
    // A lower minimum is welcome only where the makers of the files met several.
    EXPECT_FALSE(json["solution"]["other_minima"].empty()) << solution.cost;
  }
}

class SolvedReferenceProblemTest : public testing::TestWithParam<std::string> {};

TEST_P(SolvedReferenceProblemTest, TheReferenceSolutionIsFeasibleAndCostsWhatItSays) {
  // Independent of the solver: a wrong term shows here even if the optimum barely moves.
  const nlohmann::json json = ReferenceJson(GetParam());
  const CentroidalOcp ocp = OcpFromJson(json);
  const MpcSolution expected = SolutionFromJson(ocp, json["solution"]);
  CentroidalNlp nlp;
  nlp.SetProblem(ocp);
  Eigen::VectorXd x;
  PackPoint(ocp, nlp.layout(), expected, &x);
  // Ten digits are left of each number; the steepest weight is 2e5.
  EXPECT_NEAR(nlp.Cost(x), expected.cost, 1e-6 * expected.cost);
  EXPECT_LT(nlp.ConstraintViolation(x), 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Files, ReferenceProblemTest,
                         testing::Combine(kBackEnds,
                                          testing::ValuesIn(FilesOf(ReferenceFolder(), ""))),
                         PairName);

INSTANTIATE_TEST_SUITE_P(Files, SolvedReferenceProblemTest, testing::ValuesIn(SolvedFiles()),
                         CaseName);

class DegenerateProblemTest : public testing::TestWithParam<Case> {};

TEST_P(DegenerateProblemTest, CostAndComAgreeWhereTheOptimumIsNotUnique) {
  const auto [back_end, file] = GetParam();
  const nlohmann::json json = ReferenceJson(file);
  CentroidalOcp ocp = OcpFromJson(json);
  // Solved before the term existed that makes the optimum unique.
  ocp.weights.new_contact_force.setZero();
  const MpcSolution expected = SolutionFromJson(ocp, json["solution"]);
  SolverOptions options;
  options.max_iterations = 1000;  // The free force is driven far out.
  const auto solver = MakeSolver(back_end, options);
  const MpcSolution& solution = solver->Solve(ocp, nullptr);
  EXPECT_EQ(EnumName(solution.status), "solved");
  EXPECT_NEAR(solution.cost, expected.cost, kCostTolerance * expected.cost);
  EXPECT_LT((solution.p_WC - expected.p_WC).cwiseAbs().maxCoeff(), kComTolerance_m);
}

INSTANTIATE_TEST_SUITE_P(
    Files, DegenerateProblemTest,
    testing::Combine(kBackEnds,
                     testing::ValuesIn(FilesOf(ReferenceFolder() / "degenerate", "degenerate/"))),
    PairName);

TEST(ReferenceProblemsTest, TheFolderHoldsTheProblemsThatTheseTestsAreWorth) {
  EXPECT_GE(FilesOf(ReferenceFolder(), "").size(), 24U);
  EXPECT_GE(SolvedFiles().size(), 22U);
  EXPECT_GE(FilesOf(ReferenceFolder() / "degenerate", "").size(), 2U);
}

}  // namespace
}  // namespace sidestep::mpc::reference_problems_test
