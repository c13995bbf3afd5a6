// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/plan_log.h"

#include <algorithm>
#include <cmath>

#include "controller/types/friction_pyramid.h"
#include "models/support/require.h"

namespace sidestep {
namespace {

// The robot is put into these: nobody planned or adjusted a step there.
bool IsOfStart(const PlannedContact& contact) { return contact.start_tick <= 0; }

}  // namespace

double StepAdjustment_m(const PlannedContact& contact) {
  return (contact.adjusted_p_WF - contact.nominal_p_WF).head<2>().norm();
}

double BoxViolation_m(const PlannedContact& contact) {
  const Eigen::Vector3d moved_F =
      contact.R_WF.transpose() * (contact.adjusted_p_WF - contact.nominal_p_WF);
  const double above_m = (moved_F - contact.box_upper_m).head<2>().maxCoeff();
  const double below_m = (contact.box_lower_m - moved_F).head<2>().maxCoeff();
  return std::max({0.0, above_m, below_m});
}

double ConeViolation_N(const FootTarget& foot, double friction) {
  double violation_N = 0.0;
  for (Eigen::Index vertex = 0; vertex < foot.vertex_force_N.cols(); ++vertex) {
    const Eigen::Vector3d f_F = foot.contact.R_WF.transpose() * foot.vertex_force_N.col(vertex);
    violation_N = std::max(violation_N, FrictionViolation_N(f_F, friction));
  }
  return violation_N;
}

void PlanLog::Add(const ControlTick& control) {
  if (control.feet.empty()) return;
  SIDESTEP_REQUIRE(control.feet.size() == feet_.size(), control.feet.size());
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    const FootTarget& target = control.feet[i];
    const bool is_planned_yet = !target.planned_contact;
    if (is_planned_yet && !IsOfStart(target.contact)) {
      max_box_violation_m_ = std::max(max_box_violation_m_, BoxViolation_m(target.contact));
    }
    if (!target.planned_contact || last_[i] == target.contact.index) continue;
    last_[i] = target.contact.index;
    feet_[i].push_back(target.contact);
  }
}

std::vector<double> PlanLog::AdjustmentsFrom(Tick from) const {
  std::vector<double> adjustments_m;
  for (const std::vector<PlannedContact>& contacts : feet_) {
    for (const PlannedContact& contact : contacts) {
      if (IsOfStart(contact) || contact.start_tick < from) continue;
      adjustments_m.push_back(StepAdjustment_m(contact));
    }
  }
  return adjustments_m;
}

}  // namespace sidestep
