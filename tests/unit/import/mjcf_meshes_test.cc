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
      "robot.xml:9:1: error: <geom> gives body 'b' its mass, but its mesh 'm' can't be read; give "
      "the body an <inertial>");
}

TEST(MjcfMeshes, AllShapesThatWouldWeighAreTold) {
  const std::string asset = "<asset><mesh name=\"m\" file=\"m.stl\"/></asset>\n";
  const std::string shapes =
      "<geom class=\"mesh\"/>\n"
      "<frame childclass=\"mesh\">\n<geom/></frame>\n"
      "<geom type=\"mesh\" mesh=\"m\" mass=\"2\"/>\n";
  const std::string classes =
      "<default><default class=\"mesh\"><geom type=\"mesh\" mesh=\"m\"/></default></default>\n";
  const auto line = [](int number) {
    return "robot.xml:" + std::to_string(number) +
           ":1: error: <geom> gives body 'b' its mass, but its mesh 'm' can't be read; give the "
           "body "
           "an <inertial>";
  };
  EXPECT_EQ(MjcfErrorOf(SmallMjcf("<body name=\"b\">\n" + shapes + "</body>", "", classes + asset)),
            line(9) + "\n" + line(11) + "\n" + line(12));
}

TEST(MjcfMeshes, WhereShapesWeighInSpiteOfAnInertialTheyAreTold) {
  const std::string error = MjcfErrorOf(SmallMjcf("<geom type=\"mesh\" mesh=\"m\"/>",
                                                  "<compiler inertiafromgeom=\"true\"/>", kAsset));
  EXPECT_EQ(error,
            "robot.xml:8:1: error: <geom> gives body 'pelvis' its mass, but its mesh 'm' can't be "
            "read; take inertiafromgeom out of <compiler>, or give the geom mass=\"0\"");
}

TEST(MjcfMeshes, ShapesThatOnlyShowMayBeMissing) {
  const std::string classes =
      "<default><default class=\"seen\"><geom type=\"mesh\" mesh=\"m\" "
      "density=\"0\"/></default></default>\n";
  const auto mass_kg = [&](const std::string& geom) {
    return LinkCalled(SourceOfMjcf(SmallMjcf(
                          "<body name=\"b\"><geom size=\"0.1\" mass=\"4\"/>" + geom + "</body>", "",
                          classes + kAsset)),
                      "b")
        .mass.mass_kg;
  };
  EXPECT_EQ(mass_kg("<geom class=\"seen\"/>"), 4.0);
  EXPECT_EQ(mass_kg("<geom type=\"mesh\" mesh=\"m\" mass=\"0\"/>"), 4.0);
}

}  // namespace
}  // namespace sidestep::importer
