// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/footstep_log.h"

#include <algorithm>
#include <cmath>

#include "models/support/require.h"
#include "sim/verdict/sole_meter.h"

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
  const double above_m = (moved_F - contact.box_upper_m).maxCoeff();
  const double below_m = (contact.box_lower_m - moved_F).maxCoeff();
  return std::max({0.0, above_m, below_m});
}

double ConeViolation_N(const FootTarget& foot, double friction) {
  double violation_N = 0.0;
  for (Eigen::Index vertex = 0; vertex < foot.vertex_force_N.cols(); ++vertex) {
    const Eigen::Vector3d f_F = foot.contact.R_WF.transpose() * foot.vertex_force_N.col(vertex);
    const double tangential_N = std::abs(f_F.x()) + std::abs(f_F.y());
    violation_N = std::max({violation_N, tangential_N - friction * f_F.z(), -f_F.z()});
  }
  return violation_N;
}

FootstepLog::FootstepLog(const std::vector<FootDescription>& feet) {
  feet_.resize(feet.size());
  for (std::size_t i = 0; i < feet.size(); ++i) feet_[i].description = feet[i];
}

void FootstepLog::AddPlan(Tick tick, const ControlTick& control) {
  if (control.feet.empty()) return;  // a controller without a plan
  SIDESTEP_REQUIRE(control.feet.size() == feet_.size(), control.feet.size());
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    Foot& foot = feet_[i];
    const FootTarget& target = control.feet[i];
    if (!IsOfStart(target.contact)) {
      max_box_violation_m_ = std::max(max_box_violation_m_, BoxViolation_m(target.contact));
    }
    const bool is_new =
        !foot.record || footsteps_[*foot.record].contact.index != target.contact.index;
    if (target.planned_contact && is_new) {
      foot.record = footsteps_.size();
      footsteps_.push_back(
          {.foot = static_cast<int>(i), .contact = target.contact, .realised_p_WF = {}});
    }
    if (target.planned_contact && foot.apex_m) {
      min_swing_clearance_m_ = std::min(min_swing_clearance_m_, *foot.apex_m);
      foot.apex_m.reset();
    }
    const bool lifts_off = foot.has_plan && foot.planned_contact && !target.planned_contact;
    if (lifts_off && tick > 0) foot.apex_m = -std::numeric_limits<double>::infinity();
    foot.has_plan = true;
    foot.planned_contact = target.planned_contact;
  }
}

void FootstepLog::AddTruth(const WorldTruth& truth, const std::vector<double>& stance_slip_m) {
  SIDESTEP_REQUIRE(truth.feet.size() == feet_.size(), truth.feet.size());
  SIDESTEP_REQUIRE(stance_slip_m.size() == feet_.size(), stance_slip_m.size());
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    Foot& foot = feet_[i];
    const FootTruth& foot_truth = truth.feet[i];
    if (foot.apex_m) {
      foot.apex_m = std::max(*foot.apex_m, SoleHeight_m(foot.description, foot_truth));
    }
    if (!foot.planned_contact || !foot.record || !foot_truth.in_contact) continue;
    FootstepRecord& record = footsteps_[*foot.record];
    if (!record.realised_p_WF) record.realised_p_WF = foot_truth.p_WF;
    record.slip_m = std::max(record.slip_m, stance_slip_m[i]);
  }
}

std::vector<double> FootstepLog::AdjustmentsFrom(Tick from) const {
  std::vector<double> adjustments_m;
  for (const FootstepRecord& record : footsteps_) {
    if (IsOfStart(record.contact) || record.contact.start_tick < from) continue;
    adjustments_m.push_back(StepAdjustment_m(record.contact));
  }
  return adjustments_m;
}

double FootstepLog::min_swing_clearance_m() const {
  return std::isfinite(min_swing_clearance_m_) ? min_swing_clearance_m_
                                               : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace sidestep
