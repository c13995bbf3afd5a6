// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/hanging_arm.h"

#include <cmath>

#include "models/import/joint_ranges.h"

namespace sidestep::importer {
namespace {

constexpr int kRounds = 12;
constexpr int kArmSamples = 60;
constexpr double kPosture = 0.02;  // per rad^2, of costs near 1: decides where nothing else does
constexpr double kSpread = 4.0;    // per (m/m)^2 that the arm points too far in or out
constexpr double kAhead = 0.5;     // the same forwards or backwards

/// Of the directions from the shoulder to the CoMs of the arm's parts.
double CostOf(const SourceRobot& robot, const Limb& arm, double spread_rad,
              const Posture& posture) {
  const Placement placement(robot, posture);
  const Eigen::Vector3d shoulder = placement.X_WJ(arm.joints.front()).translation();
  const double side = placement.X_WL(arm.end).translation().y() >= 0.0 ? 1.0 : -1.0;
  double cost = 0.0;
  for (const int joint : arm.joints) {
    const Eigen::Vector3d to_part =
        placement.CenterOfMass_W(robot.joints[static_cast<std::size_t>(joint)].child) - shoulder;
    const Eigen::Vector3d direction = to_part / std::max(to_part.norm(), 1e-9);
    const double out = side * direction.y() - std::sin(spread_rad);
    cost += direction.z() + kSpread * out * out + kAhead * direction.x() * direction.x() +
            kPosture * posture.q[joint] * posture.q[joint];
  }
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
