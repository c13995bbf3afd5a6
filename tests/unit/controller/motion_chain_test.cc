// SPDX-License-Identifier: BSD-3-Clause
#include "controller/motion_chain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "controller/make_stages.h"
#include "controller/mpc/make_solver.h"
#include "controller/mpc/problem/ocp_json.h"
#include "controller/mpc/problem/solver_setup.h"
#include "tests/unit/controller/two_soles.h"

namespace sidestep::motion_chain_test {
namespace {

constexpr double kMass_kg = 10.0;
constexpr double kTick_s = 0.001;

// Two feet with soles of 0.2 m x 0.1 m, 0.2 m apart; the left one is to leave the ground at 0.1 s.
ControllerSetup Walker() {
  ControllerSetup setup;
  setup.tick_s = kTick_s;
  setup.is_centroidal = true;
  setup.robot = TwoSoles(kMass_kg, 0.5);
  GaitParams walk;
  walk.type = GaitType::kWalk;
  walk.step_width_m = 0.2;
  walk.swing_s = 0.3;
  walk.double_support_s = 0.1;
  setup.gait = {walk};
  setup.control.mpc.rate_hz = 20;
  setup.control.mpc.step_s = 0.05;
  setup.control.mpc.knots = 20;
  return setup;
}

RobotState Standing() {
  RobotState state;
  state.p_WC = {0.0, 0.0, 0.5};
  state.feet.resize(2);
  state.feet[0].p_WF = {0.0, 0.1, 0.0};
  state.feet[1].p_WF = {0.0, -0.1, 0.0};
  for (FootState& foot : state.feet) foot.in_contact = true;
  return state;
}

// The chain of that robot, which is believed to stand, moving with `velocity_mps`.
class Chain {
 public:
  explicit Chain(const ControllerSetup& setup = Walker())
      : chain_(setup, PlannedRobot(setup.robot, kMass_kg), StandingRule::kAsScheduled) {}

  // Every tick up to `last`.
  ControlTick RunTo(Tick last, const Eigen::Vector3d& velocity_mps = Eigen::Vector3d::Zero()) {
    RobotState state = Standing();
    state.v_WC = velocity_mps;
    ControlTick told;
    for (; tick_ <= last; ++tick_) {
      chain_.Schedule(state, tick_, &timer_);
      chain_.Plan(state, Eigen::Vector3d::Zero(), tick_, &timer_);
      chain_.TargetFeet(state, tick_, &timer_);
      told.tick = tick_;
      chain_.WriteTo(&told);
      solves_ += told.mpc.ran ? 1 : 0;
    }
    return told;
  }

  int solves() const { return solves_; }
  MotionChain& chain() { return chain_; }

