// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/problem_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sidestep::mpc::problem_builder_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr int kKnots = 10;
constexpr Tick kStep = 50;
constexpr Tick kForever = std::numeric_limits<Tick>::max() / 4;

MpcParams Params() {
  MpcParams params;
  params.knots = kKnots;
  params.step_s = 0.05;
  return params;
}

RobotModel PointFoot() {
  RobotModel robot;
  robot.mass_kg = 2.0;
  robot.foot_names = {"foot"};
  robot.vertices_m = {Eigen::Matrix3Xd::Zero(3, 1)};
  return robot;
}

PlannedContact Contact(int index, Tick start, Tick end) {
  PlannedContact contact;
  contact.index = index;
  contact.start_tick = start;
  contact.end_tick = end;
  contact.nominal_p_WF = {0.1 * index, 0.02, 0.0};
  contact.adjusted_p_WF = contact.nominal_p_WF + Eigen::Vector3d(0.01, -0.02, 0.0);
  contact.box_lower_m = {-0.1, -0.2, 0.0};
  contact.box_upper_m = {0.3, 0.4, 0.0};
  return contact;
}

class ProblemBuilderTest : public testing::Test {
 protected:
  ProblemBuilderTest() {
    references_.p_WC.setZero(3, kKnots + 1);
    references_.angular_momentum.setZero(3, kKnots + 1);
  }

  /// At `tick`, which is on the grid unless `grid_tick` says otherwise.
  const CentroidalOcp& Build(const std::vector<PlannedContact>& contacts, Tick tick,
                             Tick grid_tick) {
    builder_.Build(state_, {{contacts}, grid_tick}, references_, tick);
    CheckShapes(builder_.ocp());
    return builder_.ocp();
  }

  const CentroidalOcp& Build(const std::vector<PlannedContact>& contacts, Tick tick) {
    return Build(contacts, tick, tick);
  }

  const std::vector<ContactPhase>& Phases(const std::vector<PlannedContact>& contacts, Tick tick) {
    return Build(contacts, tick).contacts[0].phases;
  }

  RobotState state_;
  GridReferences references_;
  ProblemBuilder builder_{Params(), PointFoot(), kTick_s};
};

TEST(ProblemOfARobotTest, LegsAreStretchedByTheirShare) {
  RobotModel robot = PointFoot();
  MpcParams params = Params();
  EXPECT_EQ(ProblemBuilder(params, robot, kTick_s).ocp().contacts[0].leg.length_m, 0.0);
  robot.legs = {{{0.0, 0.01, -0.04}, 0.5}};
  params.leg_stretch = 0.9;
  const CentroidalOcp ocp = ProblemBuilder(params, robot, kTick_s).ocp();
  EXPECT_EQ(ocp.contacts[0].leg.offset_m, robot.legs[0].offset_m);
  EXPECT_DOUBLE_EQ(ocp.contacts[0].leg.length_m, 0.45);
}

TEST(ProblemOfARobotTest, AFootMayBearAShareOfTheWeight) {
  MpcParams params = Params();
  EXPECT_EQ(ProblemBuilder(params, PointFoot(), kTick_s).ocp().weights.foot_load, 0.0) << "off";
  params.weights.foot_load = 3.0;
  params.foot_load_ratio = 1.5;
  RobotModel robot = PointFoot();  // 2 kg
  robot.gravity_mps2 << 0.0, 6.0, -8.0;
  const CentroidalOcp ocp = ProblemBuilder(params, robot, kTick_s).ocp();
  EXPECT_EQ(ocp.weights.foot_load, 3.0);
  EXPECT_DOUBLE_EQ(ocp.foot_load_limit_N, 30.0);
}

TEST_F(ProblemBuilderTest, ScheduleOnTheGridIsSampledExactly) {
  const auto& phases = Phases({Contact(0, 0, 100), Contact(1, 200, 400)}, 50);
  ASSERT_EQ(phases.size(), 2U);
  EXPECT_EQ(phases[0].first_knot, 0);
  EXPECT_EQ(phases[0].end_knot, 1);
  EXPECT_EQ(phases[1].first_knot, 3);
  EXPECT_EQ(phases[1].end_knot, 7);
}

TEST_F(ProblemBuilderTest, ScheduleOnTheGridIsSampledExactlyWheneverTheSolveIs) {
  const Tick grid_tick = 13;
  const std::vector<PlannedContact> contacts = {Contact(0, 0, 163), Contact(1, 313, 463)};
  for (Tick tick = 1; tick < 163; ++tick) {
    const CentroidalOcp& ocp = Build(contacts, tick, grid_tick);
    const auto& phases = ocp.contacts[0].phases;
    ASSERT_EQ(phases.size(), 2U) << tick;
    EXPECT_EQ(phases[0].first_knot, 0) << tick;
    EXPECT_EQ(builder_.grid().TickOf(phases[0].end_knot), 163) << tick;
    EXPECT_EQ(builder_.grid().TickOf(phases[1].first_knot), 313) << tick;
    EXPECT_EQ(builder_.grid().TickOf(phases[1].end_knot), 463) << tick;
    EXPECT_DOUBLE_EQ(ocp.StepAt(0), SecondsAt(builder_.grid().StepAt(0), kTick_s)) << tick;
  }
}

