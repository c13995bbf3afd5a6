// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/robot_description.h"

#include <gtest/gtest.h>

#include <string>

#include "models/mjcf/mjcf.h"
#include "models/support/config_text.h"
#include "tests/support/temp_folder.h"

namespace sidestep::robot_description_test {
namespace {

const std::filesystem::path kRobots =
    std::filesystem::path(SIDESTEP_SOURCE_DIR) / "tests/data/models";

TEST(RobotDescriptionTest, ReadsARobotWithAnMjcf) {
  const RobotDescription robot = ReadRobotDescription(kRobots / "mini/robot.yaml");
  EXPECT_EQ(robot.name, "mini");
  EXPECT_EQ(robot.file, kRobots / "mini/robot.yaml");
  ASSERT_TRUE(robot.model);
  EXPECT_EQ(robot.model->language, ModelLanguage::kMjcf);
  EXPECT_EQ(robot.model->file, kRobots / "mini/mini.xml");
  EXPECT_EQ(robot.model->simulated_mjcf, robot.model->drawn_mjcf) << "an MJCF is taken as it is";
  EXPECT_EQ(robot.mass_kg, 0.0);
  EXPECT_EQ(robot.base, "trunk");
  EXPECT_EQ(robot.imu, "imu");
  EXPECT_EQ(robot.com_height_m, 0.339);
  EXPECT_EQ(robot.base_height_m, 0.368);
  EXPECT_EQ(robot.home, (std::map<std::string, double>{{"hip", 0.1}, {"leg", 0.05}}));
  ASSERT_EQ(robot.feet.size(), 1U);
  EXPECT_EQ(robot.feet[0].name, "foot");
  EXPECT_EQ(robot.feet[0].frame, "foot");
  EXPECT_EQ(robot.feet[0].sole_height_m, 0.02);
  EXPECT_EQ(robot.feet[0].vertices_m, Eigen::Matrix3Xd::Zero(3, 1));
}

TEST(RobotDescriptionTest, ReadsARobotOfTheCentroidalPlant) {
  const RobotDescription robot = ReadRobotDescription(kRobots / "walker/robot.yaml");
  EXPECT_FALSE(robot.model);
  EXPECT_EQ(robot.mass_kg, 30.0);
  ASSERT_EQ(robot.feet.size(), 2U);
  EXPECT_EQ(robot.feet[1].name, "right");
  EXPECT_EQ(robot.feet[1].frame, "right_sole");
  Eigen::Matrix3Xd vertices_m(3, 2);
  vertices_m << 0.1, -0.1, 0.05, -0.05, 0, 0;  // one column a vertex
  EXPECT_EQ(robot.feet[1].vertices_m, vertices_m);
}

TEST(RobotDescriptionTest, ACentroidalFootIsItsOwnFrameByDefault) {
  EXPECT_EQ(ReadRobotDescription(kRobots / "point/robot.yaml").feet[0].frame, "foot");
}

TEST(RobotDescriptionTest, NamesComeFromTheMjcf) {
  const RobotNames names = NamesIn(ReadRobotDescription(kRobots / "mini/robot.yaml"));
  EXPECT_EQ(names.bodies, (std::vector<std::string>{"trunk", "thigh", "shank"}));
  EXPECT_EQ(names.frames, (std::vector<std::string>{"imu", "foot"}));
  EXPECT_TRUE(names.unfit_motors.empty());
}

/// What is wrong with the actuator that moves `hip`.
std::string UnfitnessOf(const std::string& actuator) {
  const TempFolder folder;
  RobotDescription robot = ReadRobotDescription(kRobots / "mini/robot.yaml");
  robot.model = ReadMjcfModel(folder.Write(
      "loose.xml",
      "<mujoco><compiler autolimits=\"true\"/><worldbody><body><freejoint/><geom size=\"0.1\"/>"
      "<body><joint name=\"hip\"/><geom size=\"0.1\"/></body></body></worldbody><actuator>" +
          actuator + "</actuator></mujoco>"));
  const std::vector<UnfitMotor> unfit = NamesIn(robot).unfit_motors;
  if (unfit.empty()) return "fit";
  EXPECT_EQ(unfit[0].joint, "hip");
  return unfit[0].what + (unfit[0].lacks_a_limit ? "; it lacks a limit" : "");
}

TEST(RobotDescriptionTest, MotorsThatTorqueControlCanNotUseAreTold) {
  EXPECT_EQ(UnfitnessOf("<motor joint=\"hip\" ctrlrange=\"-4 4\"/>"), "fit");
  EXPECT_EQ(UnfitnessOf("<motor joint=\"hip\" ctrlrange=\"-4 4\" forcerange=\"-5 5\"/>"), "fit");
  EXPECT_EQ(UnfitnessOf("<motor joint=\"hip\"/>"), "has no ctrlrange; it lacks a limit");
  EXPECT_EQ(UnfitnessOf("<motor joint=\"hip\" ctrlrange=\"-1 4\"/>"),
            "has the ctrlrange -1 4; it lacks a limit");
  EXPECT_EQ(UnfitnessOf("<motor joint=\"hip\" ctrlrange=\"1 4\"/>"),
            "has the ctrlrange 1 4; it lacks a limit");
  EXPECT_EQ(UnfitnessOf("<motor joint=\"hip\" ctrlrange=\"-4 4\" forcerange=\"-0.5 0.5\"/>"),
            "has a forcerange narrower than its ctrlrange -4 4; it lacks a limit");
  EXPECT_EQ(UnfitnessOf("<motor joint=\"hip\" ctrlrange=\"-4 4\" gear=\"-10\"/>"),
            "has the gear -10");
  for (const char* kind : {"velocity kv=\"1\"", "general gainprm=\"2\""}) {
    EXPECT_EQ(UnfitnessOf("<" + std::string(kind) + " joint=\"hip\" ctrlrange=\"-4 4\"/>"),
              "is no <motor>");
  }
}

TEST(RobotDescriptionTest, ServosOfAnMjcfGiveWayToMotorsWithTheirLimits) {
  EXPECT_EQ(UnfitnessOf("<position joint=\"hip\" kp=\"10\" ctrlrange=\"-1 1\" gear=\"2\" "
                        "forcerange=\"-9 9\"/>"),
            "fit");
  EXPECT_EQ(UnfitnessOf("<general joint=\"hip\" gainprm=\"10\" biastype=\"affine\" biasprm=\"0 -10 "
                        "-1\" forcerange=\"-9 9\"/>"),
            "fit");
  EXPECT_EQ(UnfitnessOf("<position joint=\"hip\" kp=\"10\" ctrlrange=\"-4 4\"/>"),
            "has no ctrlrange; it lacks a limit")
      << "a servo's ctrlrange is of angles";
}

TEST(RobotDescriptionTest, NamesOfACentroidalRobotAreItsComAndFeet) {
  const RobotNames names = NamesIn(ReadRobotDescription(kRobots / "walker/robot.yaml"));
  EXPECT_EQ(names.bodies, (std::vector<std::string>{"com"}));
  EXPECT_EQ(names.frames, (std::vector<std::string>{"left_sole", "right_sole"}));
}

/// Copies of the fixtures, with one edit.
class RobotErrorTest : public testing::Test {
 protected:
  std::string ErrorOfEdit(const std::string& robot, const std::string& from,
                          const std::string& to) const {
    const std::string text = ReadConfigText(kRobots / robot / "robot.yaml");
    folder_.Write("mini.xml", ReadConfigText(kRobots / "mini/mini.xml"));
    const std::filesystem::path file = folder_.Write("robot.yaml", Edit(text, from, to));
    return folder_.ErrorOf([&] { ReadRobotDescription(file); });
  }