 private:
  StageTimer timer_;
  MotionChain chain_;
  Tick tick_{0};
  int solves_{0};
};

TEST(MotionChainTest, SolvesAtItsRateAndAtTheFirstTick) {
  Chain chain;
  chain.RunTo(0);
  EXPECT_EQ(chain.solves(), 1);
  chain.RunTo(199);
  EXPECT_EQ(chain.solves(), 4);  // at 0, 50, 100 and 150 ms
}

TEST(MotionChainTest, ProblemOfASolveWithinAKnotHasItsOtherKnotsOnTheGait) {
  // At 50 Hz the third solve is at 40 ms: 10 ms before the gait's grid of 50 ms, on which the left
  // foot leaves the ground at 100 ms and lands at 400 ms.
  ControllerSetup setup = Walker();
  setup.control.mpc.rate_hz = 50;
  Chain chain(setup);
  chain.RunTo(59);
  const auto problem = nlohmann::json::parse(chain.chain().LastProblemJson("off the grid"));
  EXPECT_DOUBLE_EQ(problem.at("first_step_s").get<double>(), 0.01);
  const auto& phases = problem.at("contacts").at(0).at("phases");
  EXPECT_EQ(phases.at(0).at("end_knot"), 2);
  EXPECT_EQ(phases.at(1).at("first_knot"), 8);
}

TEST(MotionChainTest, ADumpedProblemSolvesAgainAsItDidInTheLoop) {
  for (const int max_iterations : {100, 2}) {  // the second fails, and must fail again
    ControllerSetup setup = Walker();
    setup.control.mpc.backend = MpcBackend::kStructured;
    setup.control.mpc.max_iterations = max_iterations;
    Chain chain(setup);
    const ControlTick told = chain.RunTo(150, {0.3, 0.1, 0.0});
    ASSERT_TRUE(told.mpc.ran);
    nlohmann::json document = nlohmann::json::parse(chain.chain().LastProblemJson("again"));
    const mpc::CentroidalOcp ocp = mpc::OcpFromJson(document);
    const mpc::SolverSetup how = mpc::SolverSetupFromJson(ocp, document.at("solver"));
    EXPECT_EQ(how.guess.has_value(), max_iterations == 100) << "nothing to begin from but answers";
    const auto solver = mpc::MakeSolver(how.backend, how.options);
    const auto& again = solver->Solve(ocp, how.guess ? &*how.guess : nullptr);
    EXPECT_EQ(again.status, told.mpc.status);
    EXPECT_EQ(again.status == SolveStatus::kIterationLimit, max_iterations == 2);
    EXPECT_EQ(again.iterations, told.mpc.iterations);
    EXPECT_EQ(again.cost, told.mpc.cost);
  }
}

TEST(MotionChainTest, ReferencesAreSampledAtTheKnots) {
  ControllerSetup setup = Walker();
  setup.control.mpc.attitude_rate_radps = 4.0;
  setup.control.mpc.rate_hz = 50;
  MotionChain chain(setup, PlannedRobot(setup.robot, kMass_kg), StandingRule::kAsScheduled);
  const RobotState state = Standing();
  StageTimer timer;
  for (Tick tick = 0; tick <= 40; ++tick) {
    chain.Schedule(state, tick, &timer);
    chain.Plan(state, {1.0, 0.0, 0.0}, tick, &timer);
  }
  const auto problem = nlohmann::json::parse(chain.LastProblemJson("off the grid"));
  const auto& momentum = problem.at("reference").at("angular_momentum");
  const double times_s[] = {0.0, 0.01, 0.06, 0.11};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(momentum.at(k).at(0).get<double>(), std::exp(-4.0 * times_s[k]), 1e-12) << k;
  }
}

TEST(MotionChainTest, FeetThatStandBearTheRobotAndAFootInTheAirNothing) {
  Chain chain;
  const ControlTick both = chain.RunTo(50);
  EXPECT_GT(both.feet[0].force_N.z(), 20.0);
  EXPECT_GT(both.feet[1].force_N.z(), 20.0);
  const ControlTick swing = chain.RunTo(150);
  ASSERT_FALSE(swing.feet[0].planned_contact);
  EXPECT_EQ(swing.feet[0].vertex_force_N.norm(), 0.0);
  EXPECT_GT(swing.feet[1].force_N.z(), 50.0);
}

TEST(MotionChainTest, ForcesAreTheSumOfTheirVertices) {
  Chain chain;
  const ControlTick told = chain.RunTo(10);
  for (const FootTarget& foot : told.feet) {
    EXPECT_LT((foot.force_N - foot.vertex_force_N.rowwise().sum()).norm(), 1e-12);
  }
}

TEST(MotionChainTest, TheFootholdThatThePlanMovedIsWhereTheFootGoes) {
  // Shoved to the left just before the left foot flies: its next foothold moves to the left, in the
  // very tick of the solve.
  Chain chain;
  const ControlTick told = chain.RunTo(100, {0.0, 0.5, 0.0});
  ASSERT_TRUE(told.mpc.ran);
  ASSERT_FALSE(told.feet[0].planned_contact);
  const PlannedContact& next = told.feet[0].contact;
  EXPECT_GT(next.adjusted_p_WF.y(), next.nominal_p_WF.y() + 0.01);
}

TEST(MotionChainTest, WithoutRoomTheFootholdStaysWhereTheGaitWantsIt) {
  ControllerSetup setup = Walker();
  setup.control.mpc.box_lower_m.setZero();
  setup.control.mpc.box_upper_m.setZero();
  const ControlTick told = Chain(setup).RunTo(100, {0.0, 0.5, 0.0});
  const PlannedContact& next = told.feet[0].contact;
  EXPECT_LT((next.adjusted_p_WF - next.nominal_p_WF).norm(), 1e-6);
}

TEST(MotionChainTest, ThePlanStartsAtTheBeliefAndAges) {
  Chain chain;
  const ControlTick fresh = chain.RunTo(50, {0.0, 0.1, 0.0});
  EXPECT_LT((fresh.com.v_WC - Eigen::Vector3d(0.0, 0.1, 0.0)).norm(), 1e-9);
  EXPECT_EQ(fresh.mpc_age_s, 0.0);
  EXPECT_NEAR(chain.RunTo(70).mpc_age_s, 0.02, 1e-12);
}

TEST(MotionChainTest, TheLastProblemIsADocumentOfItsOwnName) {
  Chain chain;
  chain.RunTo(0);
  const auto problem = nlohmann::json::parse(chain.chain().LastProblemJson("shove"));
  EXPECT_EQ(problem.at("name"), "shove");
  EXPECT_EQ(problem.at("mass_kg"), kMass_kg);
}

TEST(MotionChainTest, ACopyGoesOnAsTheOriginalAndDoesNotDisturbIt) {
  Chain straight, original;
  original.RunTo(120, {0.0, 0.3, 0.0});
  Chain copy = original;
  const ControlTick expected = (straight.RunTo(120, {0.0, 0.3, 0.0}), straight.RunTo(260));
  copy.RunTo(200, {0.0, -0.4, 0.0});  // another life
  const ControlTick told = original.RunTo(260);
  for (std::size_t i = 0; i < told.feet.size(); ++i) {
    EXPECT_EQ(told.feet[i].p_WF, expected.feet[i].p_WF);
    EXPECT_EQ(told.feet[i].vertex_force_N, expected.feet[i].vertex_force_N);
    EXPECT_EQ(told.feet[i].contact.adjusted_p_WF, expected.feet[i].contact.adjusted_p_WF);
  }
  EXPECT_EQ(told.com.p_WC, expected.com.p_WC);
}

}  // namespace
}  // namespace sidestep::motion_chain_test
