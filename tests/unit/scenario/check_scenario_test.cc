// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/check_scenario.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "sim/scenario/write_scenario.h"
#include "tests/unit/scenario/scenario_fixture.h"

namespace sidestep::check_scenario_test {
namespace {

using CheckScenarioTest = ScenarioFixture;

const std::vector<std::string> kWalker{"robot=walker", "plant=centroidal", "pushes=[]",
                                       "gait={type: walk}"};

std::vector<std::string> Together(std::vector<std::string> overrides, const std::string& last) {
  overrides.push_back(last);
  return overrides;
}

TEST_F(CheckScenarioTest, AcceptsWhatFits) {
  EXPECT_EQ(ErrorIn(valid_), "no error");
  EXPECT_EQ(ErrorIn(valid_, kWalker), "no error");
  EXPECT_EQ(ErrorOfSet("control.rate_hz=40"), "no error") << "25 ms and 50 ms at 1 ms";
  EXPECT_EQ(ErrorOfSet("world.step_s=0.0005"), "no error");
  EXPECT_EQ(ErrorOfSet("duration_s=4.1"), "no error") << "the last push ends with the scenario";
}

TEST_F(CheckScenarioTest, BaselinesStepOnTwoFeet) {
  EXPECT_EQ(ErrorIn(valid_, Together(kWalker, "control.stepping=dcm_qp")), "no error");
  EXPECT_NE(ErrorOfSet("control.stepping=capture_point").find("write stepping: mpc"),
            std::string::npos);
  EXPECT_EQ(ErrorOfSet("control.stepping=mpc"), "no error");
}

TEST_F(CheckScenarioTest, Plant) {
  EXPECT_EQ(ErrorOfEdit("robot: mini", "robot: point"),
            "a.yaml:4:8: error: plant = mujoco needs a robot with an MJCF, which 'point' lacks; "
            "write plant: centroidal");
  EXPECT_EQ(ErrorIn("sidestep: 1\nname: a\nrobot: point\nduration_s: 1\n"),
            "a.yaml:3:8: error: plant = mujoco needs a robot with an MJCF, which 'point' lacks; "
            "write plant: centroidal");
}

TEST_F(CheckScenarioTest, GroundIsMadeOfRectanglesClearOfTheStartAndOfEachOther) {
  const auto error = [&](const std::string& patches) {
    return ErrorOfEdit("friction: 0.9", "ground: [" + patches + "]");
  };
  EXPECT_EQ(error("{from_x_m: 1, to_x_m: 2, height_m: -0.02}, {from_x_m: 2, to_x_m: 3, height_m: "
                  "0.5}, {from_x_m: -9, to_x_m: -1, from_y_m: 0, to_y_m: 1, height_m: 0}"),
            "no error")
      << "patches may touch";
  EXPECT_EQ(
      error("{from_x_m: 1, to_x_m: 1, height_m: 0.1}"),
      "a.yaml:15:40: error: world.ground.0.to_x_m = 1 must lie 0.01 m or more beyond from_x_m "
      "= 1");
  EXPECT_EQ(error("{from_x_m: 1, to_x_m: 1.009, height_m: 0.1}"),
            "a.yaml:15:40: error: world.ground.0.to_x_m = 1.009 must lie 0.01 m or more beyond "
            "from_x_m = 1");
  EXPECT_EQ(error("{from_x_m: 1.1, to_x_m: 1.11, height_m: 0.1}"), "no error");
  EXPECT_EQ(error("{from_x_m: 1, to_x_m: 2, from_y_m: 100, height_m: 0.1}"),
            "a.yaml:15:53: error: world.ground.0.to_y_m = 100 must lie 0.01 m or more beyond "
            "from_y_m = 100");
  EXPECT_EQ(error("{from_x_m: 1, to_x_m: 2, height_m: 0.6}"),
            "a.yaml:15:53: error: world.ground.0.height_m = 0.6 violates -0.5 <= height_m <= 0.5");
  EXPECT_EQ(error("{from_x_m: 1, height_m: 0.1}"),
            "a.yaml:15:18: error: world.ground.0.to_x_m is missing (required)");
  EXPECT_EQ(error("{from_x_m: 1, to_x_m: 2, height_m: 0.1}, {from_x_m: 1.9, to_x_m: 3, height_m: "
                  "0.1}"),
            "a.yaml:15:59: error: world.ground.1 overlaps world.ground.0");
  EXPECT_EQ(
      error("{from_x_m: -1, to_x_m: 0.1, height_m: 0.1}"),
      "a.yaml:15:18: error: world.ground.0 lies where the robot starts: foot 'foot' stands at "
      "x = 0 to 0 m, y = 0 to 0 m");
}

TEST_F(CheckScenarioTest, GroundIsLevelUnderEverySoleAtTheStart) {
  // Its soles of 0.19 m x 0.09 m are at x = 0, y = +-0.06.
  const std::string biped = SIDESTEP_SOURCE_DIR "/models/biped/robot.yaml";
  const auto error = [&](const std::string& patch) {
    return ErrorIn("sidestep: 1\nname: a\nrobot: " + biped + "\nduration_s: 1\nworld: {ground: [{" +
                   patch + ", height_m: 0.1}]}\n");
  };
  EXPECT_EQ(error("from_x_m: 0.09, to_x_m: 0.3"),
            "a.yaml:5:18: error: world.ground.0 lies where the robot starts: foot 'left' stands at "
            "x = -0.095 to 0.095 m, y = 0.015 to 0.105 m");
  EXPECT_EQ(error("from_x_m: -1, to_x_m: 1, from_y_m: -0.3, to_y_m: 0").substr(0, 74),
            "a.yaml:5:18: error: world.ground.0 lies where the robot starts: foot 'righ");
  EXPECT_EQ(error("from_x_m: 0.1, to_x_m: 0.3"), "no error");
  EXPECT_EQ(error("from_x_m: -1, to_x_m: 1, from_y_m: 2"), "no error") << "beside it";
}

TEST_F(CheckScenarioTest, PatchesAreNotWithoutNumber) {
  std::string patches;
  for (int i = 0; i < 201; ++i) {
    const std::string from = std::to_string(1 + i % 50), side = std::to_string(i / 50);
    patches += "{from_x_m: " + from + ", to_x_m: " + from + ".5, from_y_m: " + side +
               ", to_y_m: " + side + ".5, height_m: 0.1}, ";
  }
  EXPECT_EQ(ErrorOfEdit("friction: 0.9", "ground: [" + patches + "]"),
            "a.yaml:15:17: error: world.ground has 201 patches; at most 200 are allowed");
}

TEST_F(CheckScenarioTest, TheCentroidalPlantHasLevelGround) {
  EXPECT_EQ(ErrorIn(valid_, Together(kWalker,
                                     "world.ground=[{from_x_m: 1, to_x_m: 2, height_m: "
                                     "0.1}]")),
            "--set world.ground=[{from_x_m: 1, to_x_m: 2, height_m: 0.1}]: error: world.ground "
            "means nothing on the centroidal plant, whose feet go where they are told; leave it "
            "out, or write plant: mujoco");
}

TEST_F(CheckScenarioTest, TheCentroidalPlantNeedsAMass) {
  EXPECT_EQ(
      ErrorIn("sidestep: 1\nname: a\nrobot: mini\nplant: centroidal\nduration_s: 1\n"),
      "a.yaml:4:8: error: plant = centroidal needs a robot whose robot.yaml tells its mass_kg, "
      "which 'mini' does not; write plant: mujoco");
}

TEST_F(CheckScenarioTest, PositionControlNeedsServos) {
  EXPECT_EQ(ErrorOfEdit("mode: torque", "mode: position"),
            "a.yaml:8:9: error: control.mode = position needs a robot with servos, which 'mini' "
            "lacks; write mode: torque");
}

TEST_F(CheckScenarioTest, PositionMeansNothingOnTheCentroidalPlant) {
  EXPECT_EQ(ErrorIn(valid_, Together(kWalker, "control.mode=position")),
            "--set control.mode=position: error: control.mode = position means nothing on the "
            "centroidal plant, which has no joints; leave it out");
  EXPECT_EQ(ErrorIn(Edit(valid_, "mode: torque", "mode: position"), kWalker),
            "a.yaml:8:9: error: control.mode = position means nothing on the centroidal plant, "
            "which has no joints; leave it out");
  EXPECT_EQ(ErrorIn(valid_, Together(kWalker, "control.mode=passive")), "no error");
  EXPECT_EQ(ErrorIn(valid_, Together(kWalker, "control.mode=torque")), "no error")
      << "what a run's scenario.yaml says by default";
}

// The robot's default is for its servos; the scenario did not ask for them.
TEST_F(CheckScenarioTest, ARobotsDefaultModeDoesNotReachTheCentroidalPlant) {
  folder_.Write("robot.yaml",
                "sidestep_robot: 1\nname: point\nmass_kg: 2.0\ncom_height_m: 0.5\n"
                "feet:\n  - {name: foot, vertices_m: [[0, 0, 0]]}\ncontrol: {mode: position}\n");
  const std::string text =
      "sidestep: 1\nname: a\nrobot: robot.yaml\nplant: centroidal\nduration_s: 1\n";
  ASSERT_EQ(ErrorIn(text), "no error");
  EXPECT_EQ(Read(text).control.mode, ControlMode::kTorque);
  EXPECT_EQ(ErrorIn(ResolvedYaml(Read(text))), "no error") << "what a run leaves can be read again";
  EXPECT_EQ(ErrorIn(text + "control: {mode: position}\n"),
            "a.yaml:6:17: error: control.mode = position means nothing on the centroidal plant, "
            "which has no joints; leave it out");
}

TEST_F(CheckScenarioTest, TorqueControlTakesFlatFeetToo) {
  Scenario scenario = Read(valid_);
  const ConfigTree root = ReadConfigFile(folder_.Write("a.yaml", valid_));
  scenario.robot.feet[0].vertices_m.setZero(3, 4);
  EXPECT_EQ(folder_.ErrorOf([&] { CheckScenario(scenario, root); }), "no error");
}

TEST_F(CheckScenarioTest, TorqueControlNeedsMotorsWithLimits) {
  std::ifstream file(FixtureRobots() / "mini/mini.xml");
  const std::string mjcf{std::istreambuf_iterator<char>(file), {}};
  folder_.Write("mini.xml", Edit(mjcf, "joint=\"leg\" ctrllimited=\"true\" ctrlrange=\"-60 60\"",
                                 "joint=\"leg\""));
  folder_.Write("robot.yaml",
                "sidestep_robot: 1\nname: weak\nmjcf: mini.xml\nbase: trunk\nimu: imu\n"
                "com_height_m: 0.339\nbase_height_m: 0.368\nhome: {hip: 0.1, leg: 0.05}\nfeet:\n"
                "  - {name: foot, frame: foot, sole_height_m: 0.02, vertices_m: [[0, 0, 0]]}\n");
  const std::string unlimited = Edit(valid_, "robot: mini", "robot: robot.yaml");
  EXPECT_EQ(
      ErrorIn(unlimited),
      "a.yaml:8:9: error: control.mode = torque needs each joint's <motor> to have gear 1 and a "
      "ctrlrange of -limit to limit, and that of 'leg' of 'robot.yaml' has no ctrlrange");
  EXPECT_EQ(
      ErrorIn(Edit(unlimited, "  mode: torque\n", "")),
      "a.yaml:3:8: error: control.mode = torque needs each joint's <motor> to have gear 1 and a "
      "ctrlrange of -limit to limit, and that of 'leg' of 'robot.yaml' has no ctrlrange")
      << "the mode is a default: the robot is to blame";
  EXPECT_EQ(ErrorIn(Edit(unlimited, "mode: torque", "mode: passive")), "no error");
  folder_.Write("mini.xml", Edit(mjcf, "joint=\"leg\" ctrllimited=\"true\" ctrlrange=\"-60 60\"",
                                 "joint=\"leg\" gear=\"5\""));
  EXPECT_EQ(
      ErrorIn(unlimited),
      "a.yaml:8:9: error: control.mode = torque needs each joint's <motor> to have gear 1 and a "
      "ctrlrange of -limit to limit, and that of 'leg' of 'robot.yaml' has the gear 5; sidestep "
      "robots import FILE.xml -o DIR makes motors of it");
  std::string servo = Edit(mjcf, "joint=\"leg\" ctrllimited=\"true\" ctrlrange=\"-60 60\"",
                           "joint=\"leg\" kp=\"900\" forcelimited=\"true\" forcerange=\"-60 60\"");
  servo.replace(servo.rfind("<motor", servo.find("kp=\"900\"")), 6, "<position");
  folder_.Write("mini.xml", servo);
  EXPECT_EQ(ErrorIn(unlimited), "no error") << "a servo of the MJCF gives way to a motor";
}

TEST_F(CheckScenarioTest, EstimatedWrenchNeedsSensorsInTheArms) {
  EXPECT_EQ(ErrorOfEdit("mode: torque", "external_wrench: estimated"),
            "a.yaml:8:20: error: control.external_wrench = estimated needs force/torque sensors in "
            "the arms, which 'mini' lacks; write external_wrench: unknown or known, or "
            "estimation.push_cutoff_hz above 0");
  EXPECT_EQ(ErrorIn(valid_, Together(kWalker, "control.external_wrench=estimated")),
            "--set control.external_wrench=estimated: error: control.external_wrench = estimated "
            "needs force/torque sensors in the arms, which the centroidal plant lacks; write "
            "external_wrench: unknown or known");
}

TEST_F(CheckScenarioTest, PushesAreFeltThroughTheFeet) {
  EXPECT_EQ(
      ErrorOfEdit("mode: torque", "estimation: {push_cutoff_hz: 3}"),
      "a.yaml:8:32: error: control.estimation.push_cutoff_hz > 0 needs force/torque sensors in "
      "the feet, which 'mini' lacks; write push_cutoff_hz: 0");
  EXPECT_EQ(ErrorOfEdit("mode: torque", "estimation: {push_cutoff_hz: 0}"), "no error");
}

TEST_F(CheckScenarioTest, RobotsThatCanMayDoBoth) {
  Scenario scenario = Read(valid_);
  const ConfigTree root = ReadConfigFile(folder_.Write("a.yaml", valid_));
  scenario.control.mode = ControlMode::kPosition;
  scenario.control.external_wrench = ExternalWrenchKnowledge::kEstimated;
  EXPECT_THROW(CheckScenario(scenario, root), ConfigError);
  scenario.robot.joints = {{"hip", 100.0, 1.0, 5.0, 1.0}, {"leg", 100.0, 1.0, 5.0, 1.0}};
  scenario.robot.arm_force_torque = {"palm"};
  EXPECT_NO_THROW(CheckScenario(scenario, root));
}

TEST_F(CheckScenarioTest, Rates) {
  EXPECT_EQ(ErrorOfEdit("  rate_hz: 500", "  rate_hz: 300"),
            "a.yaml:9:12: error: control.rate_hz = 300 has a period that is no whole number of "
            "physics steps (world.step_s = 0.001)");
  EXPECT_EQ(ErrorOfEdit("  rate_hz: 500", "  rate_hz: 2000"),
            "a.yaml:9:12: error: control.rate_hz = 2000 has a period that is no whole number of "
            "physics steps (world.step_s = 0.001)");
  EXPECT_EQ(ErrorOfEdit("{rate_hz: 20", "{rate_hz: 30"),
            "a.yaml:10:18: error: control.mpc.rate_hz = 30 has a period that is no whole number of "
            "control periods (control.rate_hz = 500)");
  EXPECT_EQ(ErrorOfEdit("{rate_hz: 20", "{rate_hz: 1000"),
            "a.yaml:10:18: error: control.mpc.rate_hz = 1000 has a period that is no whole number "
            "of control periods (control.rate_hz = 500)");
  EXPECT_EQ(ErrorOfEdit("step_s: 0.05", "step_s: 0.0525"),
            "a.yaml:10:41: error: control.mpc.step_s = 0.0525 is no whole number of physics steps "
            "(world.step_s = 0.001)");
  EXPECT_EQ(ErrorIn("sidestep: 1\nname: a\nrobot: mini\nduration_s: 1\nworld: {step_s: 0.003}\n"),
            "a.yaml:5:17: error: control.rate_hz = 500 has a period that is no whole number of "
            "physics steps (world.step_s = 0.003)")
      << "the control rate is a default: the step is to blame";
}

TEST_F(CheckScenarioTest, Mpc) {
  EXPECT_EQ(
      ErrorOfEdit("knots: 12", "backend: ipot"),
      "a.yaml:10:31: error: control.mpc.backend = 'ipot' is not known; did you mean 'ipopt'?");
  EXPECT_EQ(
      ErrorOfEdit("knots: 12", "backend: simplex"),
      "a.yaml:10:31: error: control.mpc.backend = 'simplex' is not known; known values: ipopt, "
      "structured");
  EXPECT_EQ(ErrorOfEdit("[-0.1, -0.2, 0]", "[-0.1, 0.2, 0]"),
            "a.yaml:10:67: error: control.mpc.box_lower_m.1 = 0.2 is above box_upper_m.1 = 0.1");
  EXPECT_EQ(ErrorOfEdit("box_lower_m: [-0.1, -0.2, 0]", "box_upper_m: [0.1, 0.1, -0.1]"),
            "a.yaml:10:71: error: control.mpc.box_lower_m.2 = 0 is above box_upper_m.2 = -0.1");
}

TEST_F(CheckScenarioTest, Gaits) {
  EXPECT_EQ(ErrorOfEdit("type: hop", "type: walk"),
            "a.yaml:11:14: error: gait.type = walk needs a robot of 2 feet; 'mini' has 1");
  EXPECT_EQ(ErrorOfEdit("type: hop", "type: run"),
            "a.yaml:11:14: error: gait.type = run needs a robot of 2 feet; 'mini' has 1");
  EXPECT_EQ(ErrorOfEdit("step_width_m: 0", "step_width_m: 0.1"),
            "a.yaml:11:49: error: gait.step_width_m = 0.1 must be 0 for a robot of 1 foot");
  EXPECT_EQ(ErrorOfEdit("type: hop", "type: hop, start_s: 1"),
            "a.yaml:11:28: error: gait.start_s must be 0 for the first gait");
  EXPECT_EQ(ErrorOfSet("gait=[{type: hop}, {type: stand}]"),
            "--set gait=[{type: hop}, {type: stand}]: error: gait.1.start_s = 0 must be after the "
            "gait before it, at 0 (column 15 of the value)");
  EXPECT_EQ(ErrorOfSet("gait=[{type: hop}, {start_s: 2}, {start_s: 2}]"),
            "--set gait=[{type: hop}, {start_s: 2}, {start_s: 2}]: error: gait.2.start_s = 2 must "
            "be after the gait before it, at 2 (column 39 of the value)");
  EXPECT_EQ(ErrorIn(Edit(Edit(Edit(valid_, "robot: mini", "robot: walker"), "plant: mujoco",
                              "plant: centroidal"),
                         "body: trunk", "body: com")),
            "a.yaml:11:14: error: gait.type = hop needs a robot of 1 foot; 'walker' has 2");
}

TEST_F(CheckScenarioTest, Pushes) {
  EXPECT_EQ(ErrorOfEdit("body: trunk", "body: trnk"),
            "a.yaml:13:12: error: pushes.0.body = 'trnk' is no body or frame of 'mini'; did you "
            "mean 'trunk'?");
  EXPECT_EQ(ErrorOfEdit("body: trunk", "body: head"),
            "a.yaml:13:12: error: pushes.0.body = 'head' is no body or frame of 'mini'; known "
            "ones: trunk, thigh, shank, imu, foot");
  EXPECT_EQ(ErrorOfEdit("body: trunk", "body: world"),
            "a.yaml:13:12: error: pushes.0.body = 'world' is no body or frame of 'mini'; known "
            "ones: trunk, thigh, shank, imu, foot")
      << "the world can't be pushed";
  EXPECT_EQ(ErrorIn("sidestep: 1\nname: a\nrobot: point\nplant: centroidal\nduration_s: 1\n"
                    "pushes: [{body: trunk, force_N: [1, 0, 0], start_s: 0, duration_s: 0.1}]\n"),
            "a.yaml:6:17: error: pushes.0.body = 'trunk' is no body or frame of 'point'; known "
            "ones: com, foot")
      << "the reduced model has no trunk";
  EXPECT_EQ(ErrorOfEdit("duration_s: 6", "duration_s: 4.05"),
            "a.yaml:14:5: error: pushes.1 ends at 4.1 s, after the scenario's duration_s = 4.05");
  EXPECT_EQ(ErrorOfEdit("duration_s: 0.1", "duration_s: 5e-7"),
            "a.yaml:14:76: error: pushes.1.duration_s = 5e-07 is less than a thousandth of a "
            "physics step (world.step_s = 0.001)");
  EXPECT_EQ(ErrorOfEdit("duration_s: 0.1", "duration_s: 2e-6"), "no error");
}

TEST_F(CheckScenarioTest, ARobotInAPlaneIsAskedForNothingSideways) {
  const std::string rabbit = SIDESTEP_SOURCE_DIR "/models/rabbit/robot.yaml";
  const std::string text = "sidestep: 1\nname: a\nrobot: " + rabbit +
                           "\nduration_s: 1\ngait: {type: walk, step_width_m: 0.12}\n";
  const auto error_of_set = [&](const std::string& assignment) {
    return ErrorIn(text, {assignment});
  };
  const std::string in_a_plane = ": '" + rabbit + "' moves in a plane";
  EXPECT_EQ(ErrorIn(text), "no error");
  EXPECT_EQ(ErrorIn(Edit(text, "0.12", "0.16")),
            "a.yaml:5:34: error: gait.step_width_m = 0.16 must be 0.12" + in_a_plane +
                ", its feet so far apart");
  EXPECT_EQ(ErrorIn(Edit(text, ", step_width_m: 0.12", "")), "no error");
  EXPECT_EQ(Read(Edit(text, ", step_width_m: 0.12", "")).gait[0].step_width_m, 0.12)
      << "its own feet's distance";
  EXPECT_EQ(ErrorIn(Edit(text, "0.12}", "0.12, step_side_m: 0.1}")),
            "a.yaml:5:53: error: gait.step_side_m = 0.1 must be 0" + in_a_plane);
  EXPECT_EQ(error_of_set("control.mpc.box_lower_m=[-0.1, -0.1, 0]"),
            "--set control.mpc.box_lower_m=[-0.1, -0.1, 0]: error: control.mpc.box_lower_m.1 = "
            "-0.1 must be 0" +
                in_a_plane + " (column 8 of the value)");
  EXPECT_EQ(error_of_set("control.mpc.box_upper_m=[0.1, 0.1, 0]"),
            "--set control.mpc.box_upper_m=[0.1, 0.1, 0]: error: control.mpc.box_upper_m.1 = 0.1 "
            "must be 0" +
                in_a_plane + " (column 7 of the value)");
  EXPECT_EQ(error_of_set("control.planner.com_sway=0.5"),
            "--set control.planner.com_sway=0.5: error: control.planner.com_sway = 0.5 must be 0" +
                in_a_plane);
  EXPECT_EQ(error_of_set("control.planner.min_step_width_m=0.1"),
            "--set control.planner.min_step_width_m=0.1: error: "
            "control.planner.min_step_width_m = 0.1 must be 0" +
                in_a_plane);
}

TEST_F(CheckScenarioTest, ARobotInAPlaneIsNotPushedSideways) {
  const std::string rabbit = SIDESTEP_SOURCE_DIR "/models/rabbit/robot.yaml";
  const auto error = [&](const std::string& force) {
    return ErrorIn("sidestep: 1\nname: a\nrobot: " + rabbit +
                   "\nduration_s: 1\npushes:\n  - {body: torso, start_s: 0.1, duration_s: 0.1, " +
                   force + "}\n");
  };
  const std::string in_a_plane = " N, and '" + rabbit + "' moves in a plane: it would not feel it";
  for (const char* axes : {"", ", frame: heading", ", frame: body"}) {
    EXPECT_EQ(error("force_N: [20, 0, -5]" + std::string(axes)), "no error");
    EXPECT_EQ(error("force_N: [20, -3, 0]" + std::string(axes)),
              "a.yaml:6:59: error: pushes.0.force_N pushes sideways, by -3" + in_a_plane);
  }
  for (const char* angle : {"0", "3.1416", "-3.141592653589793"}) {
    EXPECT_EQ(error("magnitude_N: 50, direction_rad: " + std::string(angle)), "no error");
  }
  EXPECT_EQ(error("magnitude_N: 50, direction_rad: 1.5707963267948966"),
            "a.yaml:6:82: error: pushes.0.direction_rad pushes sideways, by 50" + in_a_plane);
  EXPECT_NE(error("magnitude_N: 50, direction_rad: 0.001"), "no error");
}

}  // namespace
}  // namespace sidestep::check_scenario_test
