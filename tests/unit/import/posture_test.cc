// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/posture.h"

#include <random>

#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

Posture RandomPosture(const SourceRobot& robot) {
  std::mt19937 random(7);
  Posture posture = ZeroPosture(robot);
  for (Eigen::Index i = 0; i < posture.q.size(); ++i) {
    posture.q[i] = static_cast<double>(random()) / static_cast<double>(random.max()) - 0.5;
  }
  posture.X_WR.linear() =
      Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  posture.X_WR.translation() << 0.1, 0.2, 0.3;
  return posture;
}

TEST(Posture, PlacesTheFootBelowThePelvisAtZero) {
  const SourceRobot robot = SourceOf(MakerRobot());
  const Placement zero(robot, ZeroPosture(robot));
  const Eigen::Vector3d foot = zero.X_WL(FindLink(robot, "left_foot")).translation();
  EXPECT_LT((foot - Eigen::Vector3d(0.0, 0.09, -0.76)).norm(), 1e-12);
}

TEST(Posture, VelocitiesAgreeWithDifferences) {
  const SourceRobot robot = SourceOf(MakerRobot());
  const Posture posture = RandomPosture(robot);
  const Placement here(robot, posture);
  const int foot = FindLink(robot, "left_foot");
  constexpr double kStep = 1e-6;
  for (Eigen::Index j = 0; j < posture.q.size(); ++j) {
    const int joint = static_cast<int>(j);
    if (!robot.joints[static_cast<std::size_t>(j)].is_moving()) continue;
    Posture ahead = posture, behind = posture;
    ahead.q[j] += kStep;
    behind.q[j] -= kStep;
    const Placement plus(robot, ahead), minus(robot, behind);
    const Eigen::Vector3d com = (plus.com_W() - minus.com_W()) / (2 * kStep);
    EXPECT_LT((here.ComVelocity(joint) - com).norm(), 1e-8);
    const Eigen::Vector3d linear =
        (plus.X_WL(foot).translation() - minus.X_WL(foot).translation()) / (2 * kStep);
    const Eigen::AngleAxisd turn(
        Eigen::Matrix3d(plus.X_WL(foot).linear() * minus.X_WL(foot).linear().transpose()));
    const Eigen::Matrix<double, 6, 1> twist = here.Twist(joint, foot);
    EXPECT_LT((twist.head<3>() - linear).norm(), 1e-8);
    EXPECT_LT((twist.tail<3>() - turn.angle() * turn.axis() / (2 * kStep)).norm(), 1e-8);
  }
}

TEST(Posture, MassOfSubtreesAddsUp) {
  const SourceRobot robot = SourceOf(MakerRobot());
  EXPECT_NEAR(SubtreeMass_kg(robot, robot.root), TotalMass_kg(robot), 1e-12);
  EXPECT_EQ(Subtree(robot, robot.root).size(), robot.links.size());
}

}  // namespace
}  // namespace sidestep::importer