  std::string ErrorOfMjcf(const std::string& from, const std::string& to) const {
    const std::filesystem::path file =
        folder_.Write("robot.yaml", ReadConfigText(kRobots / "mini/robot.yaml"));
    folder_.Write("mini.xml", Edit(ReadConfigText(kRobots / "mini/mini.xml"), from, to));
    return folder_.ErrorOf([&] { ReadRobotDescription(file); });
  }

  const TempFolder folder_;
};

TEST_F(RobotErrorTest, AnUntouchedCopyHasNoError) {
  EXPECT_EQ(ErrorOfEdit("mini", "name: mini", "name: mini"), "no error");
  EXPECT_EQ(ErrorOfEdit("walker", "name: walker", "name: walker"), "no error");
}

TEST_F(RobotErrorTest, Version) {
  EXPECT_EQ(ErrorOfEdit("mini", "sidestep_robot: 1", "sidestep_robot: 2"),
            "robot.yaml:1:17: error: sidestep_robot = 2 is a version that this program can't read; "
            "it reads 1");
  EXPECT_EQ(ErrorOfEdit("mini", "sidestep_robot: 1\n", ""),
            "robot.yaml:1:1: error: sidestep_robot is missing (required)");
}

TEST_F(RobotErrorTest, Names) {
  EXPECT_EQ(ErrorOfEdit("mini", "name: mini", "name: ''"),
            "robot.yaml:2:7: error: name = '' must be 1 to 100 letters, digits, '_', '-' or '.', "
            "and begin with neither '-' nor '.'");
  EXPECT_EQ(ErrorOfEdit("walker", "name: left", "name: '`touch PWNED`'"),
            "robot.yaml:6:12: error: feet.0.name = '`touch PWNED`' must be 1 to 100 letters, "
            "digits, '_', '-' or '.', and begin with neither '-' nor '.'");
  EXPECT_EQ(ErrorOfEdit("walker", "name: left", "name: 'a,b'"),
            "robot.yaml:6:12: error: feet.0.name = 'a,b' must be 1 to 100 letters, digits, '_', "
            "'-' or '.', and begin with neither '-' nor '.'");
  EXPECT_EQ(ErrorOfEdit("mini", "base: trunk", "base: trnk"),
            "robot.yaml:4:7: error: base = 'trnk' is no floating body (a free joint, or slides x, "
            "z and hinge y) of the MJCF; did "
            "you mean 'trunk'?");
  EXPECT_EQ(ErrorOfEdit("mini", "base: trunk", "base: thigh"),
            "robot.yaml:4:7: error: base = 'thigh' is no floating body (a free joint, or slides x, "
            "z and hinge y) of the MJCF; known "
            "ones: trunk");
  EXPECT_EQ(ErrorOfEdit("mini", "imu: imu", "imu: head"),
            "robot.yaml:5:6: error: imu = 'head' is no site of the MJCF; known ones: imu, foot");
  EXPECT_EQ(ErrorOfEdit("mini", "imu: imu", "imu: foot"),
            "robot.yaml:5:6: error: imu needs a sensor 'foot_orientation', which the MJCF lacks");
  EXPECT_EQ(ErrorOfEdit("mini", "frame: foot", "frame: toe"),
            "robot.yaml:10:25: error: feet.0.frame = 'toe' is no site of the MJCF; known ones: "
            "imu, foot");
  EXPECT_EQ(
      ErrorOfEdit("mini", "name: foot", "name: paw"),
      "robot.yaml:10:12: error: feet.0.name needs a sensor 'paw_touch', which the MJCF lacks");
  EXPECT_EQ(ErrorOfEdit("mini", "hip: 0.1", "hop: 0.1"),
            "robot.yaml:8:8: error: home.hop is no joint of the MJCF; did you mean 'hip'?");
  EXPECT_EQ(ErrorOfEdit("walker", "name: right", "name: left"),
            "robot.yaml:7:12: error: feet.1.name = 'left' names two feet");
}

TEST_F(RobotErrorTest, Values) {
  EXPECT_EQ(ErrorOfEdit("mini", "com_height_m: 0.339", "com_height_m: 0.0"),
            "robot.yaml:6:15: error: com_height_m = 0 violates 0.01 <= com_height_m <= 10");
  EXPECT_EQ(ErrorOfEdit("mini", "base_height_m: 0.368", "base_height_m: 500"),
            "robot.yaml:7:16: error: base_height_m = 500 violates 0 <= base_height_m <= 10");
  EXPECT_EQ(ErrorOfEdit("mini", "hip: 0.1", "hip: 0.1rad"),
            "robot.yaml:8:13: error: home.hip = '0.1rad' is not a number");
  EXPECT_EQ(ErrorOfEdit("mini", "[[0, 0, 0]]", "[]"),
            "robot.yaml:10:64: error: feet.0.vertices_m must hold at least one vertex");
  EXPECT_EQ(ErrorOfEdit("mini", "[[0, 0, 0]]", "[[0, 0]]"),
            "robot.yaml:10:65: error: feet.0.vertices_m.0 must be a list of 3 numbers, not of 2");
  EXPECT_EQ(
      ErrorOfEdit("mini", "sole_height_m: 0.02", "sole_height_m: -0.02"),
      "robot.yaml:10:46: error: feet.0.sole_height_m = -0.02 violates 0 <= sole_height_m <= 10");
  EXPECT_EQ(ErrorOfEdit("walker", "mass_kg: 30", "mass_kg: 0"),
            "robot.yaml:3:10: error: mass_kg must be greater than 0");
  EXPECT_EQ(ErrorOfEdit("walker", "mass_kg: 30", "mass_kg: 1e5"),
            "robot.yaml:3:10: error: mass_kg = 1e+05 violates 0 <= mass_kg <= 10000");
}

TEST_F(RobotErrorTest, Keys) {
  EXPECT_EQ(ErrorOfEdit("mini", "mjcf: mini.xml", "mjcf: maxi.xml"),
            "robot.yaml:3:7: error: mjcf = 'maxi.xml' is no file beside this one");
  EXPECT_EQ(ErrorOfEdit("mini", "base: trunk", "base: trunk\nmass_kg: 1"),
            "robot.yaml:5:10: error: mass_kg is told by the MJCF; leave it out");
  EXPECT_EQ(
      ErrorOfEdit("mini", "base: trunk", "base: trunk\ncolour: red"),
      "robot.yaml:5:1: error: colour is not a known key; known keys: sidestep_robot, name, "
      "com_height_m, urdf, mjcf, mass_kg, base, imu, torso, base_height_m, base_rpy_rad, home, "
      "arm_force_torque, feet, joints, control, control_torque");
  EXPECT_EQ(ErrorOfEdit("mini", "frame: foot", "frame: foot, size: 1"),
            "robot.yaml:10:31: error: feet.0.size is not a known key; known keys: name, frame, "
            "force_torque, vertices_m, preferred_cop_m, sole_height_m");
  EXPECT_EQ(
      ErrorOfEdit("mini", "frame: foot", "frame: foot, preferred_cop_m: [0, 0.01]"),
      "robot.yaml:10:48: error: feet.0.preferred_cop_m needs a negative share of the force at "
      "a vertex: it must lie nearer their mean");
  EXPECT_EQ(
      ErrorOfEdit("mini", "frame: foot", "frame: foot, preferred_cop_m: [0, 0, 0]"),
      "robot.yaml:10:48: error: feet.0.preferred_cop_m must be a list of 2 numbers, not of 3");
  EXPECT_EQ(ErrorOfEdit("walker", "mass_kg: 30\n", ""),
            "robot.yaml:1:1: error: mass_kg is missing (required)");
  EXPECT_EQ(ErrorOfEdit("walker", "mass_kg: 30", "mass_kg: 30\nbase: trunk"),
            "robot.yaml:4:1: error: base means nothing for a robot without an mjcf or a "
            "urdf");
  EXPECT_EQ(ErrorOfEdit("point", "feet:\n  - {name: foot, vertices_m: [[0, 0, 0]]}", "feet: []"),
            "robot.yaml:5:7: error: feet must hold at least one foot");
}

TEST_F(RobotErrorTest, Mjcf) {
  EXPECT_EQ(ErrorOfMjcf("</mujoco>", ""),
            "mini.xml:2:1: error: XML parse error 15; Error=XML_ERROR_PARSING ErrorID=15 (0xf)");
  EXPECT_EQ(
      ErrorOfMjcf("<freejoint/>", "<freejont/>"),
      "mini.xml:5:7: error: <freejont> is an element that MuJoCo 2.2 doesn't know; delete it");
  EXPECT_EQ(ErrorOfMjcf("<motor joint=\"hip\"", "<motor kv=\"1\" joint=\"hip\""),
            "mini.xml:20:5: error: <motor> has kv, which MuJoCo 2.2 doesn't know; delete it");
  EXPECT_EQ(ErrorOfMjcf("<motor joint=\"hip\"", "<motor joint=\"knee\""),
            "mini.xml:20:1: error: Error: unknown transmission target 'knee' for actuator id = 0; "
            "Object name = , id = 0");
  EXPECT_EQ(
      ErrorOfMjcf("<touch name=\"foot_touch\" site=\"foot\"/>", ""),
      "robot.yaml:10:12: error: feet.0.name needs a sensor 'foot_touch', which the MJCF lacks");
  EXPECT_EQ(ErrorOfMjcf("mass=\"1\"", "mass=\"one\""),
            "mini.xml:6:7: error: XML Error: problem reading attribute 'mass'; Element 'geom'");
}

TEST_F(RobotErrorTest, AnMjcfThatVanishedCantBeRead) {
  EXPECT_EQ(folder_.ErrorOf([&] { ReadMjcfModel(folder_.path() / "gone.xml"); }),
            "gone.xml: error: can't be read");
}

/// The robot `mini`, its actuators and sensors in files of their own.
class RobotOfFilesTest : public testing::Test {
 protected:
  RobotOfFilesTest() {
    const std::string whole = ReadConfigText(kRobots / "mini/mini.xml");
    const std::size_t begin = whole.find("<actuator>");
    folder_.Write("robot/mini.xml",
                  whole.substr(0, begin) + "<include file=\"parts/all.xml\"/>\n" + "</mujoco>\n");
    folder_.Write("robot/parts/all.xml",
                  "<mujoco>\n<include file=\"parts/rest&#46;xml\"></include>\n</mujoco>\n");
    folder_.Write("robot/parts/rest.xml", "<mujoco>\n" + whole.substr(begin));
    yaml_ = folder_.Write("robot/robot.yaml", ReadConfigText(kRobots / "mini/robot.yaml"));
  }

