// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_bodies.h"

#include <random>

#include "models/import/import_robot.h"
#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_description.h"
#include "tests/support/maker_mjcf.h"
#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

/// The mass matrix at a posture: base where it is at first, joints by name, the base's part first.
Eigen::MatrixXd MassMatrix(const mjModel& model, const std::vector<std::string>& joints,
                           const Eigen::VectorXd& q) {
  const MjDataPtr data = MakeData(model);
  std::vector<int> dofs{0, 1, 2, 3, 4, 5};
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const int id = RequireId(model, mjOBJ_JOINT, joints[i]);
    data->qpos[model.jnt_qposadr[id]] = q[static_cast<Eigen::Index>(i)];
    dofs.push_back(model.jnt_dofadr[id]);
  }
  mj_forward(&model, data.get());
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> M(model.nv, model.nv);
  mj_fullM(&model, M.data(), data->qM);
  Eigen::MatrixXd sorted(dofs.size(), dofs.size());
  for (std::size_t i = 0; i < dofs.size(); ++i) {
    for (std::size_t k = 0; k < dofs.size(); ++k) {
      sorted(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = M(dofs[i], dofs[k]);
    }
  }
  return sorted;
}

/// Masses, CoMs, inertias, axes, anchors and armatures are all in it.
TEST(MjcfBodies, TheImportedRobotHasTheSourcesMassMatrixAtRandomPostures) {
  for (const bool shares_hips : {false, true}) {
    const TempFolder folder;
    MakerMjcf maker;
    maker.shares_hips = shares_hips;
    maker.has_head = false;  // a neck would be locked
    ImportOptions options;
    options.source = folder.Write("maker.xml", RobotMjcf(maker));
    options.folder = folder.path() / "out";
    ImportRobot(options);
    const RobotDescription robot = ReadRobotDescription(options.folder / "robot.yaml");
    const MjModelPtr ours = CompileMjcf(robot.model->simulated_mjcf, "", "ours");
    const MjModelPtr theirs = CompileMjcf(RobotMjcf(maker), "", "theirs");
    EXPECT_NEAR(mj_getTotalmass(ours.get()), mj_getTotalmass(theirs.get()), 1e-8);
    std::vector<std::string> joints;
    for (const JointDescription& joint : robot.joints) joints.push_back(joint.name);
    ASSERT_EQ(joints.size(), 19U);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> angle(-0.6, 0.6);
    for (int i = 0; i < 5; ++i) {
      const Eigen::VectorXd q =
          Eigen::VectorXd::NullaryExpr(19, [&](Eigen::Index) { return angle(random); });
      const Eigen::MatrixXd M = MassMatrix(*theirs, joints, q);
      // Entries are up to 54 kg; the links between joints weigh 1e-9 kg each.
      EXPECT_LT((MassMatrix(*ours, joints, q) - M).cwiseAbs().maxCoeff(), 2e-8) << shares_hips;
      EXPECT_GT(M.cwiseAbs().maxCoeff(), 50.0);
    }
  }
}

TEST(MjcfBodies, JointsThatShareABodyTurnInTheirOrder) {
  const SourceRobot robot = SourceOfMjcf(
      SmallMjcf("<body name=\"b\" pos=\"0 0 1\"><joint name=\"j1\" axis=\"0 0 1\" pos=\"0.1 0 "
                "0\"/><joint name=\"j2\" axis=\"0 1 0\" pos=\"0 0.2 0\"/><geom size=\"0.1\" "
                "pos=\"1 0 0\" mass=\"1\"/></body>\n"));
  const SourceJoint& first = robot.joints[static_cast<std::size_t>(JointCalled(robot, "j1"))];
  const SourceJoint& second = robot.joints[static_cast<std::size_t>(JointCalled(robot, "j2"))];
  EXPECT_EQ(first.child, second.parent) << "the first is the outer one";
  EXPECT_TRUE(first.X_PC.translation().isApprox(Eigen::Vector3d(0.1, 0.0, 1.0)));
  EXPECT_TRUE(second.X_PC.translation().isApprox(Eigen::Vector3d(-0.1, 0.2, 0.0)));
  EXPECT_TRUE(LinkCalled(robot, "b").mass.com_m.isApprox(Eigen::Vector3d(1.0, -0.2, 0.0)));
  const SourceLink& between = robot.links[static_cast<std::size_t>(first.child)];
  EXPECT_EQ(between.name, "b_j1");
  EXPECT_LE(between.mass.mass_kg, 1e-9);
}

