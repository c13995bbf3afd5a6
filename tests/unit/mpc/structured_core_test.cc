// SPDX-License-Identifier: BSD-3-Clause
// Parts of the structured back end on their own: the Newton system, force limits, both
// instruction sets.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <utility>

#include "controller/mpc/problem/solution_shape.h"
#include "controller/mpc/structured/filter.h"
#include "controller/mpc/structured/foot_load.h"
#include "controller/mpc/structured/minimize.h"
#include "controller/mpc/structured/structured_memory.h"
#include "controller/mpc/structured/structured_problem.h"
#include "tests/unit/mpc/random_ocp.h"

namespace sidestep::mpc::structured::structured_core_test {
namespace {

/// A laid-out problem at a random point, ready for a Newton step.
struct RandomPoint {
  explicit RandomPoint(const CentroidalOcp& problem) : ocp(problem) {
    laid_out.Build(ocp);
    memory.Take(laid_out.view(), &work);
    const ProblemView& view = laid_out.view();
    Numbers numbers(3);
    for (int i = 0; i < view.at.size; ++i) work.point[i] = numbers.Next();
    for (int i = view.at.s; i < view.at.size; ++i) work.point[i] = 1.5 + numbers.Next();
    for (int i = 0; i < 3 * view.num_locations; ++i) {
      work.point[view.at.d + i] = 0.5 * (view.box_lower[i] + view.box_upper[i]);
    }
    baseline::Evaluate(view, work.point, &work.now);
    baseline::Linearize(view, work.point, &work.linear);
    baseline::SetTarget(view, work.point, 0.1, 0.0, work.target);
    baseline::BuildTerms(view, work.point, work.now, work.linear, work.target, &work.newton);
  }

  CentroidalOcp ocp;
  StructuredProblem laid_out;
  Memory memory;
  Workspace work;
};

using ConstMap = Eigen::Map<const Eigen::VectorXd>;

/// The core's functions of the primal variables [x_1.. x_N, u, d], by finite differences that are
/// exact where the cost is quadratic, which it is without legs, and without loads about their
/// limits: the gap is bilinear.
class Differences {
 public:
  /// `step` is the gradient's.
  Differences(RandomPoint* at, double step)
      : at_(*at), view_(at->laid_out.view()), num_rows_(9 * view_.knots), step_(step) {}

  int num_primal() const { return view_.at.s - 9; }

  /// The gap with entries i and j moved.
  Eigen::VectorXd Gap(int i, double step_i, int j, double step_j) {
    double* point = at_.work.point + 9;
    const double kept_i = point[i], kept_j = point[j];
    point[i] += step_i;
    point[j] += step_j;
    baseline::Evaluate(view_, at_.work.point, &at_.work.next);
    point[j] = kept_j;
    point[i] = kept_i;
    return ConstMap(at_.work.next.gap, num_rows_);
  }

  double Cost(int i, double step) {
    double* point = at_.work.point + 9;
    const double kept = point[i];
    point[i] += step;
    baseline::Evaluate(view_, at_.work.point, &at_.work.next);
    point[i] = kept;
    return at_.work.next.cost;
  }

  /// First derivatives of the cost.
  Eigen::VectorXd Slopes() {
    Eigen::VectorXd slopes(num_primal());
    for (int i = 0; i < num_primal(); ++i) {
      slopes(i) = 0.5 / step_ * (Cost(i, step_) - Cost(i, -step_));
    }
    return slopes;
  }

  Eigen::VectorXd Gradient(int i, double step) {
    double* point = at_.work.point + 9;
    const double kept = point[i];
    point[i] += step;
    baseline::Linearize(view_, at_.work.point, &at_.work.linear);
    point[i] = kept;
    return ConstMap(at_.work.linear.gradient + 9, num_primal());
  }

  Eigen::MatrixXd Jacobian() {
    Eigen::MatrixXd J(num_rows_, num_primal());
    for (int i = 0; i < num_primal(); ++i) {
      J.col(i) = 0.5 * (Gap(i, 1.0, i, 0.0) - Gap(i, -1.0, i, 0.0));
    }
    return J;
  }

  /// Second derivatives of cost + multipliers . gap.
  Eigen::MatrixXd Hessian(const Eigen::VectorXd& multipliers) {
    Eigen::MatrixXd H(num_primal(), num_primal());
    const Eigen::VectorXd here = Gap(0, 0.0, 0, 0.0);
    for (int i = 0; i < num_primal(); ++i) {
      H.col(i) = 0.5 / step_ * (Gradient(i, step_) - Gradient(i, -step_));
    }
    for (int i = 0; i < num_primal(); ++i) {
      for (int j = 0; j < num_primal(); ++j) {
        if (i == j) continue;
        H(i, j) +=
            multipliers.dot(Gap(i, 1.0, j, 1.0) - Gap(i, 1.0, j, 0.0) - Gap(i, 0.0, j, 1.0) + here);
      }
    }
    return H;
  }

