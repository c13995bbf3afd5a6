// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/looks.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_description.h"
#include "models/support/config_text.h"
#include "tests/support/stl_text.h"
#include "tests/support/temp_folder.h"

namespace sidestep::looks_test {
namespace {

const std::filesystem::path kMini =
    std::filesystem::path(SIDESTEP_SOURCE_DIR) / "tests/data/models/mini_urdf";

/// Shapes that are seen: what hides is in group 3.
int NumSeen(const mjModel& model, const std::string& body) {
  const int id = RequireId(model, mjOBJ_BODY, body);
  int seen = 0;
  for (int geom = 0; geom < model.ngeom; ++geom) {
    const int owner = model.geom_bodyid[geom];
    const bool is_looks = mj_id2name(&model, mjOBJ_BODY, owner) == nullptr;
    const int named = is_looks ? model.body_parentid[owner] : owner;
    if (named == id && model.geom_group[geom] == 1) ++seen;
  }
  return seen;
}

/// The fixture, with edits of its URDF and files beside it.
class LooksTest : public testing::Test {
 protected:
  RobotDescription Read(const std::string& from = "<robot ", const std::string& to = "<robot ",
                        const std::string& more_yaml = "") const {
    folder_.Write("mini.urdf", Edit(ReadConfigText(kMini / "mini.urdf"), from, to));
    return ReadRobotDescription(
        folder_.Write("robot.yaml", ReadConfigText(kMini / "robot.yaml") + more_yaml));
  }

  std::vector<std::string> NoticesOf(const RobotDescription& robot) const {
    std::vector<std::string> lines;
    for (const std::string& line : robot.notices) lines.push_back(folder_.Shorten(line));
    return lines;
  }

  static MjModelPtr Drawn(const RobotDescription& robot) {
    return CompileMjcf(robot.model->drawn_mjcf, "", robot.model->file);
  }

