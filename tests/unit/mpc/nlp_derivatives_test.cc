// SPDX-License-Identifier: BSD-3-Clause
// Every entry of gradient, Jacobian and Hessian against central differences, for every pattern of
// contacts. But for legs and loads the functions are at most quadratic, so differences have no
// truncation error whatever the step; with a step of 1 rounding is all that is left.
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "controller/mpc/ipopt/centroidal_nlp.h"
#include "tests/unit/mpc/mpc_test_support.h"

namespace sidestep::mpc::nlp_derivatives_test {
namespace {

constexpr int kKnots = 5;
// Values reach 1e3 here; eps * 1e3 * (some hundred terms) is below 1e-10.
constexpr double kTolerance = 1e-9;
// Steps that are exact where all is quadratic; legs are not, and loads have kinks, near none of
// which a point is: 1e-10 times third derivatives, and rounding over 1e-5.
constexpr double kStep = 1.0, kShortStep = 1e-5, kToleranceOfShortSteps = 1e-6;

struct Pattern {
  std::string name;
  CentroidalOcp ocp;

  bool is_quadratic() const {
    return ocp.weights.leg_length == 0.0 && ocp.weights.foot_load == 0.0;
  }
};

OcpContact With(OcpContact foot, std::vector<ContactPhase> phases, bool has_previous_force) {
  foot.phases = std::move(phases);
  foot.has_previous_force = has_previous_force;
  foot.previous_force_N = Eigen::Matrix3Xd::Zero(3, foot.vertices_m.cols());
  return foot;
}

OcpContact WithShares(OcpContact foot) {
  foot.force_shares.setConstant(foot.vertices_m.cols(), 0.25);  // Randomised later.
  return foot;
}

std::vector<Pattern> AllPatterns() {
  const Eigen::Vector3d any = Eigen::Vector3d::Zero();  // Randomised later.
  const Eigen::Vector3d box(0.1, 0.1, 0.0);
  const OcpContact point = Foot("point", 1);
  const OcpContact left = Foot("left", 4);
  const OcpContact right = Foot("right", 4);
  const int N = kKnots;
  const std::vector<std::pair<const char*, std::vector<OcpContact>>> table = {
      {"Floating", {}},
      {"FlightOverTheWholeHorizon", {With(left, {}, false)}},
      {"PointFootStands", {With(point, {FixedPhase(0, N + 1, any)}, false)}},
      {"PointFootHops", {With(point, {FixedPhase(0, 1, any), FreePhase(2, 4, any, box)}, true)}},
      {"FourVerticesStand", {With(left, {FixedPhase(0, N + 1, any)}, true)}},
      {"BothFeetOneSteps",
       {With(left, {FixedPhase(0, 2, any), FreePhase(3, N + 1, any, box)}, true),
        With(right, {FixedPhase(0, N + 1, any)}, false)}},
      {"TouchDownAtTheLastInput",
       {With(left, {FreePhase(N - 1, N + 1, any, box)}, false),
        With(right, {FixedPhase(0, N, any)}, true)}},
      {"FixedTouchDownAtTheLastInput", {With(left, {FixedPhase(N - 1, 40, any)}, false)}},
      {"PhaseStartsAtTheEnd",
       {With(left, {FixedPhase(0, 2, any), FreePhase(N, N + 3, any, box)}, false)}},
      {"PhaseBeyondTheHorizon",
       {With(left, {FixedPhase(0, 2, any), FreePhase(N + 1, N + 3, any, box)}, false)}},
      {"FreeFromTheStart", {With(left, {FreePhase(0, 3, any, box)}, true)}},
      {"PhasesThatTouch",
       {With(left, {FreePhase(0, 2, any, box), FreePhase(2, 4, any, box)}, true)}},
      {"PreviousForceOfASwingFoot", {With(left, {FreePhase(2, 4, any, box)}, true)}},
      {"UnequalShares",
       {WithShares(With(left, {FixedPhase(0, 2, any), FreePhase(3, N + 1, any, box)}, true)),
        With(right, {FixedPhase(0, N + 1, any)}, false)}},
  };
  std::vector<Pattern> patterns;
  Numbers numbers(7);
  for (const auto& [name, contacts] : table) {
    Pattern pattern{name, FloatingProblem(N)};
    pattern.ocp.contacts = contacts;
    pattern.ocp.first_step_s = 0.03;  // Of 0.1 s: every knot has its own step.
    Randomise(numbers, &pattern.ocp);
    patterns.push_back(pattern);
    patterns.back().ocp.weights.leg_length = patterns.back().ocp.weights.foot_load = 0.0;
    patterns.push_back(pattern);
    patterns.back().name += "OnLegs";
    patterns.back().ocp.weights.foot_load = 0.0;
    patterns.push_back(pattern);
    patterns.back().name += "UnderLoad";
    patterns.back().ocp.weights.leg_length = 0.0;
  }
  return patterns;
}

class NlpDerivativesTest : public testing::TestWithParam<Pattern> {
 protected:
  void SetUp() override {
    nlp_.SetProblem(GetParam().ocp);
    Numbers numbers(11);
    x_.resize(nlp_.num_variables());
    numbers.Fill(x_);
    multipliers_.resize(nlp_.num_constraints());
    numbers.Fill(multipliers_);
  }

  Eigen::MatrixXd Jacobian(const Eigen::VectorXd& x) const {
    const auto size = static_cast<std::size_t>(nlp_.num_jacobian_entries());
    std::vector<int> rows(size), columns(size);
    std::vector<double> values(size);
    nlp_.JacobianStructure(rows.data(), columns.data());
    nlp_.JacobianValues(x, values.data());
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(nlp_.num_constraints(), nlp_.num_variables());
    for (std::size_t e = 0; e < size; ++e) {
      dense(rows[e], columns[e]) += values[e];
    }
    return dense;
  }

