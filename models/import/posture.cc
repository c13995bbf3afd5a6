// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/posture.h"

namespace sidestep::importer {
namespace {

Eigen::Isometry3d Motion(const SourceJoint& joint, double q) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  if (joint.kind == JointKind::kPrismatic) X.translation() = q * joint.axis;
  if (joint.kind == JointKind::kRevolute || joint.kind == JointKind::kContinuous) {
    X.linear() = Eigen::AngleAxisd(q, joint.axis).toRotationMatrix();
  }
  return X;
}

const SourceJoint& JointAt(const SourceRobot& robot, int joint) {
  return robot.joints[static_cast<std::size_t>(joint)];
}

}  // namespace

Posture ZeroPosture(const SourceRobot& robot) {
  return {Eigen::Isometry3d::Identity(),
          Eigen::VectorXd::Zero(static_cast<Eigen::Index>(robot.joints.size()))};
}

Placement::Placement(const SourceRobot& robot, const Posture& posture)
    : robot_(&robot),
      X_WL_(robot.links.size(), Eigen::Isometry3d::Identity()),
      mass_kg_(robot.links.size(), 0.0),
      moment_W_(robot.links.size(), Eigen::Vector3d::Zero()) {
  for (const int link : robot.order) {
    const int above = robot.joint_above[static_cast<std::size_t>(link)];
    Eigen::Isometry3d& X = X_WL_[static_cast<std::size_t>(link)];
    if (above < 0) {
      X = posture.X_WR;
      continue;
    }
    const SourceJoint& joint = JointAt(robot, above);
    X = X_WL(joint.parent) * joint.X_PC * Motion(joint, posture.q[above]);
  }
  for (std::size_t i = robot.order.size(); i-- > 0;) {  // children first
    const auto link = static_cast<std::size_t>(robot.order[i]);
    const MassProperties& mass = robot.links[link].mass;
    mass_kg_[link] += mass.mass_kg;
    moment_W_[link] += mass.mass_kg * (X_WL_[link] * mass.com_m);
    if (robot.joint_above[link] < 0) continue;
    const auto parent = static_cast<std::size_t>(JointAt(robot, robot.joint_above[link]).parent);
    mass_kg_[parent] += mass_kg_[link];
    moment_W_[parent] += moment_W_[link];
  }
}

const Eigen::Isometry3d& Placement::X_WJ(int joint) const {
  return X_WL(JointAt(*robot_, joint).child);
}

Eigen::Vector3d Placement::axis_W(int joint) const {
  return X_WJ(joint).linear() * JointAt(*robot_, joint).axis;
}

Eigen::Vector3d Placement::CenterOfMass_W(int link) const {
  const auto index = static_cast<std::size_t>(link);
  if (mass_kg_[index] <= 0.0) return X_WL(link).translation();
  return moment_W_[index] / mass_kg_[index];
}

Eigen::Matrix<double, 6, 1> Placement::Twist(int joint, int link) const {
  int above = robot_->joint_above[static_cast<std::size_t>(link)];
  while (above >= 0 && above != joint) {
    above = robot_->joint_above[static_cast<std::size_t>(JointAt(*robot_, above).parent)];
  }
  Eigen::Matrix<double, 6, 1> twist = Eigen::Matrix<double, 6, 1>::Zero();
  if (above < 0) return twist;
  const Eigen::Vector3d axis = axis_W(joint);
  if (JointAt(*robot_, joint).kind == JointKind::kPrismatic) {
    twist.head<3>() = axis;
  } else {
    twist << axis.cross(X_WL(link).translation() - X_WJ(joint).translation()), axis;
  }
  return twist;
}

Eigen::Vector3d Placement::ComVelocity(int joint) const {
  const int child = JointAt(*robot_, joint).child;
  const double share =
      mass_kg_[static_cast<std::size_t>(child)] / mass_kg_[static_cast<std::size_t>(robot_->root)];
  const Eigen::Vector3d axis = axis_W(joint);
  if (JointAt(*robot_, joint).kind == JointKind::kPrismatic) return share * axis;
  return share * axis.cross(CenterOfMass_W(child) - X_WJ(joint).translation());
}

std::vector<int> JointsBetween(const SourceRobot& robot, int ancestor, int link) {
  std::vector<int> joints;
  while (link != ancestor && robot.joint_above[static_cast<std::size_t>(link)] >= 0) {
    joints.push_back(robot.joint_above[static_cast<std::size_t>(link)]);
    link = JointAt(robot, joints.back()).parent;
  }
  return joints;
}

std::vector<int> Subtree(const SourceRobot& robot, int link) {
  std::vector<int> links{link};
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const int joint : robot.joints_below[static_cast<std::size_t>(links[i])]) {
      links.push_back(JointAt(robot, joint).child);
    }
  }
  return links;
}

double SubtreeMass_kg(const SourceRobot& robot, int link) {
  double mass_kg = 0.0;
  for (const int below : Subtree(robot, link)) {
    mass_kg += robot.links[static_cast<std::size_t>(below)].mass.mass_kg;
  }
  return mass_kg;
}

}  // namespace sidestep::importer