  const TempFolder folder_;
  std::filesystem::path yaml_;
};

TEST_F(RobotOfFilesTest, IsTheRobotOfOneFile) {
  const RobotDescription whole = ReadRobotDescription(kRobots / "mini/robot.yaml");
  const RobotDescription parts = ReadRobotDescription(yaml_);
  std::filesystem::remove_all(folder_.path() / "robot");
  const MjModelPtr expected = CompileMjcf(whole.model->simulated_mjcf, "", "whole");
  const MjModelPtr actual = CompileMjcf(parts.model->simulated_mjcf, "", "parts");
  EXPECT_EQ(mj_sizeModel(actual.get()), mj_sizeModel(expected.get()));
  EXPECT_EQ(actual->nu, expected->nu);
  EXPECT_EQ(actual->nsensor, expected->nsensor);
  EXPECT_EQ(NamesIn(parts).bodies, NamesIn(whole).bodies);
}

TEST_F(RobotOfFilesTest, MistakesAreToldInTheirFile) {
  const auto error = [&] { return folder_.ErrorOf([&] { ReadRobotDescription(yaml_); }); };
  const std::string rest = ReadConfigText(folder_.path() / "robot/parts/rest.xml");
  folder_.Write("robot/parts/rest.xml",
                Edit(rest, "<motor joint=\"hip\"", "<motor  kv=\"3\" joint=\"hip\""));
  EXPECT_EQ(error(),
            "robot/parts/rest.xml:3:5: error: <motor> has kv, which MuJoCo 2.2 doesn't know; "
            "delete it");
  folder_.Write("robot/parts/all.xml", "<mujoco>\n<include file=\"rest.xml\"/>\n</mujoco>\n");
  EXPECT_EQ(
      error(),
      "robot/parts/all.xml:2:1: error: <include> of 'rest.xml', which is no file in the folder "
      "of mini.xml");
}

TEST_F(RobotOfFilesTest, MeshesAreForTheImport) {
  folder_.Write("robot/m.obj",
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const std::string rest = ReadConfigText(folder_.path() / "robot/parts/rest.xml");
  folder_.Write(
      "robot/parts/rest.xml",
      Edit(rest, "</mujoco>", "  <asset><mesh name=\"m\" file=\"m.obj\"/></asset></mujoco>"));
  EXPECT_EQ(
      folder_.ErrorOf([&] { ReadRobotDescription(yaml_); }),
      "robot/parts/rest.xml:12:10: error: <mesh> reads the file 'm.obj', but a robot's MJCF is "
      "compiled from its text alone; `sidestep robots import` takes it with its meshes");
}

TEST_F(RobotErrorTest, AnMjcfIsReadOnceAndItsFileNeededNoMore) {
  const std::filesystem::path mjcf =
      folder_.Write("mini.xml", ReadConfigText(kRobots / "mini/mini.xml"));
  const RobotDescription robot = ReadRobotDescription(
      folder_.Write("robot.yaml", ReadConfigText(kRobots / "mini/robot.yaml")));
  const std::vector<std::string> bodies = NamesIn(robot).bodies;
  std::filesystem::remove(mjcf);
  EXPECT_FALSE(bodies.empty());
  EXPECT_EQ(NamesIn(robot).bodies, bodies);
}

}  // namespace
}  // namespace sidestep::robot_description_test