  Eigen::VectorXd LagrangianGradient(const Eigen::VectorXd& x, double cost_factor) const {
    Eigen::VectorXd gradient(nlp_.num_variables());
    nlp_.Gradient(x, gradient);
    return cost_factor * gradient + Jacobian(x).transpose() * multipliers_;
  }

  /// Column c: (f(x + h e_c) - f(x - h e_c)) / 2h.
  template <typename Function>
  Eigen::MatrixXd CentralDifference(Function&& f, Eigen::Index num_rows) const {
    Eigen::MatrixXd result(num_rows, x_.size());
    const double step = GetParam().is_quadratic() ? kStep : kShortStep;
    for (Eigen::Index c = 0; c < x_.size(); ++c) {
      const Eigen::VectorXd move = step * Eigen::VectorXd::Unit(x_.size(), c);
      result.col(c) = 0.5 / step * (f(x_ + move) - f(x_ - move));
    }
    return result;
  }

  static void ExpectNear(const Eigen::MatrixXd& analytic, const Eigen::MatrixXd& numeric) {
    ASSERT_EQ(analytic.rows(), numeric.rows());
    ASSERT_EQ(analytic.cols(), numeric.cols());
    const double tolerance = GetParam().is_quadratic() ? kTolerance : kToleranceOfShortSteps;
    for (Eigen::Index c = 0; c < analytic.cols(); ++c) {
      for (Eigen::Index r = 0; r < analytic.rows(); ++r) {
        const double scale = std::max(1.0, std::abs(analytic(r, c)));
        EXPECT_NEAR(analytic(r, c), numeric(r, c), tolerance * scale) << r << ", " << c;
      }
    }
  }

  CentroidalNlp nlp_;
  Eigen::VectorXd x_;
  Eigen::VectorXd multipliers_;
};

TEST_P(NlpDerivativesTest, GradientMatchesCentralDifferencesInEveryEntry) {
  Eigen::VectorXd gradient(nlp_.num_variables());
  nlp_.Gradient(x_, gradient);
  const auto cost = [&](const Eigen::VectorXd& x) {
    return Eigen::VectorXd::Constant(1, nlp_.Cost(x)).eval();
  };
  ExpectNear(gradient.transpose(), CentralDifference(cost, 1));
}

TEST_P(NlpDerivativesTest, JacobianMatchesCentralDifferencesInsideAndOutsideItsPattern) {
  const auto constraints = [&](const Eigen::VectorXd& x) {
    Eigen::VectorXd g(nlp_.num_constraints());
    nlp_.Constraints(x, g);
    return g;
  };
  ExpectNear(Jacobian(x_), CentralDifference(constraints, nlp_.num_constraints()));
}

TEST_P(NlpDerivativesTest, HessianMatchesCentralDifferencesInsideAndOutsideItsPattern) {
  const double cost_factor = 0.7;
  const auto size = static_cast<std::size_t>(nlp_.num_hessian_entries());
  std::vector<int> rows(size), columns(size);
  std::vector<double> values(size);
  nlp_.HessianStructure(rows.data(), columns.data());
  nlp_.HessianValues(x_, cost_factor, multipliers_, values.data());
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(nlp_.num_variables(), nlp_.num_variables());
  for (std::size_t e = 0; e < size; ++e) {
    ASSERT_GE(rows[e], columns[e]) << "above the diagonal";
    dense(rows[e], columns[e]) = values[e];
    dense(columns[e], rows[e]) = values[e];
  }
  const auto gradient = [&](const Eigen::VectorXd& x) {
    return LagrangianGradient(x, cost_factor);
  };
  ExpectNear(dense, CentralDifference(gradient, nlp_.num_variables()));
}

TEST_P(NlpDerivativesTest, NoEntryIsListedTwiceOrLiesOutside) {
  const auto expect_unique = [](const std::vector<int>& rows, const std::vector<int>& columns,
                                int num_rows, int num_columns) {
    std::set<std::pair<int, int>> seen;
    for (std::size_t e = 0; e < rows.size(); ++e) {
      EXPECT_TRUE(seen.insert({rows[e], columns[e]}).second) << rows[e] << ", " << columns[e];
      EXPECT_TRUE(rows[e] >= 0 && rows[e] < num_rows) << rows[e];
      EXPECT_TRUE(columns[e] >= 0 && columns[e] < num_columns) << columns[e];
    }
  };
  std::vector<int> rows(static_cast<std::size_t>(nlp_.num_jacobian_entries()));
  std::vector<int> columns(rows.size());
  nlp_.JacobianStructure(rows.data(), columns.data());
  expect_unique(rows, columns, nlp_.num_constraints(), nlp_.num_variables());
  rows.resize(static_cast<std::size_t>(nlp_.num_hessian_entries()));
  columns.resize(rows.size());
  nlp_.HessianStructure(rows.data(), columns.data());
  expect_unique(rows, columns, nlp_.num_variables(), nlp_.num_variables());
}

TEST_P(NlpDerivativesTest, LoadsAddNoEntryToTheHessian) {
  CentroidalOcp ocp = GetParam().ocp;
  ocp.weights.foot_load = 0.0;
  CentroidalNlp without;
  without.SetProblem(ocp);
  EXPECT_EQ(nlp_.num_hessian_entries(), without.num_hessian_entries());
}

INSTANTIATE_TEST_SUITE_P(Patterns, NlpDerivativesTest, testing::ValuesIn(AllPatterns()),
                         [](const auto& at) { return at.param.name; });

}  // namespace
}  // namespace sidestep::mpc::nlp_derivatives_test