 private:
  RandomPoint& at_;
  const ProblemView& view_;
  int num_rows_;
  double step_;
};

/// Adds the curvature of the friction rows' barrier.
void AddFrictionBarrier(const ProblemView& view, const double* point, Eigen::MatrixXd* H) {
  for (int k = 0; k < view.knots; ++k) {
    const Stage& stage = view.stages[k];
    const int n = stage.num_slots, first = view.at.u - 9 + 3 * stage.first_slot;
    for (int row = 0; row < view.num_faces * n; ++row) {
      const int at = view.num_faces * stage.first_slot + row, j = row % n;
      const double* face = view.face + 3 * (at - j) + j;
      const double weight = point[view.at.z + at] / point[view.at.s + at];
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) {
          (*H)(first + a * n + j, first + b * n + j) += weight * face[a * n] * face[b * n];
        }
      }
    }
  }
}

/// Solves the Newton system as one dense matrix over primal variables and multipliers: nothing of
/// the recursion is shared.
Eigen::VectorXd DenseDirection(RandomPoint* at, double step = 1.0) {
  const ProblemView& view = at->laid_out.view();
  const int num_primal = view.at.s - 9, num_rows = 9 * view.knots;
  const Eigen::VectorXd multipliers = ConstMap(at->work.linear.costate + 9, num_rows);
  Differences differences(at, step);
  Eigen::MatrixXd J = differences.Jacobian(), H = differences.Hessian(multipliers);
  AddFrictionBarrier(view, at->work.point, &H);
  Eigen::VectorXd right(num_primal + num_rows);
  right << -ConstMap(at->work.newton.slope + 9, num_primal), -ConstMap(at->work.now.gap, num_rows);
  for (int i = 0; i < 3 * view.num_locations; ++i) {
    const int entry = view.at.d - 9 + i;
    if (view.is_free[i] != 0.0) {
      H(entry, entry) += at->work.newton.box_curvature[i];
      continue;
    }
    H.row(entry).setZero();
    H.col(entry).setZero();
    J.col(entry).setZero();
    H(entry, entry) = 1.0;
    right(entry) = 0.0;
  }
  Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(right.size(), right.size());
  kkt << H, J.transpose(), J, Eigen::MatrixXd::Zero(num_rows, num_rows);
  return Eigen::VectorXd(kkt.partialPivLu().solve(right)).head(num_primal);
}

/// Two feet of which one lands and one leaves, boxes with and without size, forces before.
CentroidalOcp SmallProblem() {
  CentroidalOcp ocp = FloatingProblem(4);
  OcpContact left = Foot("left", 4), right = Foot("right", 3);
  right.vertices_m.row(0) << 0.1, 0.0, -0.1;
  left.phases = {FixedPhase(0, 3, {0.0, 0.1, 0.0})};
  left.has_previous_force = true;
  left.previous_force_N = Eigen::Matrix3Xd::Ones(3, 4);
  right.phases = {FreePhase(1, 3, {0.1, -0.1, 0.0}, {0.1, 0.1, 0.0}),
                  FreePhase(3, 8, {0.2, -0.1, 0.0}, {0.1, 0.2, 0.3})};
  ocp.contacts = {left, right};
  ocp.first_step_s = 0.04;  // Of 0.1 s.
  Numbers numbers(5);
  Randomise(numbers, &ocp);
  // Large enough weights keep the reduced Hessian positive definite.
  ocp.weights.force_symmetry.setConstant(300.0);
  ocp.weights.contact_position.setConstant(300.0);
  ocp.weights.com.setConstant(100.0);
  ocp.weights.leg_length = ocp.weights.foot_load = 0.0;
  return ocp;
}

