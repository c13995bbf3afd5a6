// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/step_log.h"

#include <algorithm>
#include <cmath>

#include "models/support/require.h"
#include "sim/verdict/sole_meter.h"

namespace sidestep {
namespace {

// A foot that rocks or bounces has not stepped: when the iCub stops walking, a foot that stays
// where it is loses the ground by micrometres for a tenth of a second.
constexpr double kShortestSwing_s = 0.05;
constexpr double kLowestSwing_m = 0.005;
constexpr double kShortestStep_m = 0.01;

}  // namespace

StepLog::StepLog(const std::vector<FootDescription>& feet, double tick_s) : tick_s_(tick_s) {
  feet_.resize(feet.size());
  for (std::size_t i = 0; i < feet.size(); ++i) feet_[i].description = feet[i];
}

void StepLog::Add(Tick tick, const WorldTruth& truth, const std::vector<StanceMeter>& stances,
                  const std::vector<double>& stance_slip_m, const NominalMotion& nominal) {
  SIDESTEP_REQUIRE(truth.feet.size() == feet_.size(), truth.feet.size());
  SIDESTEP_REQUIRE(stances.size() == feet_.size(), stances.size());
  SIDESTEP_REQUIRE(stance_slip_m.size() == feet_.size(), stance_slip_m.size());
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    if (stances[i].num_stances() == feet_[i].num_stances) continue;
    feet_[i].num_stances = stances[i].num_stances();
    NoteTouchDown(tick, i, truth.feet[i], nominal);
  }
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    Foot& foot = feet_[i];
    const FootTruth& foot_truth = truth.feet[i];
    if (stances[i].bears_load()) foot.stance_p_WF = foot_truth.p_WF;
    if (stances[i].stands() && foot_truth.in_contact) {
      foot.last_contact_tick = tick;
      foot.apex_m = kLowest_m;
      TouchDown& latest = touch_downs_[*foot.touch_down];
      latest.end_tick = tick + 1;
      latest.slip_m = std::max(latest.slip_m, stance_slip_m[i]);
    } else {
      foot.apex_m = std::max(foot.apex_m, SoleHeight_m(foot.description, foot_truth));
    }
  }
}

void StepLog::NoteTouchDown(Tick tick, std::size_t i, const FootTruth& truth,
                            const NominalMotion& nominal) {
  Foot& foot = feet_[i];
  const bool is_first = !foot.touch_down;
  if (!is_first) {
    const double swing_s = SecondsAt(tick - foot.last_contact_tick, tick_s_);
    const double moved_m = (truth.p_WF - *foot.stance_p_WF).head<2>().norm();
    const bool has_swung = foot.apex_m >= kLowestSwing_m || moved_m >= kShortestStep_m;
    if (swing_s < kShortestSwing_s || !has_swung) return;
    min_swing_clearance_m_ = std::min(min_swing_clearance_m_, foot.apex_m);
  }
  foot.touch_down = touch_downs_.size();
  TouchDown& latest = touch_downs_.emplace_back();
  latest.foot = i;
  latest.tick = tick;
  latest.p_WF = truth.p_WF;
  if (!is_first) latest.adjustment_m = Adjustment_m(tick, i, truth.p_WF, nominal);
}

std::optional<double> StepLog::Adjustment_m(Tick tick, std::size_t foot,
                                            const Eigen::Vector3d& p_WF,
                                            const NominalMotion& nominal) const {
  const std::optional<Eigen::Vector3d>& from_p_WF =
      feet_.size() == 2 ? feet_[1 - foot].stance_p_WF : feet_[foot].stance_p_WF;
  if (!from_p_WF) return std::nullopt;
  const Eigen::Vector3d nominal_step = nominal.StepTo(foot, nominal.NearestContact(foot, tick));
  return (p_WF - *from_p_WF - nominal_step).head<2>().norm();
}

std::vector<double> StepLog::AdjustmentsFrom(Tick from) const {
  std::vector<double> adjustments_m;
  for (const TouchDown& touch_down : touch_downs_) {
    if (touch_down.tick < from || !touch_down.adjustment_m) continue;
    adjustments_m.push_back(*touch_down.adjustment_m);
  }
  return adjustments_m;
}

double StepLog::min_swing_clearance_m() const {
  return std::isfinite(min_swing_clearance_m_) ? min_swing_clearance_m_
                                               : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace sidestep
