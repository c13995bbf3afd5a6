// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mesh.h"

#include <cmath>
#include <numbers>

#include "tests/support/maker_robot.h"
#include "tests/support/temp_folder.h"

namespace sidestep::importer {
namespace {

/// Six times the volume: positive if triangles turn outwards.
double Volume6(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < mesh.corners.size(); i += 3) {
    const auto corner = [&](std::size_t k) {
      return mesh.vertices[mesh.corners[i + k]].cast<double>();
    };
    sum += corner(0).dot(corner(1).cross(corner(2)));
  }
  return sum;
}

Mesh Ball(int rings) {
  Mesh mesh;
  const int around = 2 * rings;
  for (int i = 0; i <= rings; ++i) {
    for (int k = 0; k < around; ++k) {
      const double polar = std::numbers::pi * i / rings, angle = 2 * std::numbers::pi * k / around;
      mesh.vertices.emplace_back(std::sin(polar) * std::cos(angle),
                                 std::sin(polar) * std::sin(angle), std::cos(polar));
      const auto at = [&](int row, int column) {
        return static_cast<unsigned>(row * around + column % around);
      };
      if (i == rings) continue;
      for (const unsigned corner :
           {at(i, k), at(i + 1, k), at(i, k + 1), at(i, k + 1), at(i + 1, k), at(i + 1, k + 1)}) {
        mesh.corners.push_back(corner);
      }
    }
  }
  return mesh;
}

TEST(Mesh, ReadsWhatItWrites) {
  const TempFolder folder;
  std::string why;
  WriteBoxStl(folder.path() / "box.stl", {0.1, 0.2, 0.3}, {1, 2, 3});
  const std::optional<Mesh> box = LoadMesh(folder.path() / "box.stl", &why);
  ASSERT_TRUE(box) << why;
  EXPECT_EQ(box->vertices.size(), 8U);  // STL has 36
  EXPECT_EQ(box->num_triangles(), 12U);
  WriteStl(*box, folder.path() / "again.stl");
  const std::optional<Mesh> again = LoadMesh(folder.path() / "again.stl", &why);
  ASSERT_TRUE(again) << why;
  EXPECT_NEAR(Volume6(*again), Volume6(*box), 1e-6);
}

TEST(Mesh, ReadsObjAndIgnoresItsMaterialFile) {
  const TempFolder folder;
  folder.Write("secret.mtl", "newmtl m\n");
  const auto file = folder.Write(
      "sub/a.obj", "mtllib ../secret.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\n");
  std::string why;
  const std::optional<Mesh> mesh = LoadMesh(file, &why);
  ASSERT_TRUE(mesh) << why;
  EXPECT_EQ(mesh->num_triangles(), 2U);
}

TEST(Mesh, ReadsColladaInItsUnitWithoutTurningIt) {
  const TempFolder folder;
  const auto file = folder.Write("a.dae", R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="millimeter" meter="0.001"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 1000 0 0 0 0 500</float_array>
<technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)");
  std::string why;
  const std::optional<Mesh> mesh = LoadMesh(file, &why);
  ASSERT_TRUE(mesh) << why;
  float x = 0.0F, z = 0.0F;
  for (const Eigen::Vector3f& v : mesh->vertices) {
    x = std::max(x, v.x());
    z = std::max(z, v.z());
  }
  EXPECT_NEAR(x, 1.0F, 1e-5F);
  EXPECT_NEAR(z, 0.5F, 1e-5F);
}

TEST(Mesh, SaysWhyAFileIsNone) {
  const TempFolder folder;
  std::string why;
  EXPECT_FALSE(LoadMesh(folder.path() / "none.stl", &why));
  EXPECT_EQ(why, "can't be read");
  EXPECT_FALSE(
      LoadMesh(folder.Write("lfs.stl", "version https://git-lfs.github.com/spec/v1\n"), &why));
  EXPECT_EQ(why, "is only a pointer of Git LFS; fetch the file itself");
  EXPECT_FALSE(LoadMesh(folder.Write("junk.stl", std::string(200, 'x')), &why));
  EXPECT_FALSE(LoadMesh(folder.Write("empty.obj", ""), &why));
}

TEST(Mesh, DecimatesToWhatIsAskedFor) {
  const Mesh ball = Ball(60);
  const Mesh small = Decimated(ball, 500);
  EXPECT_LE(small.num_triangles(), 750U);
  EXPECT_GE(small.num_triangles(), 100U);
  EXPECT_NEAR(Volume6(small) / Volume6(ball), 1.0, 0.05);
}

TEST(Mesh, AMirroredMeshIsStillOutsideOut) {
  const Mesh ball = Ball(10);
  EXPECT_GT(Volume6(ball), 0.0);
  EXPECT_NEAR(Volume6(Scaled(ball, {1, -2, 1})), 2.0 * Volume6(ball), 1e-4);
}

}  // namespace
}  // namespace sidestep::importer