TEST(StructuredCoreTest, TheDynamicsOfEveryKnotLastAsLongAsItDoes) {
  // By hand: 2 kg that move at 3 m/s, are pushed by 8 N and turned by 6 N m. The next state of the
  // point is zero, so that the gap is what the knot adds; a knot of 0.1 s after one of 0.04 s.
  CentroidalOcp ocp = FloatingProblem(2);
  ocp.first_step_s = 0.04;
  ocp.gravity_mps2.setZero();
  ocp.external_force_N.setConstant(8.0);
  ocp.external_torque_Nm.setConstant(6.0);
  StructuredProblem laid_out;
  laid_out.Build(ocp);
  Memory memory;
  Workspace work;
  memory.Take(laid_out.view(), &work);
  std::fill(work.point, work.point + laid_out.view().at.size, 0.0);
  for (const int k : {0, 1}) {
    std::fill(work.point + 9 * k + 3, work.point + 9 * k + 6, 3.0);
    baseline::Evaluate(laid_out.view(), work.point, &work.now);
    std::fill(work.point + 9 * k + 3, work.point + 9 * k + 6, 0.0);
    const double step_s = k == 0 ? 0.04 : 0.1;
    for (int a = 0; a < 3; ++a) {
      EXPECT_NEAR(work.now.gap[9 * k + a], 3.0 * step_s, 1e-15) << k;
      EXPECT_NEAR(work.now.gap[9 * k + 3 + a], 3.0 + 4.0 * step_s, 1e-15) << k;
      EXPECT_NEAR(work.now.gap[9 * k + 6 + a], 3.0 * step_s, 1e-15) << k;
    }
  }
}

TEST(StructuredCoreTest, TheRecursionSolvesTheWholeNewtonSystem) {
  RandomPoint at(SmallProblem());
  const ProblemView& view = at.laid_out.view();
  // Solve with the multipliers at the point, then the same as one dense system.
  ASSERT_TRUE(baseline::Factorize(view, at.work.now, at.work.linear, at.work.newton));
  baseline::SolveForward(view, at.work.newton, false, at.work.direction);
  const Eigen::VectorXd ours =
      Eigen::Map<const Eigen::VectorXd>(at.work.direction + 9, view.at.s - 9);
  const Eigen::VectorXd expected = DenseDirection(&at);
  EXPECT_LT((ours - expected).cwiseAbs().maxCoeff(), 1e-8 * expected.cwiseAbs().maxCoeff());
}

// Expects the recursion to solve the Newton system with the curvature of `ocp`, which the terms it
// has beyond SmallProblem() are to change.
void ExpectCurvature(const CentroidalOcp& ocp) {
  RandomPoint at(ocp), other(SmallProblem());
  const ProblemView& view = at.laid_out.view();
  ASSERT_TRUE(baseline::Factorize(view, at.work.now, at.work.linear, at.work.newton));
  baseline::SolveForward(view, at.work.newton, false, at.work.direction);
  const Eigen::VectorXd ours =
      Eigen::Map<const Eigen::VectorXd>(at.work.direction + 9, view.at.s - 9);
  const Eigen::VectorXd expected = DenseDirection(&at, 1e-4);
  EXPECT_LT((ours - expected).cwiseAbs().maxCoeff(), 1e-6 * expected.cwiseAbs().maxCoeff());
  const Eigen::VectorXd straight = DenseDirection(&other);
  EXPECT_GT((straight - expected).cwiseAbs().maxCoeff(), 0.01) << "terms that change nothing";
}

TEST(StructuredCoreTest, TheRecursionHasTheCurvatureOfLegsThatAreTooShort) {
  CentroidalOcp ocp = SmallProblem();
  ocp.weights.leg_length = 50.0;
  ExpectCurvature(ocp);
}

TEST(StructuredCoreTest, TheRecursionHasTheCurvatureOfFeetThatBearTooMuch) {
  CentroidalOcp ocp = SmallProblem();
  ocp.weights.foot_load = 50.0;
  ExpectCurvature(ocp);
}

TEST(StructuredCoreTest, TheGradientIsThatOfTheCost) {
  for (const bool has_legs : {false, true}) {
    for (const bool has_loads : {false, true}) {
      CentroidalOcp ocp = SmallProblem();
      if (has_legs) ocp.weights.leg_length = 50.0;
      if (has_loads) ocp.weights.foot_load = 50.0;
      RandomPoint at(ocp);
      const Eigen::VectorXd slopes = Differences(&at, 1e-5).Slopes();
      const Eigen::VectorXd ours = ConstMap(at.work.linear.gradient + 9, slopes.size());
      // Costs reach 1e4, and eps * 1e4 / 1e-5 is 2e-7.
      EXPECT_LT((ours - slopes).cwiseAbs().maxCoeff(), 1e-6 * (1.0 + ours.cwiseAbs().maxCoeff()))
          << has_legs << has_loads;
    }
  }
}

