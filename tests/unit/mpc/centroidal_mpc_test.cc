// SPDX-License-Identifier: BSD-3-Clause
// Which plan is in use when, and what is read from it. The solver itself has tests of its own.
#include "controller/mpc/centroidal_mpc.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sidestep::mpc::centroidal_mpc_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr Tick kStep = 50;
constexpr double kHeight_m = 0.5;
constexpr double kMass_kg = 1.0;
// The dynamics are equality constraints: kept to the solver's tolerance of 1e-6.
constexpr double kSolverTolerance = 1e-5;

MpcParams Params(double latency_s = 0.0) {
  MpcParams params;
  params.rate_hz = 20.0;
  params.knots = 12;
  params.step_s = 0.05;
  params.friction = 0.6;
  params.latency_s = latency_s;
  return params;
}

RobotModel Hopper() {
  RobotModel robot;
  robot.mass_kg = kMass_kg;
  robot.foot_names = {"foot"};
  robot.vertices_m = {Eigen::Matrix3Xd::Zero(3, 1)};
  return robot;
}

/// Stands until tick 150, lands on contact 1 at 300 for good; its box is 0.2 m around the origin.
ContactPlan Hop() {
  PlannedContact stance;
  stance.end_tick = 150;
  PlannedContact landing;
  landing.index = 1;
  landing.start_tick = 300;
  landing.end_tick = 100000;
  landing.box_lower_m = {-0.2, -0.2, 0.0};
  landing.box_upper_m = {0.2, 0.2, 0.0};
  return {{{stance, landing}}};
}

ContactPlan HopIntoAnEmptyBox() {
  ContactPlan plan = Hop();
  plan.feet[0][1].box_lower_m.x() = 0.3;
  return plan;
}

class CentroidalMpcTest : public testing::Test {
 protected:
  CentroidalMpcTest() {
    state_.p_WC = {0.0, 0.0, kHeight_m};
    state_.v_WC = {0.2, 0.0, 0.0};
    references_.p_WC.setZero(3, Params().knots + 1);
    references_.p_WC.row(2).setConstant(kHeight_m);
    references_.angular_momentum.setZero(3, Params().knots + 1);
  }

  void Solve(CentroidalMpc* mpc, const ContactPlan& plan, Tick tick) {
    mpc->Solve(state_, plan, references_, tick);
  }

  RobotState state_;
  GridReferences references_;
};

TEST_F(CentroidalMpcTest, WithoutASolveThereIsNoPlan) {
  CentroidalMpc mpc(Params(), Hopper(), kTick_s);
  EXPECT_FALSE(mpc.Activate(0));
  EXPECT_FALSE(mpc.has_plan());
  EXPECT_FALSE(mpc.report().ran);
  EXPECT_EQ(mpc.Age_s(100), 0.0);
}

TEST_F(CentroidalMpcTest, FirstPlanIsInUseAtOnceDespiteTheLatency) {
  CentroidalMpc mpc(Params(0.03), Hopper(), kTick_s);
  Solve(&mpc, Hop(), 0);
  EXPECT_FALSE(mpc.has_plan()) << "not before Activate";
  EXPECT_TRUE(mpc.Activate(0));
  EXPECT_TRUE(mpc.has_plan());
  EXPECT_TRUE(mpc.report().ran);
  EXPECT_FALSE(mpc.report().fell_back);
  EXPECT_FALSE(mpc.Activate(1)) << "changed once";
}

// Runs solves every 50 ticks and returns the age of the plan in use after each tick's Activate.
std::vector<double> Ages_s(CentroidalMpc* mpc, const RobotState& state,
                           const GridReferences& references) {
  std::vector<double> ages_s;
  for (Tick tick = 0; tick < 500; ++tick) {
    if (tick % kStep == 0) mpc->Solve(state, Hop(), references, tick);
    mpc->Activate(tick);
    ages_s.push_back(mpc->Age_s(tick));
  }
  return ages_s;
}

TEST_F(CentroidalMpcTest, LaterPlansAreInUseOnlyOnceTheyAreAsOldAsTheLatency) {
  // Also with several solutions on their way at once.
  for (const Tick latency : {0, 1, 30, 49, 50, 51, 120}) {
    CentroidalMpc mpc(Params(SecondsAt(latency, kTick_s)), Hopper(), kTick_s);
    const std::vector<double> ages_s = Ages_s(&mpc, state_, references_);
    const double latency_s = SecondsAt(latency, kTick_s);
    for (Tick tick = 0; tick < 500; ++tick) {
      const double age_s = ages_s[static_cast<std::size_t>(tick)];
      const bool first_plan = tick < kStep + latency;
      if (first_plan) {
        ASSERT_NEAR(age_s, SecondsAt(tick, kTick_s), 1e-9) << latency << " at " << tick;
      } else {
        ASSERT_GE(age_s, latency_s - 1e-9) << latency << " at " << tick;
        ASSERT_LT(age_s, latency_s + 0.05 - 1e-9) << latency << " at " << tick;
      }
    }
  }
}

