// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_meshes.h"

#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

const std::string kAsset = "<asset>\n<mesh name=\"m\" file=\"../m.stl\"/></asset>\n";

TEST(MjcfMeshes, AMeshThatIsNotThereIsComplainedOfAndTakesNoMass) {
  const TempFolder folder;
  const std::filesystem::path file =
      folder.Write("in/robot.xml", SmallMjcf("<geom type=\"mesh\" mesh=\"m\"/>", "", kAsset));
  MeshFiles files(file, {});
  Notes notes;
  const SourceRobot robot = ReadMjcf(file, &files, &notes);
  EXPECT_EQ(TotalMass_kg(robot), 5.0);
  EXPECT_EQ(files.Complaints().size(), 1U);
  EXPECT_FALSE(files.Find(LinkCalled(robot, "pelvis").collisions.at(0))) << "no stand-in is seen";
}

TEST(MjcfMeshes, OutsideTheFolderAMeshIsReadIfItsFolderIsNamed) {
  const TempFolder folder;
  const std::filesystem::path file =
      folder.Write("in/robot.xml", SmallMjcf("<geom type=\"mesh\" mesh=\"m\"/>", "", kAsset));
  WriteBoxStl(folder.path() / "m.stl", {1.0, 1.0, 1.0}, {0.0, 0.0, 0.0});
  for (const bool is_named : {false, true}) {
    MeshFiles files(file, is_named ? Packages{{"meshes", folder.path()}} : Packages{});
    Notes notes;
    const SourceRobot robot = ReadMjcf(file, &files, &notes);
    EXPECT_EQ(files.Complaints().empty(), is_named);
    EXPECT_EQ(files.Find(LinkCalled(robot, "pelvis").collisions.at(0)) != nullptr, is_named);
  }
}

TEST(MjcfMeshes, ABodyWithItsMassFromAMeshNeedsTheFile) {
  EXPECT_EQ(
      MjcfErrorOf(
          SmallMjcf("<body name=\"b\">\n<geom type=\"mesh\" mesh=\"m\"/></body>", "", kAsset)),
      "robot.xml:9: error: <geom> gives body 'b' its mass, but its mesh 'm' can't be read; give "
      "the body an <inertial>");
}

}  // namespace
}  // namespace sidestep::importer
