// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/bent_knee.h"

#include <algorithm>
#include <cmath>

#include "models/import/joint_ranges.h"

namespace sidestep::importer {
namespace {

constexpr int kSamples = 400;      // of half a turn or more: 0.03 rad
constexpr double kRoom_rad = 1.0;  // a knee with as much on both sides may bend either way

/// Distances along a joint's range.
struct Sweep {
  int joint{-1};
  std::vector<double> q;
  std::vector<Eigen::Vector3d> leg;  ///< Hip to ankle, in W.
  std::size_t longest{0};
  double change_m{0.0};
};

Sweep SweepJoint(const SourceRobot& robot, const Limb& leg, int ankle, int index, Posture posture) {
  const SourceJoint& joint = robot.joints[static_cast<std::size_t>(index)];
  const double lower = LowerEnd(joint) + MarginOf(joint), upper = UpperEnd(joint) - MarginOf(joint);
  Sweep sweep;
  sweep.joint = index;
  double least_m = 1e300, most_m = 0.0;
  for (int i = 0; i <= kSamples; ++i) {
    sweep.q.push_back(lower + (upper - lower) * i / kSamples);
    posture.q[index] = sweep.q.back();
    const Placement placement(robot, posture);
    sweep.leg.emplace_back(placement.X_WL(ankle).translation() -
                           placement.X_WJ(leg.joints.front()).translation());
    const double length_m = sweep.leg.back().norm();
    least_m = std::min(least_m, length_m);
    if (length_m > most_m) sweep.longest = static_cast<std::size_t>(i);
    most_m = std::max(most_m, length_m);
  }
  sweep.change_m = most_m - least_m;
  return sweep;
}

/// +1 if the knee bends towards greater angles.
int BendingSide(const Sweep& sweep) {
  const double below = sweep.q[sweep.longest] - sweep.q.front();
  const double above = sweep.q.back() - sweep.q[sweep.longest];
  if (std::min(below, above) < kRoom_rad) return above > below ? 1 : -1;
  const double ahead = sweep.leg[sweep.longest + kSamples / 20].x();
  return ahead < sweep.leg[sweep.longest].x() ? 1 : -1;
}

}  // namespace

double BendKnee(const SourceRobot& robot, const Limb& leg, int ankle, double stretch,
                Posture* posture) {
  Sweep knee;
  for (const int joint : leg.joints) {
    Sweep sweep = SweepJoint(robot, leg, ankle, joint, *posture);
    if (sweep.change_m > knee.change_m) knee = std::move(sweep);
  }
  if (knee.joint < 0) return 0.0;
  const double longest_m = knee.leg[knee.longest].norm();
  const int side = BendingSide(knee);
  auto i = static_cast<int>(knee.longest);
  while (i + side >= 0 && i + side <= kSamples &&
         knee.leg[static_cast<std::size_t>(i)].norm() > stretch * longest_m) {
    i += side;
  }
  posture->q[knee.joint] = knee.q[static_cast<std::size_t>(i)];
  return longest_m;
}

}  // namespace sidestep::importer