TEST_F(CentroidalMpcTest, FailedSolveLeavesThePlanInUseToBeReadInItsOwnTime) {
  CentroidalMpc kept(Params(), Hopper(), kTick_s);
  CentroidalMpc failed(Params(), Hopper(), kTick_s);
  for (CentroidalMpc* mpc : {&kept, &failed}) {
    Solve(mpc, Hop(), 0);
    mpc->Activate(0);
  }
  Solve(&failed, HopIntoAnEmptyBox(), kStep);
  EXPECT_TRUE(failed.report().ran);
  EXPECT_TRUE(failed.report().fell_back);
  EXPECT_FALSE(IsUsable(failed.report().status));
  EXPECT_FALSE(failed.Activate(kStep));
  for (const Tick tick : {kStep, kStep + 20, 3 * kStep, 8 * kStep}) {
    EXPECT_EQ(failed.ComAt(tick).p_WC, kept.ComAt(tick).p_WC);
    EXPECT_EQ(failed.ForceAt(0, tick), kept.ForceAt(0, tick));
    EXPECT_EQ(failed.Age_s(tick), kept.Age_s(tick));
  }
  Solve(&failed, Hop(), 2 * kStep);
  EXPECT_FALSE(failed.report().fell_back) << "it recovers";
  EXPECT_TRUE(failed.Activate(2 * kStep));
}

TEST_F(CentroidalMpcTest, TooFewIterationsAreAFailureNotAPlan) {
  MpcParams params = Params();
  params.max_iterations = 1;
  CentroidalMpc mpc(params, Hopper(), kTick_s);
  Solve(&mpc, Hop(), 0);
  EXPECT_EQ(mpc.report().status, SolveStatus::kIterationLimit);
  EXPECT_TRUE(mpc.report().fell_back);
  EXPECT_FALSE(mpc.Activate(0));
  EXPECT_FALSE(mpc.has_plan());
}

TEST_F(CentroidalMpcTest, PlanStartsAtTheBelief) {
  CentroidalMpc mpc(Params(), Hopper(), kTick_s);
  Solve(&mpc, Hop(), 0);
  mpc.Activate(0);
  EXPECT_LT((mpc.ComAt(0).p_WC - state_.p_WC).norm(), kSolverTolerance);
  EXPECT_LT((mpc.ComAt(0).v_WC - state_.v_WC).norm(), kSolverTolerance);
}

// A robot whose velocity stays behind the plan's: what the next plan starts from is exp(-age /
// memory) of the way from the belief to the plan, whatever the rate of the solves.
TEST_F(CentroidalMpcTest, ANewPlanRemembersTheVelocityOfTheOld) {
  MpcParams params = Params();
  params.plan_memory_s = 0.1;
  for (const Tick age : {10, 50, 100}) {
    CentroidalMpc mpc(params, Hopper(), kTick_s);
    Solve(&mpc, Hop(), 0);
    mpc.Activate(0);
    const Eigen::Vector3d planned = mpc.ComAt(age).v_WC;
    const Eigen::Vector3d believed = state_.v_WC - Eigen::Vector3d(0.05, 0.02, 0.0);
    RobotState late = state_;
    late.v_WC = believed;
    mpc.Solve(late, Hop(), references_, age);
    mpc.Activate(age);
    const double remembered = std::exp(-SecondsAt(age, kTick_s) / params.plan_memory_s);
    const Eigen::Vector3d expected = believed + remembered * (planned - believed);
    EXPECT_LT((mpc.ComAt(age).v_WC - expected).norm(), kSolverTolerance) << age;
    EXPECT_LT((mpc.ComAt(age).p_WC - late.p_WC).norm(), kSolverTolerance) << "only velocity";
  }
}

