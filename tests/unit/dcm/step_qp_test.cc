// SPDX-License-Identifier: BSD-3-Clause
#include "controller/dcm/step_qp.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/dcm/pendulum.h"

namespace sidestep::dcm::step_qp_test {
namespace {

constexpr double kOmega = 4.0;
constexpr double kTime_s = 0.5;
const double kGrowth = std::exp(kOmega * kTime_s);  // 7.389

// A right foot at the origin stands, a left one is to land 0.1 m ahead and 0.2 m aside, and the
// DCM is at the begin of the support where the gait has it.
StepProblem Nominal() {
  StepProblem problem;
  problem.omega_per_s = kOmega;
  problem.nominal_step_m = {0.1, 0.2};
  problem.least_step_m = {-0.4, 0.15};
  problem.most_step_m = {0.6, 0.6};
  problem.nominal_offset_m = NominalOffset({0.1, 0.0}, {0.0, -0.2}, kGrowth);
  problem.least_offset_m = {-1.0, -1.0};
  problem.most_offset_m = {1.0, 1.0};
  problem.dcm_m = NominalOffset({0.1, 0.0}, {0.0, 0.2}, kGrowth);
  problem.nominal_s = kTime_s;
  return problem;
}

TEST(StepQpTest, NominalPendulumStepsNominally) {
  const StepProblem problem = Nominal();
  const StepDecision decision = StepQp({}).Solve(problem);
  ASSERT_EQ(decision.status, QpStatus::kSolved);
  EXPECT_NEAR((decision.step_m - problem.nominal_step_m).norm(), 0.0, 1e-9);
  EXPECT_NEAR((decision.offset_m - problem.nominal_offset_m).norm(), 0.0, 1e-9);
  EXPECT_NEAR(decision.time_s, kTime_s, 1e-9);
}

TEST(StepQpTest, TimePassesAndTheNominalStepStays) {
  StepProblem problem = Nominal();
  problem.elapsed_s = 0.2;
  problem.dcm_m *= std::exp(kOmega * problem.elapsed_s);
  const StepDecision decision = StepQp({}).Solve(problem);
  EXPECT_NEAR((decision.step_m - problem.nominal_step_m).norm(), 0.0, 1e-9);
  EXPECT_NEAR(decision.time_s, kTime_s, 1e-9);
}

// What is asked for: minimise w_u (u - u*)^2 + w_t' (tau - tau*)^2 + w_b (b - b*)^2 along x with
// u + b = xi tau. With no bound met, each is off by its multiplier's share:
// u = u* + m / w_u, b = b* + m / w_b, tau = tau* - m xi / w_t', m from the equality.
TEST(StepQpTest, PushedPendulumStepsAsTheConditionsOfOptimalityHaveIt) {
  DcmParams params;
  params.step_weight = 2.0;
  params.time_weight = 0.5;
  params.offset_weight = 100.0;
  StepProblem problem = Nominal();
  problem.nominal_step_m.y() = problem.nominal_offset_m.y() = problem.dcm_m.y() = 0.0;
  problem.least_step_m.y() = -0.5;
  problem.dcm_m.x() += 0.01;
  const double xi = problem.dcm_m.x();
  const double tau_weight = params.time_weight / std::pow(kOmega * kGrowth, 2);
  const double missing = xi * kGrowth - problem.nominal_step_m.x() - problem.nominal_offset_m.x();
  const double m =
      missing / (1.0 / params.step_weight + 1.0 / params.offset_weight + xi * xi / tau_weight);
  const StepDecision decision = StepQp(params).Solve(problem);
  EXPECT_NEAR(decision.step_m.x(), problem.nominal_step_m.x() + m / params.step_weight, 1e-9);
  EXPECT_NEAR(decision.offset_m.x(), problem.nominal_offset_m.x() + m / params.offset_weight, 1e-9);
  EXPECT_NEAR(decision.time_s, std::log(kGrowth - m * xi / tau_weight) / kOmega, 1e-9);
  EXPECT_LT(decision.time_s, kTime_s);
  EXPECT_GT(decision.step_m.x(), problem.nominal_step_m.x());
}

// 0.1 m too far ahead at once: by the clock 0.74 m more of step than the box has, so it is early.
TEST(StepQpTest, StepsAsEarlyAsABoxAtItsEndAsks) {
  StepProblem problem = Nominal();
  problem.dcm_m.x() += 0.1;
  DcmParams params;
  params.offset_weight = 1e8;
  const StepDecision decision = StepQp(params).Solve(problem);
  EXPECT_LE(decision.step_m.x(), 0.6 + 1e-9);
  EXPECT_LT(decision.time_s, kTime_s);
  const Eigen::Vector2d end_m = DcmAtTheEnd(problem, decision.time_s);
  EXPECT_NEAR((decision.step_m + decision.offset_m - end_m).norm(), 0.0, 1e-9);
}

TEST(StepQpTest, NeverQuickerOrSlowerThanBounds) {
  StepProblem problem = Nominal();
  problem.dcm_m.x() += 0.5;
  EXPECT_NEAR(StepQp({}).Solve(problem).time_s, problem.least_s, 1e-9);
  problem.longest_s = problem.least_s = 0.45;
  EXPECT_NEAR(StepQp({}).Solve(problem).time_s, 0.45, 1e-9);
}

// The offset is kept in its bounds where step and time can do that, and left where they can't.
TEST(StepQpTest, OffsetStaysViableIfItCan) {
  StepProblem problem = Nominal();
  problem.most_offset_m.x() = 0.01;
  DcmParams params;
  params.viability_weight = 1e8;
  EXPECT_NEAR(StepQp(params).Solve(problem).offset_m.x(), 0.01, 1e-5);
  problem.most_step_m = problem.least_step_m = problem.nominal_step_m;
  problem.longest_s = problem.least_s = kTime_s;
  const StepDecision fixed = StepQp(params).Solve(problem);
  ASSERT_EQ(fixed.status, QpStatus::kSolved);
  EXPECT_NEAR(fixed.offset_m.x(), problem.nominal_offset_m.x(), 1e-9);
}

// 0.01 m of DCM is 0.0739 m half a second later.
TEST(CapturePointStepTest, StepsAsMuchFartherAsTheDcmWillBe) {
  StepProblem problem = Nominal();
  problem.dcm_m += Eigen::Vector2d(0.01, 0.02);
  const StepDecision decision = CapturePointStep(problem);
  EXPECT_NEAR(decision.step_m.x(), 0.1 + 0.0738906, 1e-6);
  EXPECT_NEAR(decision.step_m.y(), 0.2 + 0.1477811, 1e-6);
  EXPECT_EQ(decision.time_s, kTime_s);
  EXPECT_NEAR((decision.offset_m - problem.nominal_offset_m).norm(), 0.0, 1e-9);
}

TEST(CapturePointStepTest, StaysInItsBox) {
  StepProblem problem = Nominal();
  problem.dcm_m.y() -= 0.05;
  const StepDecision decision = CapturePointStep(problem);
  EXPECT_EQ(decision.step_m.y(), problem.least_step_m.y());
  EXPECT_LT(decision.offset_m.y(), problem.nominal_offset_m.y());
}

}  // namespace
}  // namespace sidestep::dcm::step_qp_test
