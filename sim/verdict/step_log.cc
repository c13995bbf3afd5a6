// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/step_log.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/support/require.h"
#include "sim/verdict/sole_meter.h"
#include "sim/world/ground.h"

namespace sidestep {
namespace {

// A foot that rocks or bounces has not stepped: when the iCub stops walking, a foot that stays
// where it is loses the ground by micrometres for a tenth of a second.
constexpr double kShortestSwing_s = 0.05;
constexpr double kLowestSwing_m = 0.005;
constexpr double kShortestStep_m = 0.01;

// A foot that lands within this of a contact's start made that contact. Farther from all, it is of
// a schedule that is late or early, and may have made the one on its other side.
constexpr double kOnTime_s = 0.1;

}  // namespace

StepLog::StepLog(const std::vector<FootDescription>& feet, double tick_s,
                 std::vector<GroundPatch> ground)
    : tick_s_(tick_s), ground_(std::move(ground)) {
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
    NoteTouchDown(tick, i, truth.feet[i]);
  }
  const Tick shortest = TickAt(kShortestStance_s, tick_s_);
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    Foot& foot = feet_[i];
    if (foot.young && !stances[i].stands()) DropScuff(foot);
    if (!foot.young) {
      Follow(tick, foot, truth.feet[i], stances[i], stance_slip_m[i]);
      continue;
    }
    FollowYoung(tick, foot, truth.feet[i], stances[i], stance_slip_m[i]);
    if (tick - foot.young->touch_down.tick >= shortest) Confirm(i, nominal);
  }
}

void StepLog::NoteTouchDown(Tick tick, std::size_t i, const FootTruth& truth) {
  Foot& foot = feet_[i];
  TouchDown touch_down;
  touch_down.foot = i;
  touch_down.is_step = HasSwung(tick, foot, truth);
  touch_down.tick = tick;
  touch_down.p_WF = truth.p_WF;
  if (touch_down.is_step) {
    const Foot& from = feet_.size() == 2 ? feet_[1 - i] : foot;
    const std::optional<Eigen::Vector3d> from_p_WF =
        from.young ? from.young->stance_p_WF : from.stance_p_WF;
    foot.young = YoungStep{touch_down, from_p_WF, truth.p_WF};
  } else if (!foot.touch_down) {
    foot.touch_down = touch_downs_.size();
    touch_downs_.push_back(touch_down);
  }
}

void StepLog::Follow(Tick tick, Foot& foot, const FootTruth& truth, const StanceMeter& stance,
                     double slip_m) {
  if (stance.bears_load()) foot.stance_p_WF = truth.p_WF;
  if (stance.stands() && truth.in_contact) {
    foot.last_contact_tick = tick;
    foot.apex_m = kLowest_m;
    TouchDown& latest = touch_downs_[*foot.touch_down];
    latest.end_tick = tick + 1;
    latest.slip_m = std::max(latest.slip_m, slip_m);
  } else {
    foot.apex_m = std::max(foot.apex_m, SoleHeight_m(foot.description, truth) -
                                            GroundHeight_m(ground_, truth.p_WF.head<2>()));
  }
}

void StepLog::FollowYoung(Tick tick, Foot& foot, const FootTruth& truth, const StanceMeter& stance,
                          double slip_m) {
  YoungStep& young = *foot.young;
  if (stance.bears_load()) young.stance_p_WF = truth.p_WF;
  if (truth.in_contact) young.touch_down.end_tick = tick + 1;
  young.touch_down.slip_m = std::max(young.touch_down.slip_m, slip_m);
}

void StepLog::Confirm(std::size_t i, const NominalMotion& nominal) {
  Foot& foot = feet_[i];
  YoungStep& young = *foot.young;
  young.touch_down.adjustment_m = Adjustment_m(i, young, nominal);
  if (foot.touch_down) min_swing_clearance_m_ = std::min(min_swing_clearance_m_, foot.apex_m);
  foot.touch_down = touch_downs_.size();
  touch_downs_.push_back(young.touch_down);
  foot.stance_p_WF = young.stance_p_WF;
  foot.last_contact_tick = young.touch_down.end_tick - 1;
  foot.apex_m = kLowest_m;
  foot.young.reset();
}

// Whoever landed meanwhile has not stepped from there.
void StepLog::DropScuff(Foot& foot) {
  foot.young.reset();
  for (Foot& other : feet_) {
    if (other.young) other.young->from_p_WF = foot.stance_p_WF;
  }
}

// A foot that has not stood yet is taken for one that left the ground at the first tick.
bool StepLog::HasSwung(Tick tick, const Foot& foot, const FootTruth& truth) const {
  const double swing_s = SecondsAt(tick - foot.last_contact_tick, tick_s_);
  const double moved_m = foot.stance_p_WF ? (truth.p_WF - *foot.stance_p_WF).head<2>().norm() : 0.0;
  return swing_s >= kShortestSwing_s &&
         (foot.apex_m >= kLowestSwing_m || moved_m >= kShortestStep_m);
}

std::optional<double> StepLog::Adjustment_m(std::size_t foot, const YoungStep& young,
                                            const NominalMotion& nominal) const {
  if (!young.from_p_WF) return std::nullopt;
  const Eigen::Vector3d step = young.touch_down.p_WF - *young.from_p_WF;
  const auto off_m = [&](std::size_t contact) {
    return (step - nominal.StepTo(foot, contact)).head<2>().norm();
  };
  const std::size_t nearest = NearestStart(nominal.starts(foot), young.touch_down.tick);
  const Tick late = young.touch_down.tick - nominal.starts(foot)[nearest];
  const Tick on_time = TickAt(kOnTime_s, tick_s_);
  const bool has_before = nearest > 1;  // number 0 is no step
  const bool has_next = nearest + 1 < nominal.starts(foot).size();
  if (late < -on_time && has_before) return std::min(off_m(nearest), off_m(nearest - 1));
  if (late > on_time && has_next) return std::min(off_m(nearest), off_m(nearest + 1));
  return off_m(nearest);
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