  const TempFolder folder_;
};

TEST_F(LooksTest, EveryBodyHasSomethingToSee) {
  const MjModelPtr model = Drawn(Read());
  for (const char* body : {"trunk", "leg", "foot", "arm_ft_distal", "gripper", "tail"}) {
    EXPECT_GT(NumSeen(*model, body), 0) << body;
  }
}

TEST_F(LooksTest, ALinkWithNothingToSeeHasSticksToItsJoints) {
  FileNotes notes("a.urdf");
  Body body;
  body.name = "thigh";
  body.mass.mass_kg = 1.0;
  Body knee;
  knee.joint = Joint();
  knee.X_PB.translation() << 0, 0, -0.4;
  body.children = {knee};
  FindLooks({}, &body, &notes);
  ASSERT_EQ(body.shapes.size(), 1U);
  const Shape& stick = body.shapes[0];
  EXPECT_EQ(stick.kind, ShapeKind::kCapsule);
  EXPECT_FALSE(stick.collides);
  EXPECT_NEAR(stick.size_m.y(), 0.2, 1e-12);
  EXPECT_TRUE(stick.X_BS.translation().isApprox(Eigen::Vector3d(0, 0, -0.2)));
  EXPECT_NEAR(std::abs(stick.X_BS.linear()(2, 2)), 1.0, 1e-12);
}

// A box of 0.2 x 0.3 x 0.4 m and 12 kg: I = m (b^2 + c^2) / 12.
TEST_F(LooksTest, ALeafIsTheBoxOfItsInertia) {
  FileNotes notes("a.urdf");
  Body body;
  body.mass = {12.0, {0.1, 0, 0}, Eigen::Vector3d(0.25, 0.20, 0.13).asDiagonal()};
  FindLooks({}, &body, &notes);
  ASSERT_EQ(body.shapes.size(), 2U) << "a stick to its CoM";
  const Shape& box = body.shapes[1];
  EXPECT_EQ(box.kind, ShapeKind::kBox);
  const Eigen::Vector3d along = (box.X_BS.linear() * box.size_m).cwiseAbs();
  EXPECT_TRUE(along.isApprox(Eigen::Vector3d(0.1, 0.15, 0.2), 1e-9)) << along.transpose();
  EXPECT_TRUE(box.X_BS.translation().isApprox(Eigen::Vector3d(0.1, 0, 0)));
}

TEST_F(LooksTest, AMeshWithinTheFolderIsDrawnAndChangesNoPhysics) {
  const std::string without = Read().model->simulated_mjcf;
  folder_.Write("trunk.stl", StlText(Tetrahedron()));
  const RobotDescription robot = Read();
  EXPECT_EQ(NoticesOf(robot), std::vector<std::string>{});
  EXPECT_EQ(robot.model->simulated_mjcf, without);
  const MjModelPtr model = Drawn(robot);
  ASSERT_EQ(model->nmesh, 1);
  EXPECT_EQ(model->mesh_facenum[0], 4);
  EXPECT_EQ(NumSeen(*model, "trunk"), 2) << "a box and the mesh";
  EXPECT_NEAR(mj_getTotalmass(model.get()), 3.3, 1e-12);
}

TEST_F(LooksTest, WhatIsNoBinaryStlIsDrawnToo) {
  folder_.Write("part.obj",
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const RobotDescription robot =
      Read("<mesh filename=\"trunk.stl\"/>",
           "<mesh filename=\"package://mini/part.obj\" scale=\"0.1 -0.1 0.1\"/>");
  const MjModelPtr model = Drawn(robot);
  ASSERT_EQ(model->nmesh, 1);
  EXPECT_EQ(model->mesh_facenum[0], 4);
  EXPECT_EQ(NoticesOf(robot), std::vector<std::string>{});
}

TEST_F(LooksTest, MeshesThatCantBeDrawnAreNamedAtOnce) {
  const std::string mesh = "<mesh filename=\"trunk.stl\"/>";
  EXPECT_EQ(NoticesOf(Read()),
            std::vector<std::string>{"mini.urdf:10:5: notice: no mesh is drawn that is not in the "
                                     "robot's folder: trunk.stl (meshes: FOLDER in robot.yaml "
                                     "names another folder)"});
  folder_.Write("a.dae", "<COLLADA/>");
  EXPECT_EQ(NoticesOf(Read(mesh, "<mesh filename=\"a.dae\"/>")),
            std::vector<std::string>{
                "mini.urdf:10:5: notice: no mesh is drawn that is neither STL nor OBJ: a.dae"});
  EXPECT_EQ(NoticesOf(Read(mesh, "<mesh filename=\"/etc/passwd\"/>")),
            std::vector<std::string>{"mini.urdf:10:5: notice: no mesh is drawn that lies outside "
                                     "the robot's folder: /etc/passwd (meshes: FOLDER in "
                                     "robot.yaml names another folder)"});
  folder_.Write("tiny.stl", StlText(Tetrahedron()));
  EXPECT_EQ(NoticesOf(Read(mesh, "<mesh filename=\"tiny.stl\" scale=\"0.001 0.001 0.001\"/>")),
            std::vector<std::string>{"mini.urdf:10:5: notice: no mesh is drawn that is smaller "
                                     "than a millimetre: tiny.stl"});
}

TEST_F(LooksTest, AFolderThatTheUserNamesHoldsMeshesToo) {
  const TempFolder elsewhere;
  elsewhere.Write("trunk.stl", StlText(Tetrahedron()));
  const RobotDescription robot =
      Read("<robot ", "<robot ", "meshes: " + elsewhere.path().string() + "\n");
  EXPECT_EQ(NoticesOf(robot), std::vector<std::string>{});
  EXPECT_EQ(folder_.ErrorOf([&] { Read("<robot ", "<robot ", "meshes: nowhere\n"); }),
            "robot.yaml:35:9: error: meshes = 'nowhere' is no folder");
}

}  // namespace
}  // namespace sidestep::looks_test
