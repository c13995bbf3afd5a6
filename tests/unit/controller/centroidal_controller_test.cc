// SPDX-License-Identifier: BSD-3-Clause
#include "controller/centroidal_controller.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "models/support/require.h"
#include "tests/support/stage_log.h"

namespace sidestep::centroidal_controller_test {
namespace {

using Eigen::Vector3d;

constexpr double kMass_kg = 10.0;
constexpr double kWeight_N = kMass_kg * kGravity_mps2;

// Two feet with soles of 0.2 m x 0.1 m, 0.2 m apart, that walk in place: the left one flies from
// 0.1 s to 0.4 s.
ControllerSetup Walker() {
  ControllerSetup setup;
  setup.is_centroidal = true;
  setup.robot.mass_kg = kMass_kg;
  setup.robot.com_height_m = 0.5;
  Eigen::Matrix3Xd corners_m(3, 4);
  corners_m << 0.1, 0.1, -0.1, -0.1, 0.05, -0.05, -0.05, 0.05, 0, 0, 0, 0;
  setup.robot.feet = {{"left", "left_sole", {}, corners_m, 0.0},
                      {"right", "right_sole", {}, corners_m, 0.0}};
  GaitParams walk;
  walk.type = GaitType::kWalk;
  walk.step_width_m = 0.2;
  walk.swing_s = 0.3;
  walk.double_support_s = 0.1;
  setup.gait = {walk};
  setup.control.rate_hz = 1000.0;
  setup.control.mpc.rate_hz = 20.0;
  setup.control.mpc.step_s = 0.05;
  setup.control.mpc.knots = 12;
  return setup;
}

// What the plant measures of it at rest, the weight on both feet.
SensorFrame Standing(Tick tick) {
  SensorFrame frame;
  frame.tick = tick;
  frame.feet = {{0.5 * kWeight_N}, {0.5 * kWeight_N}};
  CentroidalSample sample;
  sample.p_WC = {0.0, 0.0, 0.5};
  sample.p_WF = {{0.0, 0.1, 0.0}, {0.0, -0.1, 0.0}};
  frame.centroidal = sample;
  return frame;
}

SensorFrame Moving(Tick tick, const Vector3d& linear_momentum) {
  SensorFrame frame = Standing(tick);
  frame.centroidal->linear_momentum = linear_momentum;
  return frame;
}

Vector3d SumOfForces(const ActuatorCommand& command) {
  Vector3d sum_N = Vector3d::Zero();
  for (const CentroidalFootCommand& foot : command.centroidal_feet) {
    sum_N += foot.force_N.rowwise().sum();
  }
  return sum_N;
}

// The controller with its timer; every tick up to one that is told.
class CentroidalControllerTest : public testing::Test {
 protected:
  explicit CentroidalControllerTest(const ControllerSetup& setup = Walker())
      : setup_(setup), controller_(setup, &log_) {}

  const ControlTick& StandTo(Tick last) {
    for (; tick_ < last; ++tick_) controller_.Update(Standing(tick_));
    return controller_.Update(Standing(tick_++));
  }

  static void ExpectSame(const ControlTick& a, const ControlTick& b) {
    EXPECT_EQ(a.com.p_WC, b.com.p_WC);
    EXPECT_EQ(a.reference.p_WC, b.reference.p_WC);
    ASSERT_EQ(a.command.centroidal_feet.size(), b.command.centroidal_feet.size());
    for (std::size_t i = 0; i < a.command.centroidal_feet.size(); ++i) {
      EXPECT_EQ(a.command.centroidal_feet[i].p_WF, b.command.centroidal_feet[i].p_WF);
      EXPECT_EQ(a.command.centroidal_feet[i].force_N, b.command.centroidal_feet[i].force_N);
      EXPECT_EQ(a.command.centroidal_feet[i].in_contact, b.command.centroidal_feet[i].in_contact);
    }
  }

