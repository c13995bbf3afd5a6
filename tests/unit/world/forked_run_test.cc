// SPDX-License-Identifier: BSD-3-Clause
// Runs that are forked in the middle: world and sensors copied at random ticks, between a command
// and the next, go on bit for bit as the originals do. The controllers are laws without memory.
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <random>
#include <set>
#include <vector>

#include "sim/scenario/read_scenario.h"
#include "sim/sensors/sensor_suite.h"
#include "sim/world/make_world.h"
#include "tests/support/all_numbers.h"
#include "tests/support/box_biped.h"
#include "tests/support/hopper_scenario.h"
#include "tests/support/temp_folder.h"
#include "tests/unit/world/centroidal_test_support.h"

namespace sidestep::forked_run_test {
namespace {

constexpr Tick kControlPeriod = 5;
constexpr std::size_t kNumForks = 8;

using Law = std::function<ActuatorCommand(const SensorFrame&)>;

/// A world, its sensors and the last frame; a law that is a pure function of the frame.
class Loop {
 public:
  Loop(const Scenario& scenario, Law law)
      : world_(MakeWorld(scenario)),
        sensors_(MakeSensorSuite(scenario, world_->mass_kg())),
        law_(std::move(law)) {}
  Loop(const Loop& other)
      : world_(other.world_->Clone()),
        sensors_(other.sensors_),
        law_(other.law_),
        frame_(other.frame_) {}

  const WorldTruth& truth() const { return world_->truth(); }
  void SetLaw(Law law) { law_ = std::move(law); }

  /// One tick. Returns all that there is to see after it: truth and last frame.
  Numbers Step(Tick tick) {
    if (tick % kControlPeriod == 0) {
      frame_ = sensors_.Read(world_->truth(), tick);
      world_->Apply(law_(frame_));
    }
    world_->Step(tick);
    sensors_.Accumulate(world_->truth());
    Numbers seen = AllNumbers(world_->truth());
    const Numbers frame = AllNumbers(frame_);
    seen.insert(seen.end(), frame.begin(), frame.end());
    return seen;
  }

