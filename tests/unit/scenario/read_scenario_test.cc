// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/read_scenario.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/run_files.h"
#include "tests/unit/scenario/scenario_fixture.h"

namespace sidestep::read_scenario_test {
namespace {

using ReadScenarioTest = ScenarioFixture;

TEST_F(ReadScenarioTest, ReadsEveryBasicKey) {
  const Scenario scenario = Read(valid_);
  EXPECT_EQ(scenario.file, folder_.path() / "a.yaml");
  EXPECT_EQ(scenario.name, "hop");
  EXPECT_EQ(scenario.robot_name, "mini");
  EXPECT_EQ(scenario.robot.base, "trunk");
  EXPECT_EQ(scenario.plant, Plant::kMujoco);
  EXPECT_EQ(scenario.duration_s, 6.0);
  EXPECT_EQ(scenario.seed, 7U);
  EXPECT_EQ(scenario.control.rate_hz, 500.0);
  EXPECT_EQ(scenario.control.mpc.knots, 12);
  EXPECT_EQ(scenario.control.mpc.box_lower_m, Eigen::Vector3d(-0.1, -0.2, 0));
  EXPECT_EQ(scenario.world.friction, 0.9);
}

TEST_F(ReadScenarioTest, FourKeysAreEnough) {
  const Scenario scenario = Read("sidestep: 1\nname: a\nrobot: mini\nduration_s: 1\n");
  EXPECT_EQ(scenario.plant, Plant::kMujoco);
  EXPECT_EQ(scenario.seed, 1U);
  EXPECT_EQ(scenario.control.mpc.backend, MpcBackend::kStructured);
  ASSERT_EQ(scenario.gait.size(), 1U);
  EXPECT_EQ(scenario.gait[0].type, GaitType::kStand);
  EXPECT_TRUE(scenario.pushes.empty());
  EXPECT_TRUE(scenario.expect.empty());
  EXPECT_TRUE(scenario.video.enabled);
}

TEST_F(ReadScenarioTest, AllMistakesAreToldAtOnceEachWithItsPlace) {
  const char* text =
      "sidestep: 1\n"
      "name: a/b\n"
      "robot: mini\n"
      "duration_s: -3\n"
      "seeed: 2\n"
      "control: {mode: torqe, mpc: {knots: 1.5, rate_hz: 0}}\n"
      "gait: [{type: stand}, {type: wlak, start_s: x}]\n"
      "pushes:\n"
      "  - {body: trunk, force_N: [1, 2], start_s: 1}\n"
      "  - {body: trunk, start_s: 1, duration_s: 1}\n"
      "expect: {fal: false, max_tilt_rad: {min: 2, max: 1}}\n"
      "video: {fps: 1e9}\n";
  std::vector<std::string> places;
  try {
    Read(text);
  } catch (const ConfigError& error) {
    for (const std::string& message : error.messages()) {
      const std::string shown = folder_.Shorten(message);
      places.push_back(shown.substr(0, shown.find(": error: ")));
    }
  }
  const std::vector<std::string> expected{
      "a.yaml:2:7",   "a.yaml:4:13",  "a.yaml:6:17",  "a.yaml:6:37", "a.yaml:6:51",
      "a.yaml:7:30",  "a.yaml:7:45",  "a.yaml:9:28",  "a.yaml:9:5",  "a.yaml:10:5",
      "a.yaml:11:10", "a.yaml:11:36", "a.yaml:12:14", "a.yaml:5:1"};
  std::vector<std::string> sorted = places, wanted = expected;
  std::sort(sorted.begin(), sorted.end());
  std::sort(wanted.begin(), wanted.end());
  EXPECT_EQ(sorted, wanted);
}

TEST_F(ReadScenarioTest, FindsARobotByAPathFromTheScenario) {
  const auto robot = std::filesystem::relative(FixtureRobots() / "mini/robot.yaml", folder_.path());
  const Scenario scenario = Read(Edit(valid_, "robot: mini", "robot: " + robot.string()));
  EXPECT_EQ(scenario.robot_name, robot.string());
  EXPECT_EQ(scenario.robot.file, FixtureRobots() / "mini/robot.yaml");
}

TEST_F(ReadScenarioTest, ARobotAloneWalksOrHopsInPlace) {
  const Scenario hop = ScenarioOfRobot("mini", {"gait.stance_s=0.3"});
  EXPECT_EQ(hop.gait[0].type, GaitType::kHop);
  EXPECT_EQ(hop.gait[0].stance_s, 0.3);
  EXPECT_EQ(hop.plant, Plant::kMujoco);
  const Scenario walk = ScenarioOfRobot(FixtureRobots() / "walker/robot.yaml");
  EXPECT_EQ(walk.gait[0].type, GaitType::kWalk);
  EXPECT_EQ(walk.plant, Plant::kCentroidal);
  EXPECT_EQ(folder_.ErrorOf([] { ScenarioOfRobot("mani"); }),
            "mani: error: is neither a robot that ships nor a robot.yaml; did you mean 'mini'?");
  EXPECT_EQ(folder_.ErrorOf([] { ScenarioOfRobot("mini", {"gait.sting_s=1"}); }).rfind("--set", 0),
            0U);
}

TEST_F(ReadScenarioTest, KnowsARobotsFileFromAScenario) {
  EXPECT_TRUE(IsRobotFile(FixtureRobots() / "mini/robot.yaml"));
  EXPECT_FALSE(IsRobotFile(folder_.Write("a.yaml", valid_)));
  EXPECT_FALSE(IsRobotFile(folder_.Write("b.yaml", "a: [\n")));
  EXPECT_FALSE(IsRobotFile(folder_.path()));
}

TEST_F(ReadScenarioTest, File) {
  EXPECT_EQ(folder_.ErrorOf([&] { ReadScenario(folder_.path() / "none.yaml"); }),
            "none.yaml: error: can't be read: No such file or directory");
  EXPECT_EQ(ErrorIn(""), "a.yaml:1:1: error: the file is empty");
  EXPECT_EQ(ErrorIn("just text\n"),
            "a.yaml:1:1: error: the file must be a map of keys, not 'just text'");
  EXPECT_EQ(ErrorIn("- a\n- b\n"), "a.yaml:1:1: error: the file must be a map of keys, not a list");
  EXPECT_EQ(ErrorIn("sidestep: 1\nname: [\n"),
            "a.yaml:3:1: error: YAML syntax: end of sequence flow not found");
  EXPECT_EQ(ErrorOfEdit("seed: 7", "name: hop"),
            "a.yaml:6:1: error: key 'name' appears twice; first at line 2");
}

TEST_F(ReadScenarioTest, Version) {
  EXPECT_EQ(ErrorOfEdit("sidestep: 1\n", ""), "a.yaml:1:1: error: sidestep is missing (required)");
  EXPECT_EQ(
      ErrorOfEdit("sidestep: 1", "sidestep: 2"),
      "a.yaml:1:11: error: sidestep = 2 is a format that this program can't read; it reads 1");
  EXPECT_EQ(ErrorOfEdit("sidestep: 1", "sidestep: one"),
            "a.yaml:1:11: error: sidestep = 'one' is not an integer");
  EXPECT_EQ(ErrorIn("sidestep: 3\nnew_key: 1\n"),
            "a.yaml:1:11: error: sidestep = 3 is a format that this program can't read; it reads 1")
      << "the version comes before all else";
}

TEST_F(ReadScenarioTest, Name) {
  EXPECT_EQ(ErrorOfEdit("name: hop\n", ""), "a.yaml:1:1: error: name is missing (required)");
  EXPECT_EQ(ErrorOfEdit("name: hop", "name:"), "a.yaml:2:1: error: name must be text, not empty");
  EXPECT_EQ(ErrorOfEdit("name: hop", "name: a b"),
            "a.yaml:2:7: error: name = 'a b' must be 1 to 100 letters, digits, '_', '-' or '.', "
            "and begin with neither '-' nor '.'");
  EXPECT_EQ(ErrorOfEdit("name: hop", "name: ../a"),
            "a.yaml:2:7: error: name = '../a' must be 1 to 100 letters, digits, '_', '-' or '.', "
            "and begin with neither '-' nor '.'");
  EXPECT_EQ(ErrorOfEdit("name: hop", "name: a\ndescription: [b]"),
            "a.yaml:3:14: error: description must be text, not a list");
  EXPECT_NE(ErrorOfEdit("name: hop", "name: " + std::string(101, 'a')), "no error");
  EXPECT_EQ(ErrorOfEdit("name: hop", "name: " + std::string(100, 'a')), "no error");
}

TEST_F(ReadScenarioTest, Basics) {
  EXPECT_EQ(ErrorOfEdit("duration_s: 6\n", ""),
            "a.yaml:1:1: error: duration_s is missing (required)");
  EXPECT_EQ(ErrorOfEdit("duration_s: 6", "duration_s: 0"),
            "a.yaml:5:13: error: duration_s = 0 violates 0.01 <= duration_s <= 10000");
  EXPECT_EQ(ErrorOfEdit("duration_s: 6", "duration_s: .inf"),
            "a.yaml:5:13: error: duration_s = '.inf' is not a finite number");
  EXPECT_EQ(ErrorOfEdit("duration_s: 6", "duration: 6"),
            "a.yaml:5:1: error: duration is not a known key; did you mean 'duration_s'?");
  EXPECT_EQ(ErrorOfEdit("seed: 7", "seed: -7"),
            "a.yaml:6:7: error: seed = -7 violates 0 <= seed <= 9223372036854775807");
  EXPECT_EQ(ErrorOfEdit("seed: 7", "seed: 7.5"),
            "a.yaml:6:7: error: seed = '7.5' is not an integer");
  EXPECT_EQ(ErrorOfEdit("plant: mujoco", "plant: mujocco"),
            "a.yaml:4:8: error: plant = 'mujocco' is not known; did you mean 'mujoco'?");
  EXPECT_EQ(ErrorOfEdit("seed: 7", "sedd: 7"),
            "a.yaml:6:1: error: sedd is not a known key; did you mean 'seed'?");
  EXPECT_EQ(ErrorOfEdit("seed: 7", "colour: red"),
            "a.yaml:6:1: error: colour is not a known key; known keys: sidestep, name, "
            "description, robot, plant, duration_s, seed, control, gait, pushes, world, sensors, "
            "verdict, expect, video");
}

TEST_F(ReadScenarioTest, Robot) {
  EXPECT_EQ(ErrorOfEdit("robot: mini\n", ""), "a.yaml:1:1: error: robot is missing (required)");
  EXPECT_EQ(ErrorOfEdit("robot: mini", "robot: minni"),
            "a.yaml:3:8: error: robot = 'minni' is neither a robot that ships nor a robot.yaml; "
            "did you mean 'mini'?");
  EXPECT_EQ(ErrorOfEdit("robot: mini", "robot: icub3"),
            "a.yaml:3:8: error: robot = 'icub3' is neither a robot that ships nor a robot.yaml; "
            "robots that ship: mini, mini_urdf, point, walker");
  EXPECT_EQ(ErrorOfEdit("robot: mini", "robot: [mini]"),
            "a.yaml:3:8: error: robot must be text, not a list");
  folder_.Write("broken.yaml", "sidestep_robot: 1\nname: 1\n");
  EXPECT_EQ(ErrorOfEdit("robot: mini", "robot: broken.yaml"),
            "broken.yaml:1:1: error: com_height_m is missing (required)");
}

TEST_F(ReadScenarioTest, Fields) {
  EXPECT_EQ(ErrorOfEdit("  mode: torque", "  mode: velocity"),
            "a.yaml:8:9: error: control.mode = 'velocity' is not known; known values: torque, "
            "position, passive");
  EXPECT_EQ(ErrorOfEdit("  mode: torque", "  external_wrench: felt"),
            "a.yaml:8:20: error: control.external_wrench = 'felt' is not known; known values: "
            "unknown, estimated, known");
  EXPECT_EQ(ErrorOfEdit("{friction: 0.9}", "{mass_scale: 2.1}"),
            "a.yaml:15:21: error: world.mass_scale = 2.1 violates 0.5 <= mass_scale <= 2");
  EXPECT_EQ(ErrorOfEdit("  mode: torque", "  mod: torque"),
            "a.yaml:8:3: error: control.mod is not a known key; did you mean 'mode'?");
  EXPECT_EQ(ErrorOfEdit("knots: 12", "knots: 1"),
            "a.yaml:10:29: error: control.mpc.knots = 1 violates 2 <= knots <= 200");
  EXPECT_EQ(ErrorOfEdit("knots: 12", "knots: 12.0"),
            "a.yaml:10:29: error: control.mpc.knots = '12.0' is not an integer");
  EXPECT_EQ(ErrorOfEdit("knots: 12", "nots: 12"),
            "a.yaml:10:22: error: control.mpc.nots is not a known key; did you mean 'knots'?");
  EXPECT_EQ(ErrorOfEdit("knots: 12", "weights: 1"),
            "a.yaml:10:31: error: control.mpc.weights must be a map of keys, not '1'");
  EXPECT_EQ(ErrorOfEdit("knots: 12", "backend: [a]"),
            "a.yaml:10:31: error: control.mpc.backend must be text, not a list");
  EXPECT_EQ(
      ErrorOfEdit("[-0.1, -0.2, 0]", "[-0.1, -3, 0]"),
      "a.yaml:10:67: error: control.mpc.box_lower_m.1 = -3 violates -2 <= box_lower_m.1 <= 2");
  EXPECT_EQ(ErrorOfEdit("[-0.1, -0.2, 0]", "[-0.1, -0.2, 0, 0]"),
            "a.yaml:10:60: error: control.mpc.box_lower_m must be a list of 3 numbers, not of 4");
  EXPECT_EQ(ErrorOfEdit("friction: 0.9", "friction: slippery"),
            "a.yaml:15:19: error: world.friction = 'slippery' is not a number");
  EXPECT_EQ(ErrorOfEdit("world: {friction: 0.9}", "world:"),
            "a.yaml:15:1: error: world must be a map of keys, not empty");
  EXPECT_EQ(ErrorOfEdit("world: {friction: 0.9}", "sensors: {dropout: 1}"),
            "a.yaml:15:20: error: sensors.dropout = 1 violates 0 <= dropout <= 0.9");
  EXPECT_EQ(
      ErrorOfEdit("world: {friction: 0.9}", "verdict: {max_slipp_m: 1}"),
      "a.yaml:15:11: error: verdict.max_slipp_m is not a known key; did you mean 'max_slip_m'?");
}

// A robot with servos and with defaults for where torques drive it.
class RobotsControlTest : public ScenarioFixture {
 protected:
  RobotsControlTest() {
    std::filesystem::create_directory(folder_.path() / "mini");
    for (const auto& entry : std::filesystem::directory_iterator(FixtureRobots() / "mini")) {
      std::filesystem::copy(entry.path(), folder_.path() / "mini" / entry.path().filename());
    }
    std::ofstream(folder_.path() / "mini/robot.yaml", std::ios::app)
        << "control: {rate_hz: 500, mpc: {knots: 20, friction: 0.3}}\n"
           "control_torque: {mpc: {friction: 0.5}}\n";
  }

