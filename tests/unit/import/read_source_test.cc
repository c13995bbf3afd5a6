// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/read_source.h"

#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

std::string ErrorFor(const std::string& urdf) {
  const TempFolder folder;
  Notes notes;
  const std::filesystem::path file = folder.Write("robot.urdf", urdf);
  return folder.ErrorOf([&] { ReadSource(file, &notes); });
}

TEST(ReadSource, TakesNumbersShapesAndLimits) {
  const SourceRobot robot = SourceOf(R"(<robot name="r">
<material name="red"><color rgba="1 0 0 1"/></material>
<link name="a"><inertial><origin xyz="0 0 1" rpy="0 0 1.5707963267948966"/><mass value="+2"/>
  <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2.5"/></inertial>
  <visual><geometry><mesh filename="package://p/a.stl" scale="1 -1 1"/></geometry><material name="red"/></visual>
  <collision><geometry><capsule radius="0.1" length="0.3"/></geometry></collision></link>
<link name="b"/>
<joint name="j" type="revolute"><parent link="a"/><child link="b"/><origin xyz="1 2 3"/>
  <axis xyz="0 0 2"/><limit lower="-1" upper="2" effort="5" velocity="6"/><dynamics damping="0.5"/></joint>
</robot>)");
  ASSERT_EQ(robot.links.size(), 2U);
  EXPECT_EQ(robot.root, 0);
  const SourceLink& a = robot.links[0];
  EXPECT_DOUBLE_EQ(a.mass.mass_kg, 2.0);
  EXPECT_NEAR(a.mass.inertia_kgm2(0, 0), 2.0, 1e-12);  // turned by a right angle about z
  EXPECT_EQ(a.visuals[0].kind, ShapeKind::kMesh);
  EXPECT_DOUBLE_EQ(a.visuals[0].scale.y(), -1.0);
  EXPECT_EQ(a.visuals[0].rgba, Eigen::Vector4d(1, 0, 0, 1));
  EXPECT_EQ(a.collisions[0].kind, ShapeKind::kCylinder);
  EXPECT_DOUBLE_EQ(a.collisions[0].size_m.y(), 0.5);  // with its caps
  const SourceJoint& j = robot.joints[0];
  EXPECT_EQ(j.axis, Eigen::Vector3d::UnitZ());
  EXPECT_DOUBLE_EQ(j.upper, 2.0);
  EXPECT_DOUBLE_EQ(j.damping_Nms_per_rad, 0.5);
  EXPECT_EQ(j.X_PC.translation(), Eigen::Vector3d(1, 2, 3));
}

TEST(ReadSource, TellsEveryProblemWithItsPlace) {
  EXPECT_EQ(ErrorFor(R"(<robot name="r">
<link name="a"><inertial><mass value="x"/></inertial></link>
<link name="a"/>
<link name="c"><visual><geometry/></visual></link>
</robot>)"),
            "robot.urdf:2:26: error: link 'a': <mass> needs value of 1 number, not 'x'\n"
            "robot.urdf:3:1: error: link 'a' = 'a' is there twice\n"
            "robot.urdf:4:16: error: link 'c': <visual> needs a <geometry> with a box, sphere, "
            "cylinder or mesh");
  EXPECT_EQ(
      ErrorFor(R"(<robot name="r"><link name="a"/>
<joint name="j" type="planar"><parent link="a"/><child link="b"/></joint></robot>)"),
      "robot.urdf:2:1: error: joint 'j' needs <child link=\"...\"/> that names a link; there is "
      "none called 'b'\n"
      "robot.urdf:2:1: error: joint 'j' must be fixed, revolute, continuous or prismatic");
}

TEST(ReadSource, RefusesLoopsAndForests) {
  const std::string links = R"(<robot name="r"><link name="a"/><link name="b"/><link name="c"/>)";
  const auto joint = [](const std::string& name, const std::string& up, const std::string& down) {
    return "<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + up +
           "\"/><child link=\"" + down + "\"/></joint>";
  };
  EXPECT_NE(ErrorFor(links + joint("1", "a", "b") + joint("2", "c", "b") + "</robot>")
                .find("link 'b' has two parents, by joints '1' and '2'"),
            std::string::npos);
  EXPECT_NE(ErrorFor(links + joint("1", "a", "b") + "</robot>").find("both have no parent"),
            std::string::npos);
  EXPECT_NE(ErrorFor(links + joint("1", "b", "c") + joint("2", "c", "b") + "</robot>")
                .find("loop apart from the root"),
            std::string::npos);
}

TEST(ReadSource, CharacterReferencesAreUtf8) {
  const TempFolder folder;
  Notes notes;
  EXPECT_EQ(ReadSource(folder.Write("robot.urdf",
                                    "<robot name=\"gr&#252;n\"><link "
                                    "name=\"a\"/></robot>"),
                       &notes)
                .name,
            "gr\xC3\xBCn");
}

TEST(ReadSource, SurvivesHostileFiles) {
  std::string deep = "<robot name=\"r\">";
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_EQ(ErrorFor(deep), "robot.urdf:1:314: error: has elements nested deeper than 100");
  std::string chain = "<robot name=\"r\"><link name=\"l0\"/>";
  for (int i = 1; i < 20'000; ++i) {
    const std::string n = std::to_string(i), before = std::to_string(i - 1);
    chain += "<link name=\"l" + n + "\"/><joint name=\"j" + n +
             "\" type=\"fixed\"><parent link=\"l" + before + "\"/><child link=\"l" + n +
             "\"/></joint>\n";
  }
  EXPECT_EQ(ErrorFor(chain + "</robot>"),
            "robot.urdf:2000:1: error: link 'l2000' is one too many: a robot has at most 2000");
  std::string shapes = "<robot name=\"r\"><link name=\"l\">";
  for (int i = 0; i < 4001; ++i) {
    shapes += "<collision><geometry><sphere radius=\"1\"/></geometry></collision>\n";
  }
  EXPECT_EQ(ErrorFor(shapes + "</link></robot>"),
            "robot.urdf:1:17: error: link 'l' has one shape too many: a robot has at most 4000");
  EXPECT_NE(ErrorFor("<robot name=\"r\"><link name=\"a\">").find("robot.urdf:"), std::string::npos);
  EXPECT_NE(ErrorFor("no xml").find("error"), std::string::npos);
  EXPECT_NE(ErrorFor("<sdf/>").find("must be <robot>"), std::string::npos);
  EXPECT_NE(ErrorFor("<robot name=\"r\"><xacro:include filename=\"x\"/></robot>").find("xacro"),
            std::string::npos);
}

TEST(ReadSource, LeavesOutAFloatingRoot) {
  MakerRobot floating;
  floating.has_floating_root = true;
  const SourceRobot robot = SourceOf(floating);
  EXPECT_EQ(FindLink(robot, "world"), -1);
  EXPECT_EQ(robot.links[static_cast<std::size_t>(robot.root)].name, "pelvis");
  EXPECT_NEAR(TotalMass_kg(robot), TotalMass_kg(SourceOf(MakerRobot())), 1e-12);
}

}  // namespace
}  // namespace sidestep::importer
