// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/raise_base.h"

#include <Eigen/Core>
#include <algorithm>
#include <limits>

#include "models/import/posture.h"
#include "models/import/text.h"

namespace sidestep::importer {
namespace {

constexpr double kLeastShare = 0.5;  // of the hips' height over the feet

}  // namespace

void RaiseBase(const BodyPlan& plan, SourceRobot* robot, Notes* notes) {
  const Placement zero(*robot, ZeroPosture(*robot));
  double feet_m = std::numeric_limits<double>::infinity(), hips_m = feet_m;
  for (const Limb& leg : plan.legs) {
    feet_m = std::min(feet_m, zero.X_WL(leg.end).translation().z());
    hips_m = std::min(hips_m, zero.X_WJ(leg.joints.front()).translation().z());
  }
  const double base_m = zero.X_WL(robot->root).translation().z();
  if (base_m >= feet_m + kLeastShare * (hips_m - feet_m)) return;

  SourceLink& base = robot->links[static_cast<std::size_t>(robot->root)];
  const Eigen::Vector3d up_m = base.mass.com_m;
  base.mass.com_m.setZero();
  for (std::vector<SourceShape>* shapes : {&base.visuals, &base.collisions}) {
    for (SourceShape& shape : *shapes) shape.X_LS.pretranslate(-up_m);
  }
  for (const int joint : robot->joints_below[static_cast<std::size_t>(robot->root)]) {
    robot->joints[static_cast<std::size_t>(joint)].X_PC.pretranslate(-up_m);
  }
  base.note += (base.note.empty() ? "" : "; ") + std::string("its frame was moved to its CoM");
  notes->push_back("moved the frame of the base '" + base.name + "' to its CoM, " +
                   Figure(up_m.z(), 3) + " m up: it was near the feet's height");
}

}  // namespace sidestep::importer