TEST(MjcfBodies, PositionsCountFromTheReference) {
  const SourceRobot robot = SourceOfMjcf(
      SmallMjcf("<body><geom size=\"0.1\"/><joint name=\"k\" ref=\"30\" range=\"10 90\"/></body>"));
  const SourceJoint& knee = robot.joints[static_cast<std::size_t>(JointCalled(robot, "k"))];
  constexpr double kDegree = 0.017453292519943295;
  EXPECT_NEAR(knee.lower, -20.0 * kDegree, 1e-12);
  EXPECT_NEAR(knee.upper, 60.0 * kDegree, 1e-12);
}

TEST(MjcfBodies, ATurnedRootGetsTheWorldsAxes) {
  Notes notes;
  const SourceRobot robot = SourceOfMjcf(
      "<mujoco><worldbody><body name=\"r\" euler=\"0 90 0\"><freejoint/><geom size=\"0.1\" pos=\"1 "
      "0 0\" mass=\"1\"/><body><joint name=\"h\"/><geom size=\"0.1\"/></body></body></worldbody>"
      "</mujoco>",
      &notes);
  // Its x points down: the ball hangs 1 m below.
  EXPECT_TRUE(LinkCalled(robot, "r").mass.com_m.isApprox(Eigen::Vector3d(0.0, 0.0, -1.0)));
  EXPECT_TRUE(HasNote(notes, "turned the axes of 'r' to the world's"));
}

TEST(MjcfBodies, TheHeaviestWithHingesIsTheRobotAndItFloats) {
  Notes notes;
  const SourceRobot robot = SourceOfMjcf(
      "<mujoco><worldbody><geom size=\"9\" type=\"sphere\"/><body name=\"crate\"><freejoint/><geom "
      "size=\"3\"/></body><body name=\"bot\"><joint type=\"slide\"/><joint type=\"ball\"/><geom "
      "size=\"0.1\"/><body name=\"arm\"><joint/><geom size=\"0.1\"/></body></body></worldbody>"
      "</mujoco>",
      &notes);
  EXPECT_EQ(robot.links.size(), 2U);
  EXPECT_EQ(robot.joints.size(), 1U);
  EXPECT_TRUE(HasNote(notes, "left out what else is in the world: 'crate'"));
  EXPECT_TRUE(HasNote(notes, "took the base's 2 joints for a floating base"));
}

TEST(MjcfBodies, BallsAndWorldsWithoutARobotAreRefused) {
  EXPECT_EQ(MjcfErrorOf(SmallMjcf("<body><geom size=\"1\"/>\n<joint name=\"b\" "
                                  "type=\"ball\"/></body>")),
            "robot.xml:7:1: error: joint 'b' is a ball; make it three hinges, or delete it");
  EXPECT_EQ(MjcfErrorOf("<mujoco/>"),
            "robot.xml:1:1: error: has no robot: no body in the world carries hinges");
}

TEST(MjcfBodies, NamesBecomePlainAndDifferent) {
  const SourceRobot robot =
      SourceOfMjcf(SmallMjcf("<body name=\"a/b\"/><body name=\"a b\"/><site name=\"leg\"/>"));
  EXPECT_GE(FindLink(robot, "a_b"), 0);
  EXPECT_GE(FindLink(robot, "a_b_2"), 0);
  EXPECT_GE(FindLink(robot, "leg_2"), 0) << "the site";
}

}  // namespace
}  // namespace sidestep::importer
