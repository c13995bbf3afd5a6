// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// posture: where a robot's links are for given joint positions, and how they move with them.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "models/import/source_robot.h"

namespace sidestep::importer {

/// Joint positions and the pose of the root link. Joints that don't move stay at 0.
struct Posture {
  Eigen::Isometry3d X_WR{Eigen::Isometry3d::Identity()};
  Eigen::VectorXd q;  ///< rad or m, one a joint of the robot.
};

/// All joints at zero, the root at the world's origin.
Posture ZeroPosture(const SourceRobot& robot);

/// Poses X_WL of all links.
class Placement {
 public:
  Placement(const SourceRobot& robot, const Posture& posture);

  const Eigen::Isometry3d& X_WL(int link) const { return X_WL_[static_cast<std::size_t>(link)]; }
  /// Of the child link, which carries the joint's axis.
  const Eigen::Isometry3d& X_WJ(int joint) const;
  Eigen::Vector3d axis_W(int joint) const;
  Eigen::Vector3d com_W() const { return CenterOfMass_W(robot_->root); }
  /// Of `link` and all below it; its origin if nothing there has mass.
  Eigen::Vector3d CenterOfMass_W(int link) const;

  /// d(origin of `link`)/dq and d(rotation of `link`)/dq of one joint: [linear; angular], in W.
  /// Zero unless the joint is above the link.
  Eigen::Matrix<double, 6, 1> Twist(int joint, int link) const;
  /// d(CoM of the robot)/dq of one joint, in W.
  Eigen::Vector3d ComVelocity(int joint) const;

 private:
  const SourceRobot* robot_;
  std::vector<Eigen::Isometry3d> X_WL_;
  // Of each link and all below it.
  std::vector<double> mass_kg_;
  std::vector<Eigen::Vector3d> moment_W_;  // mass times CoM
};

/// Joints from `link` up to (not including what is above) `ancestor`, the lowest first.
std::vector<int> JointsBetween(const SourceRobot& robot, int ancestor, int link);

/// `link` and all links below it.
std::vector<int> Subtree(const SourceRobot& robot, int link);

/// kg, of `link` and all below it.
double SubtreeMass_kg(const SourceRobot& robot, int link);

}  // namespace sidestep::importer
