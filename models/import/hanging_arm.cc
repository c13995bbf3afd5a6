// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/hanging_arm.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "models/import/joint_ranges.h"

namespace sidestep::importer {
namespace {

constexpr int kRounds = 8;
constexpr int kArmSamples = 30;
constexpr double kPosture = 0.02;  // per rad^2, of costs near 1: decides where nothing else does
constexpr double kNear = 0.2;      // of the farthest point: says little of where the arm points
constexpr double kSpread = 4.0;    // per (m/m)^2 that the arm points too far in or out
constexpr double kAhead = 0.5;     // the same forwards or backwards

/// What points down: from the shoulder to each joint beyond that is not near it, and to the CoM of
/// the arm's end. A shoulder's last joint is the third, in a simple arm the one before the elbow.
std::vector<Eigen::Vector3d> DirectionsOf(const Placement& placement, const Limb& arm) {
  std::vector<Eigen::Vector3d> points;
  for (const int joint : arm.joints) points.emplace_back(placement.X_WJ(joint).translation());
  points.push_back(placement.CenterOfMass_W(arm.end));
  const std::size_t shoulder =
      std::min<std::size_t>(2, std::max<std::size_t>(2, arm.joints.size()) - 2);
  double reach_m = 0.0;
  for (const Eigen::Vector3d& point : points) {
    reach_m = std::max(reach_m, (point - points[shoulder]).norm());
  }
  std::vector<Eigen::Vector3d> directions;
  for (std::size_t i = shoulder + 1; i < points.size(); ++i) {
    const Eigen::Vector3d along = points[i] - points[shoulder];
    if (along.norm() < kNear * reach_m) continue;
    directions.emplace_back(along / std::max(along.norm(), 1e-9));
  }
  return directions;
}

double CostOf(const SourceRobot& robot, const Limb& arm, double spread_rad,
              const Posture& posture) {
  const Placement placement(robot, posture);
  const double side = placement.X_WL(arm.end).translation().y() >= 0.0 ? 1.0 : -1.0;
  double cost = 0.0;
  for (const Eigen::Vector3d& direction : DirectionsOf(placement, arm)) {
    const double out = side * direction.y() - std::sin(spread_rad);
    cost += direction.z() + kSpread * out * out + kAhead * direction.x() * direction.x();
  }
  for (const int joint : arm.joints) cost += kPosture * posture.q[joint] * posture.q[joint];
  return cost;
}

}  // namespace

void HangArm(const SourceRobot& robot, const Limb& arm, double spread_rad, Posture* posture) {
  double least = arm.joints.empty() ? 0.0 : CostOf(robot, arm, spread_rad, *posture);
  double reach = 1.0;  // of the range, about where the joint is: shrinks round by round
  for (int round = 0; round < kRounds; ++round) {
    for (const int index : arm.joints) {
      const SourceJoint& joint = robot.joints[static_cast<std::size_t>(index)];
      const double middle = posture->q[index];
      double best = middle;
      for (int i = -kArmSamples; i <= kArmSamples; ++i) {
        const double half = reach * (UpperEnd(joint) - LowerEnd(joint));
        posture->q[index] = Within(joint, middle + half * i / kArmSamples);
        const double cost = CostOf(robot, arm, spread_rad, *posture);
        if (cost >= least) continue;
        least = cost;
        best = posture->q[index];
      }
      posture->q[index] = best;
    }
    if (round % 2 == 1) reach *= 0.3;
  }
}

}  // namespace sidestep::importer