TEST_F(ProblemBuilderTest, SolveOnTheGridHasNoFirstStepOfItsOwn) {
  EXPECT_TRUE(Build({Contact(0, 0, 1000)}, 20, 0).first_step_s.has_value());
  EXPECT_FALSE(Build({Contact(0, 0, 1000)}, 100, 0).first_step_s.has_value());
}

TEST_F(ProblemBuilderTest, EndlessContactOutlastsTheHorizonWheneverTheSolveIs) {
  for (const Tick tick : {100, 101, 149}) {
    const CentroidalOcp& ocp = Build({Contact(0, 0, kForever)}, tick, 0);
    EXPECT_EQ(ocp.contacts[0].phases[0].end_knot, kKnots + 1) << tick;
  }
}

TEST_F(ProblemBuilderTest, ScheduleOffTheGridGoesToTheNearestKnots) {
  const auto& phases = Phases({Contact(1, 120, 230), Contact(2, 325, 376)}, 0);
  ASSERT_EQ(phases.size(), 2U);
  EXPECT_EQ(phases[0].first_knot, 2);  // 2.4
  EXPECT_EQ(phases[0].end_knot, 5);    // 4.6
  EXPECT_EQ(phases[1].first_knot, 7);  // 6.5: halves round up
  EXPECT_EQ(phases[1].end_knot, 8);    // 7.52
}

TEST_F(ProblemBuilderTest, ContactShorterThanTheGridSeesIsLeftOut) {
  EXPECT_EQ(Phases({Contact(1, 124, 160)}, 0).size(), 1U) << "2.48 and 3.2";
  EXPECT_TRUE(Phases({Contact(1, 126, 174)}, 0).empty()) << "2.52 and 3.48 are both 3";
}

TEST_F(ProblemBuilderTest, StanceThatEndsWithinHalfAStepIsLeftOut) {
  EXPECT_TRUE(Phases({Contact(0, 0, 100)}, 80).empty());
  EXPECT_EQ(Phases({Contact(0, 0, 100)}, 70).size(), 1U);
}

TEST_F(ProblemBuilderTest, ContactsBeyondTheHorizonAreLeftOutAndEndlessOnesCut) {
  const auto& phases =
      Phases({Contact(0, 0, 100), Contact(1, 500, kForever), Contact(2, kForever, kForever)}, 0);
  ASSERT_EQ(phases.size(), 2U);
  EXPECT_EQ(phases[1].first_knot, kKnots);
  EXPECT_EQ(phases[1].end_knot, kKnots + 1);
  EXPECT_EQ(Phases({Contact(0, 0, 100), Contact(1, 526, kForever)}, 0).size(), 1U);
}

TEST_F(ProblemBuilderTest, BegunContactIsFixedWhereItStandsAndTheOthersAreFreeInTheirBoxes) {
  const auto& phases = Phases({Contact(3, 100, 200), Contact(4, 300, 400)}, 100);
  ASSERT_EQ(phases.size(), 2U);
  EXPECT_TRUE(phases[0].fixed);
  EXPECT_EQ(phases[0].p_WF, Contact(3, 0, 1).adjusted_p_WF);
  EXPECT_FALSE(phases[1].fixed);
  EXPECT_EQ(phases[1].nominal_p_WF, Contact(4, 0, 1).nominal_p_WF);
  EXPECT_EQ(phases[1].box_lower_m, Contact(4, 0, 1).box_lower_m);
  EXPECT_EQ(phases[1].box_upper_m, Contact(4, 0, 1).box_upper_m);
}

TEST_F(ProblemBuilderTest, ContactThatBeginsWithinHalfAStepIsDownAtOnceButStillFree) {
  const auto& phases = Phases({Contact(1, 110, 300)}, 100);
  ASSERT_EQ(phases.size(), 1U);
  EXPECT_EQ(phases[0].first_knot, 0);
  EXPECT_FALSE(phases[0].fixed);
}

TEST_F(ProblemBuilderTest, PhasesRememberTheirPlannedContactsThroughGaps) {
  Phases({Contact(5, 0, 110), Contact(6, 200, 300), Contact(7, 400, 450)}, 100);
  EXPECT_EQ(builder_.PlannedIndex(0, 0), 6) << "contact 5 is left out";
  EXPECT_EQ(builder_.PlannedIndex(0, 1), 7);
}