TEST_F(CentroidalMpcTest, ComAcceleratesByGravityAndThePlannedForces) {
  CentroidalMpc mpc(Params(), Hopper(), kTick_s);
  Solve(&mpc, Hop(), 0);
  mpc.Activate(0);
  for (const Tick tick : {0, 49, 75, 149, 151, 299, 325, 500}) {
    const Eigen::Vector3d newton =
        Hopper().gravity_mps2 + mpc.ForceAt(0, tick).rowwise().sum() / kMass_kg;
    EXPECT_LT((mpc.ComAt(tick).a_WC - newton).norm(), 1e-3) << tick;  // 1e-5 over T = 0.05 s
    const bool in_flight = tick >= 150 && tick < 300;
    EXPECT_EQ(mpc.ForceAt(0, tick).norm() < 1e-9, in_flight) << tick;
  }
}

TEST_F(CentroidalMpcTest, ComVelocityIsContinuousThroughoutThePlan) {
  CentroidalMpc mpc(Params(), Hopper(), kTick_s);
  Solve(&mpc, Hop(), 0);
  mpc.Activate(0);
  for (Tick tick = 0; tick < 11 * kStep; ++tick) {
    const ComTarget now = mpc.ComAt(tick);
    const Eigen::Vector3d next = now.v_WC + kTick_s * now.a_WC;
    ASSERT_LT((mpc.ComAt(tick + 1).v_WC - next).norm(), kSolverTolerance) << tick;
  }
}

TEST_F(CentroidalMpcTest, AngularMomentumStartsAtTheBeliefAndIsTurnedByThePlannedForces) {
  state_.angular_momentum = {0.01, -0.03, 0.0};
  CentroidalMpc mpc(Params(), Hopper(), kTick_s);
  Solve(&mpc, Hop(), 0);
  mpc.Activate(0);
  EXPECT_LT((mpc.ComAt(0).angular_momentum - state_.angular_momentum).norm(), kSolverTolerance);
  double largest_Nm = 0.0;
  for (Tick tick = 0; tick < 11 * kStep; ++tick) {
    const ComTarget now = mpc.ComAt(tick);
    const Eigen::Vector3d next = now.angular_momentum + kTick_s * now.angular_momentum_rate_Nm;
    ASSERT_LT((mpc.ComAt(tick + 1).angular_momentum - next).norm(), kSolverTolerance) << tick;
    if (tick % kStep != 0 || tick >= 150) continue;  // the lever is the one at the knot
    const Eigen::Vector3d moment_Nm = (-now.p_WC).cross(mpc.ForceAt(0, tick).col(0));  // F at 0
    EXPECT_LT((now.angular_momentum_rate_Nm - moment_Nm).norm(), 1e-3) << tick;
    largest_Nm = std::max(largest_Nm, moment_Nm.norm());
  }
  EXPECT_GT(largest_Nm, 0.01) << "nothing turned";
}

TEST_F(CentroidalMpcTest, PlanOfASolveWithinAKnotChangesContactsOnTheirTicks) {
  for (const Tick solve : {1, 20, 49}) {
    CentroidalMpc mpc(Params(), Hopper(), kTick_s);
    Solve(&mpc, Hop(), solve);
    mpc.Activate(solve);
    for (Tick tick = solve; tick < 500; ++tick) {
      const bool in_flight = tick >= 150 && tick < 300;
      ASSERT_EQ(mpc.ForceAt(0, tick).norm() < 1e-9, in_flight) << solve << " at " << tick;
    }
  }
}

TEST_F(CentroidalMpcTest, PlanOfASolveWithinAKnotStartsAtTheBeliefAndIsContinuous) {
  for (const Tick solve : {1, 20, 49}) {
    CentroidalMpc mpc(Params(), Hopper(), kTick_s);
    Solve(&mpc, Hop(), solve);
    mpc.Activate(solve);
    EXPECT_LT((mpc.ComAt(solve).p_WC - state_.p_WC).norm(), kSolverTolerance) << solve;
    EXPECT_LT((mpc.ComAt(solve).v_WC - state_.v_WC).norm(), kSolverTolerance) << solve;
    const KnotGrid grid = mpc.GridAt(Hop(), solve);
    for (Tick tick = solve; tick < 11 * kStep; ++tick) {
      const ComTarget now = mpc.ComAt(tick), next = mpc.ComAt(tick + 1);
      const Eigen::Vector3d v_WC = now.v_WC + kTick_s * now.a_WC;
      ASSERT_LT((next.v_WC - v_WC).norm(), kSolverTolerance) << solve << " at " << tick;
      const Eigen::Vector3d h = now.angular_momentum + kTick_s * now.angular_momentum_rate_Nm;
      ASSERT_LT((next.angular_momentum - h).norm(), kSolverTolerance) << solve << " at " << tick;
      // The solver's steps are Euler's, ours within a knot are not: a T^2 / 2 at its end.
      const int k = grid.KnotAt(tick);
      const double step_s = SecondsAt(grid.StepAt(k), kTick_s);
      const double euler_s2 = grid.KnotAt(tick + 1) > k ? 0.5 * step_s * step_s : 0.0;
      const Eigen::Vector3d p_WC =
          now.p_WC + kTick_s * now.v_WC + (0.5 * kTick_s * kTick_s - euler_s2) * now.a_WC;
      ASSERT_LT((next.p_WC - p_WC).norm(), kSolverTolerance) << solve << " at " << tick;
    }
  }
}

