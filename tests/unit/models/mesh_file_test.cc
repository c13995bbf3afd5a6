// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/mesh_file.h"

#include <gtest/gtest.h>

#include "tests/support/stl_text.h"
#include "tests/support/temp_folder.h"

namespace sidestep::mesh_file_test {
namespace {

class MeshFileTest : public testing::Test {
 protected:
  std::string FaultOf(const std::string& name, const std::string& content,
                      Triangles* triangles = nullptr) const {
    Triangles unused;
    return ReadMesh(folder_.Write(name, content), triangles != nullptr ? triangles : &unused);
  }

  const TempFolder folder_;
};

constexpr char kAsciiTetrahedron[] = R"(solid part
facet normal 0 0 0
  outer loop
    vertex 0 0 0
    vertex 0 1e-1 0
    vertex +0.1 0 0
  endloop
endfacet
facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0.1 0 0 vertex 0 0 0.1 endloop endfacet
endsolid part
)";

TEST_F(MeshFileTest, StlOfBothKindsAndObjAreRead) {
  Triangles triangles;
  EXPECT_EQ(FaultOf("a.STL", StlText(Tetrahedron()), &triangles), "");
  EXPECT_TRUE(triangles.is_binary_stl);
  ASSERT_EQ(triangles.corners.size(), 12U);
  EXPECT_EQ(triangles.corners[1], Tetrahedron()[1]);
  EXPECT_EQ(FaultOf("b.stl", kAsciiTetrahedron, &triangles), "");
  EXPECT_FALSE(triangles.is_binary_stl);
  ASSERT_EQ(triangles.corners.size(), 6U);
  EXPECT_EQ(triangles.corners[2], Eigen::Vector3f(0.1F, 0, 0));
}

TEST_F(MeshFileTest, ObjFacesOfAnyLengthBecomeTriangles) {
  Triangles triangles;
  const std::string vertices = "# a comment\nv 0 0 0\nv 1 0 0\r\nv 1 1 0\nv 0 1 0\nv 0 0 1\n";
  EXPECT_EQ(FaultOf("a.obj", vertices + "vn 0 0 1\nf 1 2 3 4\nf 1/1 2/1/1 5//1\nf -5 -1 -2\n",
                    &triangles),
            "");
  ASSERT_EQ(triangles.corners.size(), 12U) << "2 of the square, 1, 1";
  EXPECT_EQ(triangles.corners[5], Eigen::Vector3f(0, 1, 0));
  EXPECT_EQ(triangles.corners[11], Eigen::Vector3f(0, 1, 0));
  for (const char* face : {"f 1 2 6", "f 0 1 2", "f a b c", "f -6 1 2"}) {
    EXPECT_EQ(FaultOf("b.obj", vertices + face), "is torn, or not in its format") << face;
  }
}

TEST_F(MeshFileTest, WhatCantBeDrawnIsToldApart) {
  EXPECT_EQ(FaultOf("a.dae", "<COLLADA/>"), "is neither STL nor OBJ");
  EXPECT_EQ(FaultOf("a.stl", ""), "is empty");
  EXPECT_EQ(FaultOf("a.stl", "solid"), "is torn, or not in its format");
  EXPECT_EQ(FaultOf("a.stl", StlText(Tetrahedron()) + "x"), "is torn, or not in its format");
  EXPECT_EQ(FaultOf("a.stl", StlText({})), "has no triangles");
  EXPECT_EQ(FaultOf("a.obj", "v 0 0 0\n"), "has no triangles");
  EXPECT_EQ(FaultOf("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n"), "is flat");
  EXPECT_EQ(FaultOf("a.obj", "v 0 0 x\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
            "has corners that are not finite, or farther away than a million");
  std::vector<Eigen::Vector3f> many;
  for (std::size_t i = 0; i <= kMaxTriangles / 4; ++i) {
    many.insert(many.end(), Tetrahedron().begin(), Tetrahedron().end());
  }
  EXPECT_EQ(FaultOf("a.stl", StlText(many)), "has more than 200000 triangles");
}

class FindMeshFileTest : public testing::Test {
 protected:
  FindMeshFileTest() {
    folder_.Write("robot/meshes/a.stl", "a");
    folder_.Write("robot/my_robot/meshes/b.stl", "b");
    folder_.Write("secret.stl", "c");
    folder_.Write("robot_2/d.stl", "d");
  }

  /// What is found, relative to the robot's folder; else why not.
  std::string Find(const std::string& filename) const {
    const std::filesystem::path robot = folder_.path() / "robot";
    const MeshFile file = FindMeshFile(filename, {robot});
    if (!file.fault.empty()) return file.fault;
    return file.path.lexically_relative(std::filesystem::canonical(robot)).string();
  }

  const TempFolder folder_;
};

TEST_F(FindMeshFileTest, PathsAndPackagesAreFoundWithinTheFolder) {
  EXPECT_EQ(Find("meshes/a.stl"), "meshes/a.stl");
  EXPECT_EQ(Find("package://my_robot/meshes/a.stl"), "meshes/a.stl");
  EXPECT_EQ(Find("package://my_robot/meshes/b.stl"), "my_robot/meshes/b.stl");
  EXPECT_EQ(Find("meshes/../meshes/a.stl"), "meshes/a.stl");
  EXPECT_EQ(Find("../meshes/a.stl"), "meshes/a.stl") << "moved without what was above";
  EXPECT_EQ(Find("package:///all_robots/my_robot/meshes/a.stl"), "meshes/a.stl");
  EXPECT_EQ(Find("meshes/c.stl"), "is not in the robot's folder");
  EXPECT_EQ(Find("meshes"), "is not in the robot's folder");
  EXPECT_EQ(Find("package://my_robot"), "is not in the robot's folder");
  EXPECT_EQ(Find(""), "is not in the robot's folder");
}

TEST_F(FindMeshFileTest, NothingOutsideIsFoundByAnyWay) {
  const std::string outside = "lies outside the robot's folder";
  EXPECT_EQ(Find("../secret.stl"), outside);
  EXPECT_EQ(Find("../robot_2/d.stl"), outside) << "though its name begins like the robot's";
  EXPECT_EQ(Find("package://my_robot/../../secret.stl"), outside);
  EXPECT_EQ(Find("package://../secret.stl"), outside);
  EXPECT_EQ(Find((folder_.path() / "secret.stl").string()), outside);
  EXPECT_EQ(Find("package://x//etc/passwd"), "is not in the robot's folder");
  std::filesystem::create_symlink(folder_.path() / "secret.stl", folder_.path() / "robot/link.stl");
  std::filesystem::create_directory_symlink(folder_.path(), folder_.path() / "robot/up");
  EXPECT_EQ(Find("link.stl"), outside);
  EXPECT_EQ(Find("up/secret.stl"), outside);
}

}  // namespace
}  // namespace sidestep::mesh_file_test