TEST(StructuredCoreTest, FeetAreOverloadedInSomeKnotsOnly) {
  CentroidalOcp ocp = SmallProblem();
  ocp.weights.foot_load = 50.0;
  RandomPoint at(ocp);
  const ProblemView& view = at.laid_out.view();
  const Stage& last = view.stages[view.knots - 1];
  const int num_blocks = last.first_block + last.num_blocks;
  int num_above = 0;
  for (int b = 0; b < num_blocks; ++b) {
    num_above += baseline::LoadCurvature(view, at.work.linear, b) > 0.0 ? 1 : 0;
  }
  EXPECT_GT(num_above, 0);
  EXPECT_LT(num_above, num_blocks);
}

TEST(StructuredCoreTest, ChangingTheSlopesEqualsSolvingAnew) {
  RandomPoint at(SmallProblem());
  const ProblemView& view = at.laid_out.view();
  const auto size = static_cast<std::size_t>(view.at.s);
  ASSERT_TRUE(baseline::Factorize(view, at.work.now, at.work.linear, at.work.newton));
  Numbers numbers(11);
  for (std::size_t i = 0; i < size; ++i) at.work.change[i] = numbers.Next();
  for (int i = 0; i < 3 * view.num_locations; ++i) {
    if (view.is_free[i] == 0.0) at.work.change[view.at.d + i] = 0.0;
  }
  baseline::ChangeSlope(view, at.work.newton, at.work.change);
  baseline::SolveForward(view, at.work.newton, true, at.work.direction);
  const std::vector<double> changed(at.work.direction, at.work.direction + size);
  for (int i = view.at.u; i < view.at.s; ++i) at.work.newton.slope[i] += at.work.change[i];
  ASSERT_TRUE(baseline::Factorize(view, at.work.now, at.work.linear, at.work.newton));
  baseline::SolveForward(view, at.work.newton, false, at.work.direction);
  for (std::size_t i = 9; i < size; ++i) {
    EXPECT_NEAR(changed[i], at.work.direction[i], 1e-9 * (1.0 + std::abs(changed[i]))) << i;
  }
}

TEST(StructuredCoreTest, NegativeCurvatureIsNoticed) {
  CentroidalOcp ocp = SmallProblem();
  for (Eigen::Vector3d* weight : {&ocp.weights.force_symmetry, &ocp.weights.force_rate}) {
    weight->setConstant(-1e3);
  }
  RandomPoint at(ocp);
  EXPECT_FALSE(
      baseline::Factorize(at.laid_out.view(), at.work.now, at.work.linear, at.work.newton));
}

/// A cold solve by the core itself.
Summary ColdMinimum(const CentroidalOcp& ocp, const Settings& settings, bool is_baseline) {
  MpcSolution start;
  ColdStart(ocp, &start);
  StructuredProblem laid_out;
  laid_out.Build(ocp);
  Memory memory;
  Workspace work;
  memory.Take(laid_out.view(), &work);
  laid_out.Pack(ocp, start, work.point);
  return is_baseline ? baseline::Minimize(laid_out.view(), settings, &work)
                     : Minimize(laid_out.view(), settings, &work);
}

TEST(StructuredCoreTest, BothInstructionSetsReachTheSameOptimum) {
  if (!HasFastInstructions()) GTEST_SKIP() << "this processor has one only";
  const CentroidalOcp ocp = ReferenceProblem("icub_yawed_step_up_tilted");
  const Summary fast = ColdMinimum(ocp, {}, false);
  const Summary slow = ColdMinimum(ocp, {}, true);
  EXPECT_EQ(fast.outcome, Outcome::kSolved);
  EXPECT_EQ(slow.outcome, Outcome::kSolved);
  EXPECT_NEAR(fast.cost, slow.cost, 1e-9 * slow.cost);
}

TEST(StructuredCoreTest, TheChosenMethodBeatsTheOthersOnIterationsAndAgreesOnTheOptimum) {
  Settings monotone, convex;
  monotone.is_adaptive = false;
  convex.is_exact = false;
  int chosen_sum = 0, monotone_sum = 0, convex_sum = 0;
  for (const char* name :
       {"icub_nominal_just_landed", "icub_forward_40N_single_support_late", "icub_N30_friction_1",
        "icub_lateral_40N_single_support_early", "biped_walk_to_run", "hopper_stance_first"}) {
    SCOPED_TRACE(name);
    const CentroidalOcp ocp = ReferenceProblem(name);
    const Summary chosen = ColdMinimum(ocp, {}, false);
    for (const auto& [settings, sum] :
         {std::pair(&monotone, &monotone_sum), std::pair(&convex, &convex_sum)}) {
      const Summary other = ColdMinimum(ocp, *settings, false);
      EXPECT_EQ(other.outcome, Outcome::kSolved);
      EXPECT_NEAR(other.cost, chosen.cost, 1e-6 * chosen.cost);
      *sum += other.iterations;
    }
    chosen_sum += chosen.iterations;
  }
  EXPECT_LT(chosen_sum, monotone_sum);
  EXPECT_LT(chosen_sum, convex_sum);
}