  StageLog log_;
  ControllerSetup setup_;
  CentroidalController controller_;
  Tick tick_{0};
};

TEST_F(CentroidalControllerTest, CommandsForcesAndFeetAndNoJoints) {
  const ActuatorCommand& command = StandTo(0).command;
  EXPECT_EQ(command.torque_Nm.size(), 0);
  EXPECT_EQ(command.joint_position.size(), 0);
  ASSERT_EQ(command.centroidal_feet.size(), 2U);
  for (const CentroidalFootCommand& foot : command.centroidal_feet) {
    EXPECT_TRUE(foot.in_contact);
    EXPECT_EQ(foot.force_N.cols(), 4);
  }
}

TEST_F(CentroidalControllerTest, AskedToStandWhereItStandsEveryVertexBearsAnEighthOfTheWeight) {
  // The optimum by hand: that motion and those forces cost nothing.
  setup_.gait.front().type = GaitType::kStand;
  CentroidalController stands(setup_, &log_);
  const ActuatorCommand command = stands.Update(Standing(0)).command;
  for (const CentroidalFootCommand& foot : command.centroidal_feet) {
    for (Eigen::Index j = 0; j < 4; ++j) {
      EXPECT_LT((foot.force_N.col(j) - Vector3d(0.0, 0.0, kWeight_N / 8.0)).norm(), 1e-3);
    }
  }
}

TEST_F(CentroidalControllerTest, AFootThatFliesBearsNothingAndTheOtherMostOfTheWeight) {
  const ActuatorCommand& command = StandTo(250).command;  // the middle of the left foot's swing
  EXPECT_FALSE(command.centroidal_feet[0].in_contact);
  EXPECT_EQ(command.centroidal_feet[0].force_N.norm(), 0.0);
  EXPECT_GT(command.centroidal_feet[0].p_WF.z(), 0.01) << "in the air";
  EXPECT_TRUE(command.centroidal_feet[1].in_contact);
  // Not all of the weight: beside the foot it falls a little, for which it rose on both feet.
  EXPECT_GT(command.centroidal_feet[1].force_N.row(2).sum(), 0.7 * kWeight_N);
}

TEST_F(CentroidalControllerTest, BelievesWhatThePlantMeasures) {
  SensorFrame frame = Moving(0, {5.0, -3.0, 1.0});
  frame.centroidal->angular_momentum = {0.1, 0.2, -0.3};
  frame.feet[1].normal_force_N = setup_.control.estimation.contact_threshold_N;  // not above it
  const RobotState& state = controller_.Update(frame).state;
  EXPECT_LT((state.v_WC - Vector3d(0.5, -0.3, 0.1)).norm(), 1e-15) << "momentum by mass";
  EXPECT_EQ(state.angular_momentum, frame.centroidal->angular_momentum);
  EXPECT_EQ(state.feet[1].p_WF, frame.centroidal->p_WF[1]);
  EXPECT_TRUE(state.feet[0].in_contact);
  EXPECT_FALSE(state.feet[1].in_contact);
}

TEST_F(CentroidalControllerTest, MovingToOneSideItPushesToTheOther) {
  const double to_left_N = SumOfForces(controller_.Update(Moving(0, {0.0, -2.0, 0.0})).command).y();
  CentroidalController other(setup_, &log_);
  const double to_right_N = SumOfForces(other.Update(Moving(0, {0.0, 2.0, 0.0})).command).y();
  EXPECT_GT(to_left_N, 1.0);
  EXPECT_LT(to_right_N, -1.0);
}

TEST_F(CentroidalControllerTest, AFrameWithoutTheReducedStateBreaksItsContract) {
  SensorFrame frame = Standing(0);
  frame.centroidal.reset();
  EXPECT_THROW(controller_.Update(frame), ContractViolation);
}

SensorFrame Pushed(Tick tick) {
  SensorFrame frame = Standing(tick);
  frame.known_external_wrench = Wrench{{0.0, 20.0, 0.0}, {0.0, 0.0, 0.5}};
  return frame;
}

TEST_F(CentroidalControllerTest, APushThatItKnowsIsPlannedAgainst) {
  setup_.control.external_wrench = ExternalWrenchKnowledge::kKnown;
  CentroidalController knows(setup_, &log_);
  const double unpushed_N = SumOfForces(StandTo(0).command).y();
  const ControlTick& told = knows.Update(Pushed(0));
  EXPECT_EQ(told.state.external_wrench.force_N, Vector3d(0.0, 20.0, 0.0));
  EXPECT_EQ(told.state.external_wrench.torque_Nm, Vector3d(0.0, 0.0, 0.5));
  EXPECT_LT(SumOfForces(told.command).y(), unpushed_N - 5.0) << "a quarter of it at least";
}

TEST_F(CentroidalControllerTest, APushThatItMustNotKnowChangesNoBit) {
  ASSERT_EQ(setup_.control.external_wrench, ExternalWrenchKnowledge::kUnknown);
  CentroidalController pushed(setup_, &log_);
  const ControlTick& told = pushed.Update(Pushed(0));
  EXPECT_EQ(told.state.external_wrench.force_N.norm(), 0.0);
  ExpectSame(told, StandTo(0));
}

TEST_F(CentroidalControllerTest, ReportsItsStagesInTheOrderOfTheChain) {
  StandTo(0);
  EXPECT_EQ(log_.events(),
            StageLog::OneAfterAnother({Stage::kEstimator, Stage::kPlanner, Stage::kMpc,
                                       Stage::kSwing, Stage::kWholeBody}));
  log_.Clear();
  StandTo(1);
  EXPECT_EQ(log_.events(), StageLog::OneAfterAnother({Stage::kEstimator, Stage::kPlanner,
                                                      Stage::kSwing, Stage::kWholeBody}))
      << "no solve";
}

TEST_F(CentroidalControllerTest, ACloneGoesOnBitForBitAndReportsToItsOwnTimer) {
  auto original = std::make_unique<CentroidalController>(setup_, &log_);
  CentroidalController never_copied(setup_, &log_);
  for (Tick tick = 0; tick < 130; ++tick) {
    const SensorFrame frame = Moving(tick, {0.0, 1e-2 * static_cast<double>(tick), 0.0});
    original->Update(frame);
    never_copied.Update(frame);
  }
  StageLog own;
  const std::unique_ptr<Controller> clone = original->Clone(&own);
  for (Tick tick = 130; tick < 160; ++tick) original->Update(Moving(tick, {3.0, -3.0, 0.0}));
  original.reset();
  EXPECT_TRUE(own.events().empty());
  for (Tick tick = 130; tick < 260; ++tick) {
    const SensorFrame frame = Moving(tick, {0.1, -5e-3 * static_cast<double>(tick), 0.0});
    log_.Clear();
    const ControlTick& expected = never_copied.Update(frame);
    const std::vector<StageLog::Event> stages = log_.events();
    own.Clear();
    ExpectSame(clone->Update(frame), expected);
    ASSERT_EQ(own.events(), stages);
    ASSERT_EQ(log_.events(), stages) << "the clone reports to nobody else";
  }
  EXPECT_EQ(clone->LastProblemJson("shove"), never_copied.LastProblemJson("shove"));
}

TEST_F(CentroidalControllerTest, TheLastProblemBearsItsNameAndTheBeliefOfItsSolve) {
  controller_.Update(Moving(0, {0.0, 4.0, 0.0}));
  controller_.Update(Moving(1, {0.0, 6.0, 0.0}));  // no solve: not of this tick
  const auto problem = nlohmann::json::parse(controller_.LastProblemJson("by_name"));
  EXPECT_EQ(problem.at("name"), "by_name");
  EXPECT_EQ(problem.at("mass_kg"), kMass_kg);
  EXPECT_NEAR(problem.at("initial").at("linear_momentum")[1].get<double>(), 4.0, 1e-14);
  EXPECT_EQ(problem.at("contacts").size(), 2U);
  for (const auto& momentum : problem.at("reference").at("angular_momentum")) {
    EXPECT_EQ(momentum, nlohmann::json::array({0.0, 0.0, 0.0})) << "it has no attitude to level";
  }
}

TEST_F(CentroidalControllerTest, TheSettingComSwayReachesItsReference) {
  // In the middle of the first swing, over 0.8 of the way to the right foot, 0.1 m aside.
  setup_.control.planner.sway.share = 0.8;
  setup_.control.mpc.rate_hz = 2.0;
  CentroidalController swaying(setup_, &log_);
  Vector3d reference = Vector3d::Zero();
  for (Tick tick = 0; tick <= 250; ++tick)
    reference = swaying.Update(Standing(tick)).reference.p_WC;
  EXPECT_LT((reference - Vector3d(0.0, -0.08, 0.5)).norm(), 1e-12);
  EXPECT_LT((StandTo(250).reference.p_WC - Vector3d(0.0, 0.0, 0.5)).norm(), 1e-12);
}

}  // namespace
}  // namespace sidestep::centroidal_controller_test
