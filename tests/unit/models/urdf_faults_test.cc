// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with a URDF is told all at once, each with its place; hostile files end in one
// line.
#include <gtest/gtest.h>

#include "models/robot_description/robot_description.h"
#include "models/support/config_text.h"
#include "models/urdf_to_mjcf/read_urdf.h"
#include "models/urdf_to_mjcf/urdf_graph.h"
#include "tests/support/temp_folder.h"

namespace sidestep::urdf_faults_test {
namespace {

const std::filesystem::path kMini =
    std::filesystem::path(SIDESTEP_SOURCE_DIR) / "tests/data/models/mini_urdf";

/// Copies of the fixture's URDF with edits, read as its robot.yaml has it.
class UrdfFaultsTest : public testing::Test {
 protected:
  using Edits = std::vector<std::pair<std::string, std::string>>;

  std::string ErrorOf(const Edits& edits) const {
    std::string text = ReadConfigText(kMini / "mini.urdf");
    for (const auto& [from, to] : edits) text = Edit(text, from, to);
    folder_.Write("mini.urdf", text);
    folder_.Write("robot.yaml", ReadConfigText(kMini / "robot.yaml"));
    return folder_.ErrorOf([&] { ReadRobotDescription(folder_.path() / "robot.yaml"); });
  }

  std::string ErrorOfText(const std::string& text) const {
    const auto file = folder_.Write("a.urdf", text);
    return folder_.ErrorOf([&] { SurveyUrdf(file, {}); });
  }

  /// A robot of nothing but this.
  std::string ErrorOfParts(const std::string& parts) const {
    return ErrorOfText("<robot name=\"a\">\n" + parts + "</robot>\n");
  }