  ControlParams ReadControl(const std::string& control) {
    return Read("sidestep: 1\nname: a\nrobot: mini/robot.yaml\nduration_s: 1\n" + control).control;
  }
};

TEST_F(RobotsControlTest, TorqueModeHasItsOwnDefaultsOnTop) {
  const ControlParams control = ReadControl("control: {mode: torque}\n");
  EXPECT_EQ(control.mpc.friction, 0.5);
  EXPECT_EQ(control.mpc.knots, 20);
}

TEST_F(RobotsControlTest, WithoutTorquesTheyDoNotCount) {
  EXPECT_EQ(ReadControl("control: {mode: passive}\n").mpc.friction, 0.3);
}

TEST_F(RobotsControlTest, AMistakeInThemIsToldInAnyMode) {
  const std::filesystem::path robot = folder_.path() / "mini/robot.yaml";
  std::string text = TextOf(robot);
  text.replace(text.find("friction: 0.5"), 13, "fiction: 0.5");
  std::ofstream(robot) << text;
  const std::string error = ErrorIn(
      "sidestep: 1\nname: a\nrobot: mini/robot.yaml\nduration_s: 1\n"
      "control: {mode: passive}\n");
  EXPECT_NE(error.find("control_torque.mpc.fiction is not a known key"), std::string::npos)
      << error;
}

TEST_F(RobotsControlTest, TheScenariosWordIsTheLast) {
  EXPECT_EQ(ReadControl("control: {mode: torque, mpc: {friction: 0.7}}\n").mpc.friction, 0.7);
}

}  // namespace
}  // namespace sidestep::read_scenario_test
