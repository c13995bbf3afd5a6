// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_rewrite.h"

#include "models/import/posture.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

constexpr char kQuarterTurn[] = "0 0 1.5707963267948966";

TEST(MjcfRewrite, AFrameIsAPoseAndNoLink) {
  const SourceRobot robot =
      SourceOfMjcf(SmallMjcf("<frame pos=\"1 0 0\" euler=\"" + std::string(kQuarterTurn) +
                                 "\">\n<frame pos=\"0 2 0\"><site name=\"s\" pos=\"0 0 3\"/><geom "
                                 "size=\"0.1\"/></frame></frame>\n",
                             "", "<compiler angle=\"radian\"/>"));
  EXPECT_EQ(robot.links.size(), 3U) << "pelvis, leg and the site";
  const Placement at(robot, ZeroPosture(robot));
  EXPECT_TRUE(
      at.X_WL(FindLink(robot, "s")).translation().isApprox(Eigen::Vector3d(-1.0, 0.0, 3.0), 1e-12));
  EXPECT_EQ(LinkCalled(robot, "pelvis").mass.mass_kg, 3.0) << "its <inertial> is all its mass";
  EXPECT_EQ(LinkCalled(robot, "pelvis").collisions.size(), 1U);
}

TEST(MjcfRewrite, AShapeInAFrameWeighsWhereTheBodyHasNoInertial) {
  const SourceRobot robot =
      SourceOfMjcf(SmallMjcf("<body name=\"ball\"><frame pos=\"0 0 1\"><geom size=\"0.1\" "
                             "mass=\"5\"/></frame></body>\n"));
  EXPECT_NEAR(LinkCalled(robot, "ball").mass.mass_kg, 5.0, 1e-12);
  EXPECT_NEAR(LinkCalled(robot, "ball").mass.com_m.z(), 1.0, 1e-12);
}

TEST(MjcfRewrite, AFrameOfTheWorldTurnsTheRobotAndPassesItsClassOn) {
  const auto robot_in = [](const std::string& begin, const std::string& end) {
    return SourceOfMjcf(
        "<mujoco><worldbody>" + begin +
        "<body name=\"r\" euler=\"0 90 0\"><freejoint/><geom size=\"0.1\" pos=\"1 0 0\"/>"
        "<body><joint name=\"h\"/><geom size=\"0.1\"/></body></body>" +
        end + "</worldbody><compiler eulerseq=\"ZYX\" angle=\"degree\"/>" +
        "<default><default class=\"outer\"><joint armature=\"1\"/></default>"
        "<default class=\"inner\"><joint armature=\"2\"/></default></default></mujoco>");
  };
  const SourceRobot robot =
      robot_in("<frame childclass=\"outer\" euler=\"90 0 0\"><frame childclass=\"inner\">",
               "</frame></frame>");
  // By its own angles the ball hangs down; a quarter turn about z leaves it there.
  EXPECT_TRUE(LinkCalled(robot, "r").mass.com_m.isApprox(Eigen::Vector3d(0.0, 0.0, -1.0), 1e-12));
  EXPECT_EQ(robot.joints[0].armature_kgm2, 2.0) << "the innermost";
  const SourceRobot upright = robot_in("<frame euler=\"0 -90 0\">", "</frame>");
  EXPECT_TRUE(LinkCalled(upright, "r").mass.com_m.isApprox(Eigen::Vector3d(1.0, 0.0, 0.0), 1e-12));
  EXPECT_EQ(upright.joints[0].armature_kgm2, 0.0);
}

TEST(MjcfRewrite, AFramePassesItsClassOnAndABodysOwnCountsMore) {
  const SourceRobot robot = SourceOfMjcf(
      SmallMjcf("<frame childclass=\"a\"><body><joint name=\"x\"/><geom size=\"1\"/></body>"
                "<body childclass=\"b\"><joint name=\"y\"/><geom size=\"1\"/></body></frame>"
                "<body><joint name=\"z\"/><geom size=\"1\"/></body>",
                "",
                "<default><joint armature=\"3\"/><default class=\"a\"><joint armature=\"1\"/>"
                "</default><default class=\"b\"><joint armature=\"2\"/></default></default>"));
  const auto armature = [&](const std::string& joint) {
    return robot.joints[static_cast<std::size_t>(JointCalled(robot, joint))].armature_kgm2;
  };
  EXPECT_EQ(armature("x"), 1.0);
  EXPECT_EQ(armature("y"), 2.0);
  EXPECT_EQ(armature("z"), 3.0) << "it is in no frame";
}