  const TempFolder folder_;
};

std::string FixedJoint(const std::string& name, const std::string& parent,
                       const std::string& child) {
  return "<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/></joint>\n";
}

TEST_F(UrdfFaultsTest, EveryUnreadablePartIsToldAtOnce) {
  EXPECT_EQ(ErrorOf({{"<sphere radius=\"0.15\"/>", "<sphere radius=\"wide\"/>"},
                     {"<parent link=\"leg\"/>", "<parent link=\"lag\"/>"},
                     {"<origin xyz=\"0 0 -0.03\"/>", "<origin xyz=\"0 0 nan\"/>"},
                     {"<link name=\"imu\"/>", "<link name=\"i m u\"/>"},
                     {"<limit lower=\"-1\" upper=\"1.5\" effort=\"30\" velocity=\"5\"/>", ""}}),
            "mini.urdf:11:5: error: link 'trunk' has radius = 'wide' in <sphere>, which must be a "
            "finite number\n"
            "mini.urdf:14:3: error: link 'i m u': a name must be 1 to 100 letters, digits, '_', "
            "'-' or '.', and begin with neither '-' nor '.'\n"
            "mini.urdf:15:3: error: joint 'imu_fixed' joins link 'imu', which is not there; add "
            "the link or remove the joint\n"
            "mini.urdf:22:3: error: joint 'hip' is revolute without a <limit lower=\"...\" "
            "upper=\"...\" effort=\"...\" velocity=\"...\"/>; give it one, or make it continuous "
            "or fixed\n"
            "mini.urdf:28:3: error: joint 'foot_fixed' joins link 'lag', which is not there; add "
            "the link or remove the joint\n"
            "mini.urdf:32:3: error: joint 'sole_fixed' has xyz = '0 0 nan' in <origin>, which must "
            "be 3 finite numbers");
}

TEST_F(UrdfFaultsTest, NumbersOfNoRobotAreToldAsSuch) {
  EXPECT_EQ(ErrorOf({{"<mass value=\"2\"/>", "<mass value=\"1e300\"/>"},
                     {"<box size=\"0.2 0.1 0.02\"/>", "<box size=\"200 100 20\"/>"},
                     {"<origin xyz=\"0 0 -0.03\"/>", "<origin xyz=\"0 0 -1e200\"/>"},
                     {"<axis xyz=\"0 1 0\"/>", "<axis xyz=\"0 1e-200 0\"/>"},
                     {"<origin xyz=\"0 0.2 0.2\"/>", "<origin xyz=\"0 ${y} 0.2\"/>"}}),
            "mini.urdf:7:67: error: link 'trunk' has value = '1e300' in <mass>, which must be at "
            "most 10000\n"
            "mini.urdf:22:78: error: joint 'hip' has an axis of no length, which points nowhere\n"
            "mini.urdf:26:5: error: link 'foot' has size = '200 100 20' in <box>, which must be at "
            "most 10\n"
            "mini.urdf:32:3: error: joint 'sole_fixed' has xyz = '0 0 -1e200' in <origin>, which "
            "must be at most 10\n"
            "mini.urdf:40:3: error: joint 'shoulder' has xyz = '0 ${y} 0.2' in <origin>, which "
            "must be 3 finite numbers; expand the file with xacro first");
  EXPECT_EQ(ErrorOfParts("<xacro:leg side=\"left\"/>"),
            "a.urdf:2:1: error: <xacro:leg> is xacro's; expand the file first: xacro FILE > "
            "robot.urdf");
}

TEST_F(UrdfFaultsTest, EveryProblemOfAReadableOneIsToldAtOnce) {
  EXPECT_EQ(
      ErrorOf({{"izz=\"0.04\"", "izz=\"0.4\""},
               {"<mass value=\"0.5\"/>", "<mass value=\"-0.5\"/>"},
               {"<axis xyz=\"0 0 1\"/><limit lower=\"0\"",
                "<mimic joint=\"wag\"/><axis xyz=\"0 0 1\"/><limit lower=\"0\""},
               {"<box size=\"0.2 0.1 0.02\"/>", "<mesh filename=\"sole.stl\"/>"},
               {"<cylinder radius=\"0.02\" length=\"0.2\"/>", "<mesh filename=\"leg.stl\"/>"},
               {"effort=\"10\"", "effort=\"1e9\""}}),
      "mini.urdf:7:5: error: link 'trunk' of 2 kg has the principal moments 0.02, 0.03 and 0.4 kg "
      "m^2; none may be greater than the other two together, and 0.4 > 0.02 + 0.03; mend its "
      "<inertial>\n"
      "mini.urdf:18:5: error: link 'leg' of -0.5 kg has the principal moments 0.001, 0.002 and "
      "0.002 kg m^2, and no body has a mass that is not positive; mend its <inertial>\n"
      "mini.urdf:20:5: error: feet have only meshes to stand on, in the links leg, foot; give each "
      "foot a <collision> with a box for its sole\n"
      "mini.urdf:40:3: error: joint 'shoulder' has effort = 1e+09, more than any motor's 10000 "
      "Nm; mend it, or give its group in robot.yaml a torque_limit_Nm\n"
      "mini.urdf:47:3: error: joint 'grip' mimics 'wag', which can't be simulated; list it in "
      "locked_joints of robot.yaml, or mend it here");
}

TEST_F(UrdfFaultsTest, JointsThatCantMoveMustBeLocked) {
  EXPECT_EQ(
      ErrorOf({{"name=\"sole_fixed\" type=\"fixed\"", "name=\"sole_fixed\" type=\"continuous\""}}),
      "mini.urdf:32:3: error: joint 'sole_fixed' moves a link without mass, 'sole', to which "
      "none with mass is fixed; list it in locked_joints of robot.yaml, or mend it here");
  EXPECT_EQ(ErrorOf({{"name=\"foot_ft_fixed\" type=\"fixed\"",
                      "name=\"foot_ft_fixed\" type=\"planar\""}}),
            "mini.urdf:30:3: error: joint 'foot_ft_fixed' is neither fixed, revolute, continuous "
            "nor prismatic; list it in locked_joints of robot.yaml, or mend it here");
  EXPECT_EQ(ErrorOf({{"upper=\"1.5\"", "upper=\"-1\""}}),
            "mini.urdf:22:3: error: joint 'hip' has no range to move in, from -1 to -1; list it in "
            "locked_joints of robot.yaml, or mend it here");
}

TEST_F(UrdfFaultsTest, ARootWithoutMassMustCarryOneThatHasIt) {
  EXPECT_EQ(ErrorOf({{"name=\"footprint_fixed\" type=\"fixed\"",
                      "name=\"footprint_fixed\" type=\"continuous\""}}),
            "mini.urdf:5:3: error: link 'footprint' at the root has no mass, and no link with mass "
            "is fixed to it: give the robot's trunk or pelvis an <inertial>");
}

TEST_F(UrdfFaultsTest, GraphsThatAreNoTrees) {
  const std::string links = "<link name=\"a\"/>\n<link name=\"b\"/>\n<link name=\"c\"/>\n";
  EXPECT_EQ(ErrorOfParts(links + FixedJoint("j", "a", "b") + FixedJoint("k", "c", "c")),
            "a.urdf:6:1: error: joint 'k' joins link 'c' to itself");
  EXPECT_EQ(ErrorOfParts(links + FixedJoint("j", "a", "b") + FixedJoint("k", "b", "c") +
                         FixedJoint("l", "c", "b")),
            "a.urdf:7:1: error: joint 'l' gives link 'b' a second parent, beside joint 'j'; a URDF "
            "is a tree, so that loops must be cut");
  EXPECT_EQ(
      ErrorOfParts(links + FixedJoint("j", "b", "c") + FixedJoint("k", "c", "b")),
      "a.urdf:3:1: error: link 'b' hangs on a loop of links, not on 'a'; a URDF is a tree, so "
      "that loops must be cut");
  EXPECT_EQ(ErrorOfParts(links + FixedJoint("j", "a", "b") + FixedJoint("k", "b", "c") +
                         FixedJoint("l", "c", "a")),
            "a.urdf:2:1: error: every link hangs on another, in a loop; a URDF is a tree with a "
            "root");
  EXPECT_EQ(ErrorOfParts(links + FixedJoint("j", "a", "b")),
            "a.urdf:4:1: error: link 'c' hangs on nothing, and so does 'a'; a robot is one tree: "
            "join them or remove one");
  EXPECT_EQ(ErrorOfParts(links + FixedJoint("j", "a", "b") + FixedJoint("j", "b", "c")),
            "a.urdf:6:1: error: joint 'j' is there twice; names must differ");
  EXPECT_EQ(ErrorOfParts("<link name=\"a\"/><link name=\"a\"/>"),
            "a.urdf:2:17: error: link 'a' is there twice; names must differ");
  EXPECT_EQ(ErrorOfParts(""), "a.urdf:1:1: error: the robot has no <link>");
}

/// A chain of links l0, l1, ...
std::string Chain(int num_links) {
  std::string parts = "<link name=\"l0\"/>\n";
  for (int i = 1; i < num_links; ++i) {
    const std::string name = std::to_string(i);
    parts += "<link name=\"l" + name + "\"/>\n" +
             FixedJoint("j" + name, "l" + std::to_string(i - 1), "l" + name);
  }
  return parts;
}

TEST_F(UrdfFaultsTest, WhatIsTooLargeEndsInOneLine) {
  EXPECT_EQ(ErrorOfParts(Chain(20'000)),
            "a.urdf:1:1: error: the robot has 20000 links, more than 2000");
  EXPECT_EQ(ErrorOfParts(Chain(2'000)),
            "a.urdf:163:1: error: link 'l81' hangs on more than 80 joints in a row");
  std::string shapes = "<link name=\"l\">";
  for (int i = 0; i < 4001; ++i) {
    shapes += "<visual><geometry><sphere radius=\"1\"/></geometry></visual>\n";
  }
  EXPECT_EQ(ErrorOfParts(shapes + "</link>"),
            "a.urdf:1:1: error: the robot has 4001 shapes, more than 4000");
  std::string nested;
  for (int i = 0; i < 100'000; ++i) nested += "<a>";
  EXPECT_EQ(ErrorOfParts(nested), "a.urdf:2:298: error: has elements nested deeper than 100");
}

TEST_F(UrdfFaultsTest, WhatIsNoUrdf) {
  EXPECT_EQ(ErrorOfText(""), "a.urdf:1:1: error: Error document empty.");
  EXPECT_EQ(ErrorOfText("<mujoco/>"), "a.urdf: error: is no URDF: it has no <robot> element");
  EXPECT_EQ(ErrorOfText("<robot><link name=\"a\"/></robot>"),
            "a.urdf:1:1: error: the <robot> has no name; give it one: <robot name=\"...\">");
  EXPECT_EQ(ErrorOfText("<?xml version=\"1.0\" "),
            "a.urdf: error: is no URDF: it has no <robot> element");
}

}  // namespace
}  // namespace sidestep::urdf_faults_test
