// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/read_mjcf.h"

#include "tests/support/maker_mjcf.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

TEST(ReadMjcf, IsToldFromAUrdfByItsFirstElement) {
  const TempFolder folder;
  EXPECT_TRUE(IsMjcf(folder.Write("a", "<?xml version=\"1.0\"?><!-- <robot> -->\n<mujoco/>")));
  EXPECT_FALSE(IsMjcf(folder.Write("b", "<!-- <mujoco> --><robot name=\"r\"/>")));
  EXPECT_FALSE(IsMjcf(folder.Write("c", "")));
  EXPECT_FALSE(IsMjcf(folder.Write("d", "<!--")));
}

TEST(ReadMjcf, ASceneIsReadForTheRobotInIt) {
  for (const bool has_newer_words : {false, true}) {
    const TempFolder folder;
    MakerMjcf maker;
    maker.has_newer_words = has_newer_words;
    const std::filesystem::path file = WriteMakerMjcf(maker, "scene", folder.path());
    MeshFiles files(file, {});
    Notes notes;
    const SourceRobot robot = ReadMjcf(file, &files, &notes);
    EXPECT_EQ(robot.name, "scene");
    EXPECT_EQ(robot.links[static_cast<std::size_t>(robot.root)].name, "pelvis");
    EXPECT_TRUE(HasNote(notes, "left out what else is in the world: 'crate'"));
    EXPECT_GE(FindLink(robot, "imu"), 0);
    const SourceJoint& hip =
        robot.joints[static_cast<std::size_t>(JointCalled(robot, "left_hip_roll"))];
    EXPECT_EQ(hip.effort_Nm, 150.0) << "of the motor, not the class";
    EXPECT_EQ(hip.armature_kgm2, 0.04);
  }
}

TEST(ReadMjcf, MujocosComplaintGetsThePlaceInTheMakersFile) {
  const TempFolder folder;
  const std::filesystem::path file =
      folder.Write("scene.xml", "<mujoco>\n<!-- a\nb -->\n<include file=\"robot.xml\"/></mujoco>");
  folder.Write("robot.xml", SmallMjcf("<geom size=\"1\" material=\"nowhere\"/>"));
  MeshFiles files(file, {});
  Notes notes;
  const std::string error = folder.ErrorOf([&] { ReadMjcf(file, &files, &notes); });
  EXPECT_NE(error.find("robot.xml:6:1: error: "), std::string::npos) << error;
  EXPECT_NE(error.find("nowhere"), std::string::npos) << error;
}

TEST(ReadMjcf, MillimetresAreTold) {
  EXPECT_EQ(
      MjcfErrorOf(SmallMjcf("<body name=\"far\" pos=\"0 0 300\"><geom size=\"1\"/></body>")),
      "robot.xml:6:1: error: body 'far' or its CoM is 300 m away, which is more than 10; lengths "
      "are in metres");
}

TEST(ReadMjcf, HostileFilesEndInOneLine) {
  std::string chain;
  for (int i = 0; i < 3000; ++i) chain += "<body><geom size=\"1\"/><joint/></body>";
  std::string many;
  for (int i = 0; i < 30000; ++i) many += "<site/>";
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<body>";
  for (const std::string& text :
       {std::string("<mujoco"), std::string("<mujoco><worldbody/>"),
        std::string("\x01\x02<mujoco/>"), "<mujoco><worldbody>" + deep, SmallMjcf(chain),
        SmallMjcf(many), SmallMjcf("<geom type=\"box\" size=\"0 0 0\"/>"),
        SmallMjcf("<geom type=\"hexagon\"/>"),
        SmallMjcf("<body><inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 9\"/></body>"),
        SmallMjcf("<body><joint name=\"a\"/></body>"), SmallMjcf("<body name=\"leg\"/>")}) {
    const std::string error = MjcfErrorOf(text);
    EXPECT_NE(error, "no error") << text.substr(0, 80);
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace sidestep::importer