TEST_F(CentroidalMpcTest, SolveWithinAKnotStartsFromThePlanItIsWithin) {
  for (const Tick later : {1, 20, 49, 51, 99}) {
    CentroidalMpc followed(Params(), Hopper(), kTick_s), fresh(Params(), Hopper(), kTick_s);
    Solve(&followed, Hop(), 0);
    followed.Activate(0);
    const ComTarget com = followed.ComAt(later);
    state_.p_WC = com.p_WC;
    state_.v_WC = com.v_WC;
    Solve(&followed, Hop(), later);
    Solve(&fresh, Hop(), later);
    EXPECT_FALSE(followed.report().fell_back);
    EXPECT_LT(followed.report().iterations, fresh.report().iterations) << later;
  }
}

TEST_F(CentroidalMpcTest, FreeFootholdsAreReportedWithFootAndIndexInTheirBoxes) {
  CentroidalMpc mpc(Params(), Hopper(), kTick_s);
  Solve(&mpc, Hop(), 0);
  mpc.Activate(0);
  ASSERT_EQ(mpc.footholds().size(), 1U) << "the foot that stands is not decided";
  const Foothold& foothold = mpc.footholds()[0];
  EXPECT_EQ(foothold.foot, 0);
  EXPECT_EQ(foothold.index, 1);
  EXPECT_GT(foothold.p_WF.x(), 1e-3) << "a robot that moves forward steps forward";
  EXPECT_LT(foothold.p_WF.x(), 0.2 + kSolverTolerance);
  EXPECT_LT(std::abs(foothold.p_WF.z()), kSolverTolerance);
}

TEST_F(CentroidalMpcTest, FootThatStoodBeforeHasThePreviousForce) {
  CentroidalMpc mpc(Params(), Hopper(), kTick_s);
  Solve(&mpc, Hop(), 0);
  EXPECT_FALSE(mpc.problem().contacts[0].has_previous_force) << "nothing came before";
  mpc.Activate(0);
  const Eigen::Matrix3Xd before_N = mpc.ForceAt(0, kStep - 1);
  Solve(&mpc, Hop(), kStep);
  EXPECT_TRUE(mpc.problem().contacts[0].has_previous_force);
  EXPECT_EQ(mpc.problem().contacts[0].previous_force_N, before_N);
}

TEST_F(CentroidalMpcTest, FootThatStandsWithinAKnotHasTheForceOfThatKnotBefore) {
  CentroidalMpc mpc(Params(), Hopper(), kTick_s);
  Solve(&mpc, Hop(), 20);
  mpc.Activate(20);
  for (const Tick tick : {30, 50, 51, 70}) {  // 20 to 50 is one knot, 50 to 100 the next
    const Eigen::Matrix3Xd before_N = mpc.ForceAt(0, tick > 50 ? 50 : 20);
    EXPECT_EQ(mpc.ForceAt(0, tick - 1), before_N) << tick;
    Solve(&mpc, Hop(), tick);  // not taken into use
    ASSERT_TRUE(mpc.problem().contacts[0].has_previous_force) << tick;
    EXPECT_EQ(mpc.problem().contacts[0].previous_force_N, before_N) << tick;
  }
}

TEST_F(CentroidalMpcTest, FootThatFlewOrFliesHasNoPreviousForce) {
  CentroidalMpc mpc(Params(), Hopper(), kTick_s);
  Solve(&mpc, Hop(), 0);
  mpc.Activate(0);
  Solve(&mpc, Hop(), 200);
  EXPECT_FALSE(mpc.problem().contacts[0].has_previous_force) << "in flight";
  mpc.Activate(200);
  Solve(&mpc, Hop(), 300);
  EXPECT_FALSE(mpc.problem().contacts[0].has_previous_force) << "it lands now";
  mpc.Activate(300);
  Solve(&mpc, Hop(), 350);
  EXPECT_TRUE(mpc.problem().contacts[0].has_previous_force) << "it stands since 50 ticks";
}

}  // namespace
}  // namespace sidestep::mpc::centroidal_mpc_test
