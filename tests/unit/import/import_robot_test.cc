// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/import_robot.h"

#include <algorithm>

#include "models/robot_description/home_pose.h"
#include "models/robot_description/robot_description.h"
#include "tests/support/maker_mjcf.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

/// Imports into `folder`/out.
ImportReport ImportInto(const TempFolder& folder, const MakerRobot& maker) {
  ImportOptions options;
  options.source = WriteMakerRobot(maker, folder.path() / "maker");
  options.folder = folder.path() / "out";
  return ImportRobot(options);
}

void ExpectHome(const RobotDescription& robot) {
  const HomePose home(robot);
  for (const FootDescription& foot : robot.feet) {
    const Eigen::Isometry3d X_WF = home.X_WO(foot.frame);
    EXPECT_NEAR(X_WF.translation().z(), 0.0, 1e-6) << robot.name;
    EXPECT_TRUE(X_WF.linear().isIdentity(1e-6)) << robot.name;
  }
  EXPECT_TRUE(home.X_WO(robot.torso).linear().isIdentity(1e-6));
}

std::vector<MakerRobot> Makers() {
  std::vector<MakerRobot> makers(6);
  makers[0].has_mesh_shapes = true;
  makers[0].foot = MakerFoot::kMesh;
  makers[0].has_gram_frames = true;
  makers[1].is_rooted_in_trunk = true;
  makers[2].foot = MakerFoot::kSpheres;
  makers[2].bends_hips_first = true;
  makers[2].has_wild_limits = true;
  makers[3].has_fingers = true;
  makers[3].has_floating_root = true;
  makers[3].size = 0.7;
  makers[4].foot = MakerFoot::kNone;
  makers[4].size = 0.4;
  makers[5].foot = MakerFoot::kMarks;
  makers[5].is_drawn_from_floor = true;
  makers[5].has_odd_names = true;
  return makers;
}

TEST(ImportRobot, EveryStructureReadsBackStandingOnItsSoles) {
  for (const MakerRobot& maker : Makers()) {
    const TempFolder folder;
    ImportInto(folder, maker);
    const RobotDescription robot = ReadRobotDescription(folder.path() / "out/robot.yaml");
    EXPECT_EQ(robot.joints.size(), 21U);
    EXPECT_NEAR(robot.feet[0].vertices_m.row(0).maxCoeff(), 0.1 * maker.size, 0.011);
    ExpectHome(robot);
  }
}

TEST(ImportRobot, FourBallsCarryAsFarAsTheyReach) {
  const TempFolder folder;
  ImportInto(folder, Makers()[2]);
  const RobotDescription robot = ReadRobotDescription(folder.path() / "out/robot.yaml");
  EXPECT_NEAR(robot.feet[0].vertices_m.row(0).maxCoeff(), 0.105 - 0.005, 1e-6);
  EXPECT_NEAR(robot.feet[0].vertices_m.row(1).maxCoeff(), 0.045 - 0.005, 1e-6);
}

TEST(ImportRobot, SaysWhatItDid) {
  const TempFolder folder;
  const ImportReport report = ImportInto(folder, Makers()[0]);
  const auto has = [](const Notes& notes, const std::string& part) {
    return std::any_of(notes.begin(), notes.end(), [&](const std::string& note) {
      return note.find(part) != std::string::npos;
    });
  };
  EXPECT_TRUE(has(report.done, "passed over 1 <transmission>"));
  EXPECT_TRUE(has(report.done, "made point masses of 'camera'"));
  EXPECT_TRUE(has(report.done, "'left_foot' stands on a box of 220 mm x 100 mm instead of meshes"));
  EXPECT_TRUE(has(report.done, "fitted boxes and capsules to the meshes of 'trunk'"));
  EXPECT_TRUE(has(report.done, "meshes to draw"));
  EXPECT_TRUE(has(report.found, "left leg: left_hip_yaw"));
  EXPECT_TRUE(has(report.to_decide, "armature_kgm2"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/meshes/left_thigh.stl"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "out/maker_walk.yaml"));
}

TEST(ImportRobot, WritesNothingWhereItRefuses) {
  const TempFolder folder;
  MakerRobot maker;
  maker.leg_joints = 5;
  EXPECT_NE(folder.ErrorOf([&] { ImportInto(folder, maker); }), "no error");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "out"));
}

TEST(ImportRobot, IsTheSameEveryTime) {
  const TempFolder first, second;
  ImportInto(first, Makers()[0]);
  ImportInto(second, Makers()[0]);
  for (const char* file : {"out/robot.yaml", "out/robot.urdf", "out/maker_walk.yaml"}) {
    EXPECT_EQ(ReadTextFile(first.path() / file), ReadTextFile(second.path() / file));
  }
}

Notes DoneWith(double armature_kgm2) {
  const TempFolder folder;
  MakerMjcf maker;
  maker.armature_kgm2 = armature_kgm2;
  ImportOptions options;
  options.source = WriteMakerMjcf(maker, "maker", folder.path() / "maker");
  options.folder = folder.path() / "out";
  return ImportRobot(options).done;
}

TEST(ImportRobot, StepsAsSlowlyAsHeavyRotorsDo) {
  EXPECT_TRUE(HasNote(DoneWith(6.0), "chose a swing of 0.4"));
  EXPECT_FALSE(HasNote(DoneWith(0.04), "chose a swing"));
}

}  // namespace
}  // namespace sidestep::importer
