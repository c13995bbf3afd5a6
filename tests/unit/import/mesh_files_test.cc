// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mesh_files.h"

#include "tests/support/maker_robot.h"
#include "tests/support/temp_folder.h"

namespace sidestep::importer {
namespace {

class MeshFilesTest : public testing::Test {
 protected:
  MeshFilesTest() {
    folder_.Write("robot/robot.urdf", "");
    WriteBoxStl(folder_.path() / "robot/meshes/in.stl", {1, 1, 1}, {0, 0, 0});
    WriteBoxStl(folder_.path() / "robot/pkg/meshes/in.stl", {1, 1, 1}, {0, 0, 0});
    WriteBoxStl(folder_.path() / "other/out.stl", {1, 1, 1}, {0, 0, 0});
    std::filesystem::create_symlink(folder_.path() / "other/out.stl",
                                    folder_.path() / "robot/link.stl");
  }

  bool Finds(const std::string& uri, const Packages& packages = {}) {
    MeshFiles files(folder_.path() / "robot/robot.urdf", packages);
    SourceShape shape;
    shape.kind = ShapeKind::kMesh;
    shape.mesh = uri;
    const bool is_found = files.Find(shape) != nullptr;
    complaints_ = files.Complaints();
    return is_found;
  }

  TempFolder folder_;
  std::vector<std::string> complaints_;
};

TEST_F(MeshFilesTest, ReadsTheUrdfsOwnFolder) {
  EXPECT_TRUE(Finds("meshes/in.stl"));
  EXPECT_TRUE(Finds("package://pkg/meshes/in.stl"));
  EXPECT_TRUE(Finds("package://anything/meshes/in.stl"));
  EXPECT_TRUE(Finds("file://" + (folder_.path() / "robot/meshes/in.stl").string()));
  EXPECT_TRUE(complaints_.empty());
}

TEST_F(MeshFilesTest, ReadsNothingElseUnlessItIsNamed) {
  for (const std::string& uri :
       {std::string("../other/out.stl"), (folder_.path() / "other/out.stl").string(),
        std::string("link.stl"), std::string("package://x/../../other/out.stl")}) {
    EXPECT_FALSE(Finds(uri)) << uri;
    ASSERT_EQ(complaints_.size(), 1U);
    EXPECT_NE(complaints_[0].find("--package"), std::string::npos) << complaints_[0];
  }
  EXPECT_TRUE(Finds("../other/out.stl", {{"other", folder_.path() / "other"}}));
  EXPECT_TRUE(Finds("package://other/out.stl", {{"other", folder_.path() / "other"}}));
}

TEST_F(MeshFilesTest, SaysWhichAreMissing) {
  EXPECT_FALSE(Finds("meshes/none.stl"));
  EXPECT_EQ(complaints_[0], "could not read 'meshes/none.stl': no such file in the model's folder");
  EXPECT_FALSE(Finds("package://p/none.stl"));
  EXPECT_EQ(
      complaints_[0],
      "could not read 'package://p/none.stl': name the folder of its package: --package p=FOLDER");
}

}  // namespace
}  // namespace sidestep::importer