// The damping's derivative, with everything else of the barrier function.
TEST(StructuredCoreTest, SlopeOfTheDampedBarrierIsThatOfFiniteDifferences) {
  constexpr double kBarrier = 0.3, kDamping = 0.7, kStep = 1e-6;
  RandomPoint at(ReferenceProblem("icub_yawed_step_up_tilted"));
  const ProblemView& view = at.laid_out.view();
  Numbers numbers(5);
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(view.at.size);
  for (int i = 9; i < view.at.z; ++i) direction(i) = numbers.Next();
  for (int i = 0; i < 3 * view.num_locations; ++i) {
    if (view.is_free[i] == 0.0) direction(view.at.d + i) = 0.0;
  }
  const auto value_at = [&](double step) {
    for (int i = 9; i < view.at.z; ++i) at.work.point[i] += step * direction(i);
    Evaluation& now = at.work.next;
    baseline::Evaluate(view, at.work.point, &now);
    for (int i = 9; i < view.at.z; ++i) at.work.point[i] -= step * direction(i);
    return now.cost - kBarrier * (now.log_sum - kDamping * now.slack_sum);
  };
  const double slope = baseline::BarrierSlope(view, at.work.point, direction.data(),
                                              at.work.linear.gradient, kBarrier, kDamping);
  const double difference = (value_at(kStep) - value_at(-kStep)) / (2.0 * kStep);
  EXPECT_NEAR(slope, difference, 1e-6 * std::max(1.0, std::abs(slope)));
}

TEST(StructuredCoreTest, DampedTargetsAreWhereTheDampedBarrierIsStationaryInTheSlacks) {
  RandomPoint at(ReferenceProblem("icub_nominal_just_landed"));
  const ProblemView& view = at.laid_out.view();
  baseline::SetTarget(view, at.work.point, 0.5, 0.2, at.work.target);
  for (int i = 0; i < view.at.z - view.at.s; ++i) {  // z = mu / s - mu damping, times s
    EXPECT_DOUBLE_EQ(at.work.target[view.at.z + i], 0.5 - 0.1 * at.work.point[view.at.s + i]);
  }
  for (int i = view.at.lower; i < view.at.size; ++i) EXPECT_EQ(at.work.target[i], 0.5);
}

TEST(StructuredCoreTest, AScaledCostIsThatManyTimesTheCost) {
  for (const char* name : {"icub_yawed_step_up_tilted", "biped_walk_to_run"}) {
    CentroidalOcp ocp = ReferenceProblem(name);
    ocp.weights.leg_length = 3.0;  // each weight takes part
    ocp.weights.foot_load = 2.0;
    ocp.foot_load_limit_N = 1.0;
    for (OcpContact& contact : ocp.contacts) contact.leg = {Eigen::Vector3d::Zero(), 0.1};
    RandomPoint at(ocp);
    const double cost = at.work.now.cost;
    at.laid_out.ScaleCost(0.25);
    baseline::Evaluate(at.laid_out.view(), at.work.point, &at.work.now);
    EXPECT_DOUBLE_EQ(at.work.now.cost, 0.25 * cost);
  }
}

TEST(FilterTest, RefusesWhatIsNoBetterInEitherMeasure) {
  baseline::Filter filter;
  filter.Reset(10.0);
  EXPECT_FALSE(filter.Accepts(11.0, -1e9)) << "beyond the largest infeasibility";
  filter.Add(1.0, 5.0);
  EXPECT_FALSE(filter.Accepts(1.0, 5.0));
  EXPECT_FALSE(filter.Accepts(2.0, 6.0));
  EXPECT_TRUE(filter.Accepts(0.5, 6.0));
  EXPECT_TRUE(filter.Accepts(2.0, 4.0));
  filter.Add(0.5, 6.0);
  EXPECT_FALSE(filter.Accepts(0.7, 7.0));
  filter.Reset(10.0);
  EXPECT_TRUE(filter.Accepts(2.0, 6.0));
}

}  // namespace
}  // namespace sidestep::mpc::structured::structured_core_test
