// SPDX-License-Identifier: BSD-3-Clause
// The whole chain on the hopper (torque) and iCub3 (position), standing at home on the plant.
#include "controller/locomotion_controller.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "models/support/require.h"
#include "sim/episode/episode.h"
#include "sim/scenario/read_scenario.h"
#include "sim/world/make_world.h"
#include "tests/support/stage_log.h"

namespace sidestep::locomotion_controller_test {
namespace {

using Eigen::Vector3d;

// A shipped scenario's robot, on its sensors without errors.
Scenario Errorless(const std::string& file) {
  Scenario scenario =
      ReadScenario(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios" / file, {});
  scenario.sensors = {};
  return scenario;
}

// A robot that stands at home, its plant and sensors, in a loop with a controller.
class Stander {
 public:
  explicit Stander(const Scenario& scenario)
      : step_s_(scenario.world.step_s),
        period_(TickAt(1.0 / scenario.control.rate_hz, step_s_)),
        world_(MakeWorld(scenario)),
        sensors_(MakeSensorSuite(scenario, world_->mass_kg())) {}

  /// What its sensors read now.
  SensorFrame Read() { return sensors_.Read(world_->truth(), tick_); }

  /// Carries `command` out until the next control tick.
  void Follow(const ActuatorCommand& command) {
    world_->Apply(command);
    for (Tick i = 0; i < period_; ++i) {
      world_->Step(tick_++);
      sensors_.Accumulate(world_->truth());
    }
  }

  /// `ticks` control ticks, the last of which is told. Its command has not been carried out.
  const ControlTick& Run(int ticks, Controller* controller) {
    for (int i = 1; i < ticks; ++i) Follow(controller->Update(Read()).command);
    return controller->Update(Read());
  }

  const WorldTruth& truth() const { return world_->truth(); }
  double mass_kg() const { return world_->mass_kg(); }

 private:
  double step_s_;
  Tick period_;
  std::unique_ptr<World> world_;
  SensorSuite sensors_;
  Tick tick_{0};
};

class LocomotionControllerTest : public testing::TestWithParam<const char*> {
 protected:
  const Scenario scenario_{Errorless(GetParam())};
  StageLog log_;
  Stander robot_{scenario_};
  LocomotionController controller_{SetupOf(scenario_), &log_};
};

INSTANTIATE_TEST_SUITE_P(Robots, LocomotionControllerTest,
                         testing::Values("hopper_hop.yaml", "icub_stand.yaml"));

TEST_P(LocomotionControllerTest, CommandsWhatItsModeAsksForAndNothingElse) {
  const ActuatorCommand& command = robot_.Run(1, &controller_).command;
  const Eigen::Index joints = robot_.truth().joint_position.size();
  const bool by_torque = scenario_.control.mode == ControlMode::kTorque;
  EXPECT_EQ(command.torque_Nm.size(), by_torque ? joints : 0);
  EXPECT_EQ(command.joint_position.size(), by_torque ? 0 : joints);
  EXPECT_EQ(command.joint_velocity.size(), by_torque ? 0 : joints);
  EXPECT_TRUE(command.centroidal_feet.empty());
}

TEST_P(LocomotionControllerTest, BelievesToStandAtHomeWhereItIs) {
  // At most 2 mm: soles sink into the floor by as much until they bear the weight.
  const RobotState& belief = robot_.Run(20, &controller_).state;
  EXPECT_LT((belief.p_WB - robot_.truth().p_WB).norm(), 0.002);
  EXPECT_LT(belief.q_WB.angularDistance(robot_.truth().q_WB), 0.002);
  EXPECT_LT((belief.p_WC - robot_.truth().p_WC).norm(), 0.002);
  EXPECT_EQ(belief.joint_position, robot_.truth().joint_position);
  for (std::size_t i = 0; i < belief.feet.size(); ++i) {
    EXPECT_TRUE(belief.feet[i].in_contact) << i;
    EXPECT_LT((belief.feet[i].p_WF - robot_.truth().feet[i].p_WF).norm(), 0.002) << i;
  }
}

TEST_P(LocomotionControllerTest, EveryLinkSucceedsAndItsForcesBearTheWeight) {
  const ControlTick& told = robot_.Run(1, &controller_);
  EXPECT_TRUE(told.mpc.ran);
  EXPECT_TRUE(IsUsable(told.mpc.status)) << EnumName(told.mpc.status);
  EXPECT_FALSE(told.mpc.fell_back);
  EXPECT_TRUE(told.wbc.ok);
  double vertical_N = 0.0;
  for (const FootTarget& foot : told.feet) {
    EXPECT_TRUE(foot.planned_contact);
    vertical_N += foot.force_N.z();
  }
  // Home is within some mm of the reference's height: the CoM needs no more than 2 m/s^2.
  EXPECT_NEAR(vertical_N, kGravity_mps2 * robot_.mass_kg(), 2.0 * robot_.mass_kg());
}

TEST_P(LocomotionControllerTest, ReportsItsStagesInTheOrderOfTheChain) {
  const ControlTick& told = robot_.Run(1, &controller_);
  EXPECT_EQ(log_.events(),
            StageLog::OneAfterAnother({Stage::kEstimator, Stage::kPlanner, Stage::kMpc,
                                       Stage::kSwing, Stage::kWholeBody}));
  robot_.Follow(told.command);
  log_.Clear();
  robot_.Run(1, &controller_);
  EXPECT_EQ(log_.events(), StageLog::OneAfterAnother({Stage::kEstimator, Stage::kPlanner,
                                                      Stage::kSwing, Stage::kWholeBody}))
      << "no solve";
}

TEST_P(LocomotionControllerTest, ACloneGoesOnBitForBitAndReportsToItsOwnTimer) {
  auto original = std::make_unique<LocomotionController>(SetupOf(scenario_), &log_);
  for (int i = 0; i < 15; ++i) {
    const SensorFrame frame = robot_.Read();
    original->Update(frame);
    robot_.Follow(controller_.Update(frame).command);
  }
  StageLog own;
  const std::unique_ptr<Controller> clone = original->Clone(&own);
  SensorFrame wild = robot_.Read();
  for (int i = 0; i < 15; ++i) {  // the original goes its own way, and away
    wild.joint_velocity.array() += 0.1;
    original->Update(wild);
  }
  original.reset();
  EXPECT_TRUE(own.events().empty());
  int solves = 0;
  for (int i = 0; i < 30; ++i) {
    const SensorFrame frame = robot_.Read();
    log_.Clear();
    const ControlTick& expected = controller_.Update(frame);
    const std::vector<StageLog::Event> stages = log_.events();
    own.Clear();
    const ControlTick& told = clone->Update(frame);
    ASSERT_EQ(told.command.torque_Nm, expected.command.torque_Nm) << i;
    ASSERT_EQ(told.command.joint_position, expected.command.joint_position) << i;
    ASSERT_EQ(told.command.joint_velocity, expected.command.joint_velocity) << i;
    ASSERT_EQ(told.state.p_WB, expected.state.p_WB) << i;
    ASSERT_EQ(told.com.a_WC, expected.com.a_WC) << i;
    ASSERT_EQ(own.events(), stages);
    ASSERT_EQ(log_.events(), stages) << "the clone reports to nobody else";
    solves += told.mpc.ran ? 1 : 0;
    robot_.Follow(expected.command);
  }
  EXPECT_GT(solves, 0) << "else nothing of the MPC's memory was seen";
  EXPECT_EQ(clone->LastProblemJson("stand"), controller_.LastProblemJson("stand"));
}

TEST_P(LocomotionControllerTest, TheLastProblemBearsItsNameAndTheModelsMass) {
  robot_.Run(1, &controller_);
  const auto problem = nlohmann::json::parse(controller_.LastProblemJson("by_name"));
  EXPECT_EQ(problem.at("name"), "by_name");
  EXPECT_NEAR(problem.at("mass_kg").get<double>(), robot_.mass_kg(), 1e-9);
  EXPECT_EQ(problem.at("contacts").size(), scenario_.robot.feet.size());
}

TEST(LocomotionControllerOnHopperTest, ItsLegPushesTheRobotUpAndItsHipsRest) {
  // The leg's slide lengthens it: against the weight of all above the shank (1 kg less 0.03 kg) it
  // pushes with + 9.5 N at rest. That needs the CoM where it is asked to be.
  Scenario scenario = Errorless("hopper_hop.yaml");
  scenario.gait.resize(1);  // to stand
  StageLog log;
  Stander robot(scenario);
  LocomotionController controller(SetupOf(scenario), &log);
  const ControlTick& told = robot.Run(200, &controller);
  EXPECT_NEAR(told.command.torque_Nm[2], (1.0 - 0.03) * kGravity_mps2, 0.5);
  EXPECT_LT(told.command.torque_Nm.head<2>().norm(), 0.05);
}

TEST(LocomotionControllerOnIcubTest, AtHomeItsReferencesAreHomeAndBarelyMove) {
  const Scenario scenario = Errorless("icub_stand.yaml");
  StageLog log;
  Stander robot(scenario);
  LocomotionController controller(SetupOf(scenario), &log);
  RobotState home;
  RigidBody(scenario.robot).WriteHome(&home);
  const ControlTick& told = robot.Run(1, &controller);
  EXPECT_LT((told.command.joint_position - home.joint_position).lpNorm<Eigen::Infinity>(), 0.05)
      << "within what the servos give way under the weight";
  EXPECT_GT(told.command.joint_position.norm(), 0.1) << "home is not zero";
  EXPECT_LT(told.command.joint_velocity.lpNorm<Eigen::Infinity>(), 0.5);
}

// Reference of the angular momentum at the first knot, of the hopper at home but rolled by
// `roll_rad` to its right.
Vector3d PlannedMomentum(double roll_rad, double rate_radps) {
  Scenario scenario = Errorless("hopper_hop.yaml");
  scenario.control.estimator = EstimatorKind::kTruth;
  scenario.control.mpc.attitude_rate_radps = rate_radps;
  StageLog log;
  LocomotionController controller(SetupOf(scenario), &log);
  SensorFrame frame = Stander(scenario).Read();
  frame.truth->q_WB = Eigen::AngleAxisd(roll_rad, Vector3d::UnitX());
  controller.Update(frame);
  const auto problem = nlohmann::json::parse(controller.LastProblemJson("tilted"));
  const auto first = problem.at("reference").at("angular_momentum")[0];
  return {first[0].get<double>(), first[1].get<double>(), first[2].get<double>()};
}

TEST(LocomotionControllerOnHopperTest, ATiltedBaseIsToldToTurnBack) {
  // h = - I k theta about x, with the inertia of the whole robot about the hip: of the trunk
  // 0.017 + 0.84 * 0.02^2, and of a leg 0.4 m long with 0.1 kg near its middle, a few gm^2.
  const Vector3d momentum = PlannedMomentum(0.1, 4.0);
  EXPECT_LT(momentum.x(), -0.1 * 4.0 * 0.0173);
  EXPECT_GT(momentum.x(), -0.1 * 4.0 * 0.030);
  EXPECT_NEAR(momentum.y(), 0.0, 1e-12);
  EXPECT_LT((PlannedMomentum(-0.1, 4.0) + momentum).norm(), 1e-12) << "the other way";
  EXPECT_LT((PlannedMomentum(0.1, 8.0) - 2.0 * momentum).norm(), 1e-12) << "twice as fast";
}

TEST(LocomotionControllerOnHopperTest, AnUprightBaseAndARateOfZeroAskForNoMomentum) {
  EXPECT_LT(PlannedMomentum(0.0, 4.0).norm(), 1e-12);
  EXPECT_EQ(PlannedMomentum(0.1, 0.0).norm(), 0.0);
}

TEST(LocomotionControllerOnHopperTest, WithoutTheTruthItIsToldToBelieveItRefuses) {
  Scenario scenario = Errorless("hopper_hop.yaml");
  SensorFrame frame = Stander(scenario).Read();
  ASSERT_FALSE(frame.truth.has_value()) << "only where the scenario permits it";
  scenario.control.estimator = EstimatorKind::kTruth;
  StageLog log;
  LocomotionController controller(SetupOf(scenario), &log);
  EXPECT_THROW(controller.Update(frame), ContractViolation);
}

}  // namespace
}  // namespace sidestep::locomotion_controller_test
