// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/lift_time.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "models/import/posture.h"

namespace sidestep::importer {
namespace {

// Of a quintic from rest to rest over half the swing: peaks over d / T and d / T^2.
constexpr double kPeakSpeed = 2.0 * 1.875;
constexpr double kPeakAcceleration = 4.0 * 5.774;

/// The joint that changes the distance from the leg's first joint to its last link most, and by how
/// much (m/rad).
struct Knee {
  int joint{-1};
  double lever_m{0.0};
};

Knee KneeOf(const SourceRobot& robot, const Limb& leg, const Placement& placement) {
  const int first = leg.joints.front();
  const int hip = robot.joints[static_cast<std::size_t>(first)].child;
  const Eigen::Vector3d along =
      (placement.X_WL(leg.end).translation() - placement.X_WJ(first).translation()).normalized();
  Knee knee;
  for (const int joint : leg.joints) {
    const double lever_m = std::abs(along.dot(placement.Twist(joint, leg.end).head<3>() -
                                              placement.Twist(joint, hip).head<3>()));
    if (lever_m > knee.lever_m) knee = {joint, lever_m};
  }
  return knee;
}

}  // namespace

double LeastLiftTime_s(const SourceRobot& robot, const BodyPlan& plan, const StartPose& start,
                       double height_m) {
  const Placement placement(robot, start.posture);
  double least_s = 0.0;
  for (const Limb& leg : plan.legs) {
    const Knee knee = KneeOf(robot, leg, placement);
    if (knee.joint < 0) continue;
    const SourceJoint& joint = robot.joints[static_cast<std::size_t>(knee.joint)];
    // effort T^2 = damping kPeakSpeed d T + armature kPeakAcceleration d, by d = height / lever.
    const double turn_rad = height_m / knee.lever_m;
    const double b = joint.damping_Nms_per_rad * kPeakSpeed * turn_rad;
    const double c = joint.armature_kgm2 * kPeakAcceleration * turn_rad;
    const double effort_Nm = joint.effort_Nm;
    least_s = std::max(least_s, (b + std::sqrt(b * b + 4.0 * effort_Nm * c)) / (2.0 * effort_Nm));
  }
  return least_s;
}

}  // namespace sidestep::importer
