// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_shapes.h"

#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

SourceLink PelvisWith(const std::string& geoms, const std::string& after = "") {
  return LinkCalled(SourceOfMjcf(SmallMjcf(geoms, after)), "pelvis");
}

TEST(MjcfShapes, WhatCollidesAndWhatIsSeenAreToldApart) {
  const SourceLink pelvis = PelvisWith(
      "<geom type=\"box\" size=\"1 2 3\" group=\"3\"/><geom size=\"4\" contype=\"0\" "
      "conaffinity=\"0\" rgba=\"1 0 0 1\"/><geom size=\"5\" contype=\"0\" "
      "conaffinity=\"0\" group=\"4\"/>");
  ASSERT_EQ(pelvis.collisions.size(), 1U);
  EXPECT_EQ(pelvis.collisions[0].size_m, Eigen::Vector3d(2, 4, 6));
  ASSERT_EQ(pelvis.visuals.size(), 1U);
  EXPECT_EQ(pelvis.visuals[0].size_m.x(), 4.0);
  EXPECT_EQ(*pelvis.visuals[0].rgba, Eigen::Vector4d(1, 0, 0, 1));
}

TEST(MjcfShapes, APairMakesAShapeCollide) {
  const std::string geoms =
      "<geom name=\"a\" size=\"1\" contype=\"0\" conaffinity=\"0\"/><body><geom name=\"b\" "
      "size=\"1\" pos=\"0 0 9\"/></body>";
  EXPECT_TRUE(PelvisWith(geoms).collisions.size() == 1U) << "the body without a name is of it";
  EXPECT_EQ(
      PelvisWith(geoms, "<contact><pair geom1=\"a\" geom2=\"b\"/></contact>").collisions.size(),
      2U);
}

TEST(MjcfShapes, HiddenShapesCollideWhereNothingElseDoes) {
  const std::string no_contact = "contype=\"0\" conaffinity=\"0\"";
  const std::string hidden = "<geom size=\"1\" group=\"3\" " + no_contact + "/>";
  EXPECT_EQ(PelvisWith(hidden + "<geom size=\"2\" " + no_contact + "/>").collisions.size(), 1U);
  EXPECT_EQ(PelvisWith(hidden + "<geom size=\"2\"/>").collisions.at(0).size_m.x(), 2.0);
}

TEST(MjcfShapes, ALinkWithNothingElseToSeeShowsWhatCollides) {
  const SourceLink pelvis = PelvisWith("<geom size=\"1\" rgba=\"0 1 0 1\"/>");
  ASSERT_EQ(pelvis.visuals.size(), 1U);
  EXPECT_EQ(*pelvis.visuals[0].rgba, Eigen::Vector4d(0, 1, 0, 1));
  EXPECT_TRUE(PelvisWith("<geom size=\"1\" group=\"3\"/>").visuals.empty());
}

TEST(MjcfShapes, SizesAreOfURDFs) {
  const SourceLink pelvis = PelvisWith(
      "<geom type=\"capsule\" fromto=\"0 0 0 0 0 2\" size=\"0.3\"/><geom type=\"cylinder\" "
      "size=\"0.3 1\"/><geom type=\"ellipsoid\" size=\"0.1 0.2 0.3\"/>");
  ASSERT_EQ(pelvis.collisions.size(), 3U);
  EXPECT_NEAR(pelvis.collisions[0].size_m.y(), 2.6, 1e-12) << "with its round ends";
  EXPECT_NEAR(pelvis.collisions[0].X_LS.translation().z(), 1.0, 1e-12);
  EXPECT_NEAR(pelvis.collisions[1].size_m.y(), 2.0, 1e-12);
  EXPECT_NEAR(pelvis.collisions[2].size_m.maxCoeff(), 0.6, 0.01) << "fits around it";
}

TEST(MjcfShapes, MeshesKeepTheirPlace) {
  const TempFolder folder;
  const std::filesystem::path file = folder.Write(
      "robot.xml", SmallMjcf("<geom type=\"mesh\" mesh=\"box\" pos=\"0 0 5\"/>", "",
                             "<compiler meshdir=\"stl\"/><asset><mesh file=\"box.stl\" scale=\"2 2 "
                             "2\"/></asset>\n"));
  std::filesystem::create_directories(folder.path() / "stl");
  WriteBoxStl(folder.path() / "stl/box.stl", {0.1, 0.2, 0.4}, {1.0, 0.0, 0.0});
  MeshFiles files(file, {});
  Notes notes;
  const SourceRobot robot = ReadMjcf(file, &files, &notes);
  const SourceShape& shape = LinkCalled(robot, "pelvis").collisions.at(0);
  const auto mesh = files.Find(shape);
  ASSERT_TRUE(mesh);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3f& vertex : mesh->vertices)
    box.extend(shape.X_LS * vertex.cast<double>());
  EXPECT_TRUE(box.center().isApprox(Eigen::Vector3d(2.0, 0.0, 5.0), 1e-6));  // floats
  EXPECT_TRUE(box.sizes().isApprox(Eigen::Vector3d(0.2, 0.4, 0.8), 1e-6));
}

}  // namespace
}  // namespace sidestep::importer