TEST_F(ProblemBuilderTest, InitialStateIsTheBeliefsWithMomentumOfTheWholeMass) {
  state_.p_WC = {0.1, 0.2, 0.5};
  state_.v_WC = {0.3, -0.1, 0.4};
  state_.angular_momentum = {0.01, 0.02, 0.03};
  const CentroidalOcp& ocp = Build({Contact(0, 0, 1000)}, 0);
  EXPECT_EQ(ocp.initial_p_WC, state_.p_WC);
  EXPECT_EQ(ocp.initial_linear_momentum, 2.0 * state_.v_WC);
  EXPECT_EQ(ocp.initial_angular_momentum, state_.angular_momentum);
}

TEST_F(ProblemBuilderTest, ReferencesAreHandedOn) {
  references_.p_WC.row(0).setLinSpaced(0.0, 1.0);
  references_.angular_momentum.row(1).setLinSpaced(2.0, 3.0);
  const CentroidalOcp& ocp = Build({Contact(0, 0, 1000)}, 0);
  EXPECT_EQ(ocp.reference_p_WC, references_.p_WC);
  EXPECT_EQ(ocp.reference_angular_momentum, references_.angular_momentum);
}

TEST_F(ProblemBuilderTest, MeasuredWrenchLastsForItsHoldTimeToAFractionOfAKnot) {
  MpcParams params = Params();
  params.external_wrench_hold_s = 0.07;
  builder_ = ProblemBuilder(params, PointFoot(), kTick_s);
  state_.external_wrench.force_N = {10.0, -5.0, 0.0};
  state_.external_wrench.torque_Nm = {0.0, 1.0, 2.0};
  const CentroidalOcp& ocp = Build({Contact(0, 0, 1000)}, 0);
  const Eigen::Vector3d& force_N = state_.external_wrench.force_N;
  EXPECT_LT((ocp.external_force_N.col(0) - force_N).norm(), 1e-12);
  EXPECT_LT((ocp.external_force_N.col(1) - 0.4 * force_N).norm(), 1e-12) << "20 ms of 50";
  EXPECT_EQ(ocp.external_force_N.rightCols(kKnots - 2).norm(), 0.0);
  EXPECT_LT((ocp.external_torque_Nm.col(1) - 0.4 * state_.external_wrench.torque_Nm).norm(), 1e-12);
  const Eigen::Vector3d impulse_Ns = 0.05 * ocp.external_force_N.rowwise().sum();
  EXPECT_LT((impulse_Ns - 0.07 * force_N).norm(), 1e-12);
}

TEST_F(ProblemBuilderTest, MeasuredWrenchLastsForItsHoldTimeFromWithinAKnotToo) {
  MpcParams params = Params();
  params.external_wrench_hold_s = 0.07;
  builder_ = ProblemBuilder(params, PointFoot(), kTick_s);
  state_.external_wrench.force_N = {10.0, -5.0, 0.0};
  for (const Tick tick : {1, 20, 40, 49}) {
    const CentroidalOcp& ocp = Build({Contact(0, 0, 1000)}, tick, 0);
    Eigen::Vector3d impulse_Ns = Eigen::Vector3d::Zero();
    for (int k = 0; k < kKnots; ++k) impulse_Ns += ocp.StepAt(k) * ocp.external_force_N.col(k);
    EXPECT_LT((impulse_Ns - 0.07 * state_.external_wrench.force_N).norm(), 1e-12) << tick;
  }
}

TEST_F(ProblemBuilderTest, WrenchFadesAfterItsHoldTimeByItsTimeConstant) {
  MpcParams params = Params();
  params.external_wrench_hold_s = 0.07;
  params.external_wrench_decay_s = 0.15;
  builder_ = ProblemBuilder(params, PointFoot(), kTick_s);
  state_.external_wrench.force_N = {10.0, -5.0, 0.0};
  const Eigen::Vector3d& force_N = state_.external_wrench.force_N;
  for (const Tick tick : {0, 20, 49}) {
    const CentroidalOcp& ocp = Build({Contact(0, 0, 1000)}, tick, 0);
    Eigen::Vector3d impulse_Ns = Eigen::Vector3d::Zero();
    double horizon_s = 0.0;
    for (int k = 0; k < kKnots; ++k) {
      impulse_Ns += ocp.StepAt(k) * ocp.external_force_N.col(k);
      horizon_s += ocp.StepAt(k);
    }
    // By hand: the hold, and the integral of the rest up to the horizon's end.
    const double share_s = 0.07 + 0.15 * (1.0 - std::exp(-(horizon_s - 0.07) / 0.15));
    EXPECT_LT((impulse_Ns - share_s * force_N).norm(), 1e-12) << tick;
  }
}

TEST_F(ProblemBuilderTest, EachProblemStartsWithoutAPreviousForce) {
  Build({Contact(0, 0, 1000)}, 0);
  builder_.ocp().contacts[0].has_previous_force = true;
  EXPECT_FALSE(Build({Contact(0, 0, 1000)}, 50).contacts[0].has_previous_force);
}

}  // namespace
}  // namespace sidestep::mpc::problem_builder_test