TEST(MjcfRewrite, AFrameOfTheWorldThatCantBeReadIsTold) {
  const std::string error = MjcfErrorOf(
      "<mujoco><worldbody>\n<frame quat=\"1 0\"><body><freejoint/><geom "
      "size=\"1\"/><body><joint/><geom "
      "size=\"1\"/></body></body></frame></worldbody></mujoco>");
  EXPECT_EQ(error.rfind("robot.xml:2:1: error: <frame> can't be read: ", 0), 0U) << error;
}

TEST(MjcfRewrite, AJointInAFrameIsRefused) {
  EXPECT_EQ(
      MjcfErrorOf(SmallMjcf("<body><geom size=\"1\"/>\n<frame><joint "
                            "name=\"j\"/></frame></body>\n")),
      "robot.xml:7:8: error: <joint> 'j' is in a <frame>: move it into the body, in the body's "
      "axes");
}

TEST(MjcfRewrite, RangesLimitWhereTheFileDoesNotSay) {
  const std::string hinge = SmallMjcf("");
  EXPECT_EQ(SourceOfMjcf(hinge).joints[0].kind, JointKind::kRevolute);
  const std::string old = SmallMjcf("", "", "<compiler autolimits=\"false\"/>");
  EXPECT_EQ(
      MjcfErrorOf(old).find("robot.xml:5:1: error: Error: joint has `range` but not `limited`"), 0U)
      << "what it says stays";
}

TEST(MjcfRewrite, TheScenesOwnThingsArePassedOver) {
  Notes notes;
  SourceOfMjcf(SmallMjcf("<camera name=\"c\"/>", "<option gravity=\"0 0 -1\"/><keyframe/>",
                         "<asset><texture type=\"skybox\" builtin=\"flat\"/></asset>"),
               &notes);
  EXPECT_TRUE(HasNote(notes, "passed over 1 <camera>, 1 <keyframe>, 1 <option>, 1 <texture>"));
}

TEST(MjcfRewrite, SceneryThatCantBeTakenIsPassedOver) {
  Notes notes;
  SourceOfMjcf(SmallMjcf("",
                         "<worldbody><replicate count=\"9\"><geom "
                         "size=\"1\"/></replicate><flexcomp/></worldbody>"),
               &notes);
  EXPECT_TRUE(HasNote(notes, "passed over 1 <flexcomp>, 1 <replicate>"));
}

TEST(MjcfRewrite, OnlyMotorsOfJointsStay) {
  Notes notes;
  SourceOfMjcf(SmallMjcf("<site name=\"nozzle\"/>",
                         "<actuator>\n<general name=\"jet\" "
                         "site=\"nozzle\"/></actuator>"),
               &notes);
  EXPECT_TRUE(HasNote(notes, "robot.xml:8:1: left out the <general> 'jet', which is no joint's"));
}

/// A ball that nothing touches but by <pair>, and the pairs.
SourceRobot PairedBall(const std::string& world, const std::string& pairs, Notes* notes) {
  return SourceOfMjcf(
      SmallMjcf("<geom name=\"ball\" size=\"0.1\" contype=\"0\" conaffinity=\"0\"/>\n"
                "<geom name=\"ghost\" size=\"0.2\" contype=\"0\" conaffinity=\"0\"/>\n",
                "<contact>" + pairs + "</contact>", world),
      notes);
}

TEST(MjcfRewrite, AShapePairedWithAFloorOfAnotherFileCollides) {
  Notes notes;
  const SourceRobot robot = PairedBall(
      "", "<pair geom1=\"ball\" geom2=\"floor\"/><pair geom1=\"a\" geom2=\"floor\"/>", &notes);
  ASSERT_EQ(LinkCalled(robot, "pelvis").collisions.size(), 1U);
  EXPECT_EQ(LinkCalled(robot, "pelvis").collisions[0].size_m.x(), 0.1);
  EXPECT_TRUE(HasNote(notes, "took 'floor', named by <pair> and not in the file, for floors"));
}

TEST(MjcfRewrite, AShapePairedWithAHeightFieldCollides) {
  Notes notes;
  const SourceRobot robot = PairedBall(
      "<asset><hfield name=\"hills\" nrow=\"2\" ncol=\"2\" size=\"1 1 1 1\"/></asset>"
      "<worldbody><geom name=\"ground\" type=\"hfield\" hfield=\"hills\"/></worldbody>",
      "<pair geom1=\"ground\" geom2=\"ball\"/>", &notes);
  EXPECT_EQ(LinkCalled(robot, "pelvis").collisions.size(), 1U);
}

}  // namespace
}  // namespace sidestep::importer