 private:
  std::unique_ptr<World> world_;
  SensorSuite sensors_;
  Law law_;
  SensorFrame frame_;
};

struct Fork {
  Tick tick{0};
  Loop loop;
};

std::set<Tick> RandomTicks(Tick end) {
  std::mt19937_64 random(7);
  std::set<Tick> ticks;
  while (ticks.size() < kNumForks) {
    ticks.insert(static_cast<Tick>(random() % static_cast<std::uint64_t>(end)));
  }
  return ticks;
}

/// Forks `loop` at random ticks; each fork must see what the original saw, tick for tick. Returns
/// what it saw.
std::vector<Numbers> ExpectForksGoOnAlike(Loop loop, Tick end) {
  const std::set<Tick> fork_at = RandomTicks(end);
  std::vector<Fork> forks;
  std::vector<Numbers> seen;
  for (Tick tick = 0; tick < end; ++tick) {
    if (fork_at.contains(tick)) forks.push_back({tick, loop});
    seen.push_back(loop.Step(tick));
  }
  for (Fork& fork : forks) {
    for (Tick tick = fork.tick; tick < end; ++tick) {
      if (SameBits(fork.loop.Step(tick), seen[static_cast<std::size_t>(tick)])) continue;
      ADD_FAILURE() << "fork of tick " << fork.tick << " is another at tick " << tick;
      break;
    }
  }
  return seen;
}

/// Steps a fork under another law between the steps of its original, which must see what it saw
/// alone; that the fork sees something else shows that a difference would be noticed.
void ExpectForkLeavesItsOriginalAlone(Loop loop, const Law& other_law, Tick fork_at,
                                      const std::vector<Numbers>& alone) {
  const Tick end = static_cast<Tick>(alone.size());
  for (Tick tick = 0; tick < fork_at; ++tick) loop.Step(tick);
  Loop fork = loop;
  fork.SetLaw(other_law);
  bool differs = false;
  for (Tick tick = fork_at; tick < end; ++tick) {
    const Numbers& expected = alone[static_cast<std::size_t>(tick)];
    differs = !SameBits(fork.Step(tick), expected) || differs;
    ASSERT_TRUE(SameBits(loop.Step(tick), expected)) << tick;
  }
  EXPECT_TRUE(differs);
}

/// Every error that sensors can have.
SensorParams BadSensors() {
  SensorParams sensors;
  sensors.gyro_noise_radps = 0.01;
  sensors.accelerometer_noise_mps2 = 0.2;
  sensors.orientation_noise_rad = 0.002;
  sensors.encoder_noise_rad = 0.001;
  sensors.encoder_velocity_noise_radps = 0.05;
  sensors.touch_noise_N = 0.3;
  sensors.force_noise_N = 0.7;
  sensors.torque_noise_Nm = 0.04;
  sensors.delay_s = 0.01;
  sensors.wrench_delay_s = 0.005;
  sensors.dropout = 0.2;
  sensors.encoder_bias_rad = 0.001;
  return sensors;
}

/// Springs and dampers on the joints that the sensors tell of.
Law HopperSprings(double leg_home_m) {
  return [leg_home_m](const SensorFrame& frame) {
    const Eigen::Vector3d home(0.0, 0.0, leg_home_m), stiffness(50.0, 50.0, 2000.0),
        damping(2.0, 2.0, 40.0);
    ActuatorCommand command;
    command.torque_Nm = stiffness.cwiseProduct(home - Eigen::Vector3d(frame.joint_position)) -
                        damping.cwiseProduct(Eigen::Vector3d(frame.joint_velocity));
    return command;
  };
}

TEST(ForkedRunTest, PushedHopperOnNoisyLateSensors) {
  Scenario scenario = HoppingHopper();
  scenario.sensors = BadSensors();
  scenario.control.rate_hz = 1.0 / (kControlPeriod * scenario.world.step_s);
  Push push = TrunkPush({3.0, 6.0, 0.0}, 0.1, 0.9, {0.02, 0.03, 0.1});
  push.frame = PushFrame::kHeading;  // which the world remembers from the push's start
  push.profile = PushProfile::kHalfSine;
  scenario.pushes = {push};
  const Loop loop(scenario, HopperSprings(0.15));
  const std::vector<Numbers> seen = ExpectForksGoOnAlike(loop, 1200);
  ExpectForkLeavesItsOriginalAlone(loop, HopperSprings(0.14), 333, seen);
}

TEST(ForkedRunTest, BoxBipedPushedOffItsFeet) {
  const TempFolder folder;
  Scenario scenario = BoxBipedScenario(folder);
  scenario.sensors = BadSensors();
  scenario.control.rate_hz = 1.0 / (kControlPeriod * scenario.world.step_s);
  Push push;
  push.body = "torso";
  push.force_N = {60.0, 40.0, 0.0};
  push.start_s = 0.2;
  push.duration_s = 0.4;
  push.frame = PushFrame::kBody;
  scenario.pushes = {push};
  const RobotDescription& robot = scenario.robot;
  const auto servos_at = [&robot](double shift_rad) {
    ActuatorCommand command;
    command.joint_position.setConstant(static_cast<Eigen::Index>(robot.joints.size()), shift_rad);
    command.joint_velocity.setZero(command.joint_position.size());
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      const auto home = robot.home.find(robot.joints[i].name);
      if (home == robot.home.end()) continue;
      command.joint_position[static_cast<Eigen::Index>(i)] += home->second;
    }
    return [command](const SensorFrame&) { return command; };
  };
  Loop loop(scenario, servos_at(0.0));
  const std::vector<Numbers> seen = ExpectForksGoOnAlike(loop, 1500);
  ExpectForkLeavesItsOriginalAlone(loop, servos_at(0.05), 700, seen);
  for (Tick tick = 0; tick < 1500; ++tick) loop.Step(tick);
  EXPECT_TRUE(loop.truth().body_touches_ground) << "a robot on its feet has few contacts";
}

TEST(ForkedRunTest, LimpIcubCollapses) {
  const TempFolder folder;
  Scenario scenario = ReadScenario(folder.Write(
      "a.yaml", "sidestep: 1\nname: a\nrobot: icub3\nduration_s: 1\ncontrol: {mode: position}\n"));
  scenario.sensors = BadSensors();
  scenario.control.rate_hz = 1.0 / (kControlPeriod * scenario.world.step_s);
  const auto joints = static_cast<Eigen::Index>(scenario.robot.joints.size());
  const auto torques_of = [joints](double torque_Nm) {
    return [joints, torque_Nm](const SensorFrame&) {
      ActuatorCommand command;
      command.torque_Nm.setConstant(joints, torque_Nm);
      return command;
    };
  };
  Loop loop(scenario, torques_of(0.0));
  const std::vector<Numbers> seen = ExpectForksGoOnAlike(loop, 1000);
  ExpectForkLeavesItsOriginalAlone(loop, torques_of(0.1), 600, seen);
  for (Tick tick = 0; tick < 1000; ++tick) loop.Step(tick);
  EXPECT_TRUE(loop.truth().body_touches_ground);
}

/// Both feet carry the weight, or one alone, turn about, with a sideways part.
Law CentroidalSteps(double side_N) {
  return [side_N](const SensorFrame& frame) {
    ActuatorCommand command;
    command.centroidal_feet.resize(2);
    const std::size_t free_foot = static_cast<std::size_t>(frame.tick / 100) % 3;
    for (std::size_t foot = 0; foot < 2; ++foot) {
      CentroidalFootCommand& wanted = command.centroidal_feet[foot];
      wanted.in_contact = foot != free_foot;
      wanted.p_WF = {1e-4 * static_cast<double>(frame.tick), foot == 0 ? 0.1 : -0.1, 0.0};
      wanted.force_N.setZero(3, 4);
      wanted.force_N.row(1).setConstant(side_N);
      wanted.force_N.row(2).setConstant(2.5 + frame.imu.gyro_radps.x());
    }
    return command;
  };
}

TEST(ForkedRunTest, PushedCentroidalPlantThatSteps) {
  Scenario scenario = TwoFeetScenario();
  scenario.sensors = BadSensors();
  scenario.control.external_wrench = ExternalWrenchKnowledge::kKnown;
  scenario.control.estimator = EstimatorKind::kTruth;
  scenario.control.rate_hz = 1.0 / (kControlPeriod * scenario.world.step_s);
  Push push;
  push.body = "com";
  push.force_N = {1.0, -2.0, 0.5};
  push.start_s = 0.2;
  push.duration_s = 0.3;
  push.profile = PushProfile::kHalfSine;
  push.point_m = {0.0, 0.01, 0.1};
  scenario.pushes = {push};
  const Loop loop(scenario, CentroidalSteps(0.3));
  const std::vector<Numbers> seen = ExpectForksGoOnAlike(loop, 1000);
  ExpectForkLeavesItsOriginalAlone(loop, CentroidalSteps(0.2), 450, seen);
}

}  // namespace
}  // namespace sidestep::forked_run_test
