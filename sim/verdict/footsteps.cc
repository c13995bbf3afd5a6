// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/footsteps.h"

#include <algorithm>
#include <cstdlib>

namespace sidestep {
namespace {

// A touch-down farther than this from the start of a planned contact was not planned by it: it is
// the whole step of a quick gait, and no foot is so late.
constexpr double kFarthestPlan_s = 0.3;

template <typename Items, typename TickOf>
std::vector<Tick> TicksOf(const Items& items, TickOf tick_of) {
  std::vector<Tick> ticks;
  for (const auto& item : items) ticks.push_back(tick_of(item));
  return ticks;
}

// What the controller planned for the record's contact. Its box moves, for it is about the nominal
// place that the planner had.
void TakePlan(const PlannedContact& planned, FootstepRecord& record) {
  const Eigen::Vector3d shift_F =
      planned.R_WF.transpose() * (planned.nominal_p_WF - record.contact.nominal_p_WF);
  PlannedContact& contact = record.contact;
  contact.R_WF = planned.R_WF;
  contact.adjusted_p_WF = planned.adjusted_p_WF;
  contact.box_lower_m = planned.box_lower_m + shift_F;
  contact.box_upper_m = planned.box_upper_m + shift_F;
  record.is_planned = true;
}

void TakeTruth(const TouchDown& touch_down, FootstepRecord& record) {
  record.realised_p_WF = touch_down.p_WF;
  record.slip_m = touch_down.slip_m;
}

// One foot's records, and what is needed to pair them.
class FootJoiner {
 public:
  FootJoiner(std::size_t foot, const NominalMotion& nominal, const StepLog& steps,
             const PlanLog& plan)
      : foot_(foot), nominal_(nominal), contacts_(nominal.contacts(foot)), plan_(plan.begun(foot)) {
    for (const TouchDown& touch_down : steps.touch_downs()) {
      if (touch_down.foot == foot) touch_downs_.push_back(touch_down);
    }
  }

  void Append(Tick last_tick, std::vector<FootstepRecord>& records) {
    const std::vector<Tick>& starts = nominal_.starts(foot_);
    const auto landed = PairByTime(starts, TicksOfTouchDowns());
    const auto planned = PairByTime(starts, StartsOf(plan_));
    std::vector<bool> is_met(touch_downs_.size(), false), is_told(plan_.size(), false);
    for (std::size_t at = 0; at < contacts_.size(); ++at) {
      if (planned[at]) is_told[*planned[at]] = true;
      if (contacts_[at].start_tick > last_tick && !landed[at]) continue;
      FootstepRecord record = RecordOf(contacts_[at]);
      if (planned[at]) TakePlan(plan_[*planned[at]], record);
      if (landed[at]) TakeTruth(touch_downs_[*landed[at]], record);
      if (landed[at]) is_met[*landed[at]] = true;
      records.push_back(record);
    }
    KeepUnpaired(is_met, touch_downs_);
    KeepUnpaired(is_told, plan_);
    AppendExtras(records);
  }

 private:
  static std::vector<Tick> StartsOf(const std::vector<PlannedContact>& contacts) {
    return TicksOf(contacts, [](const PlannedContact& contact) { return contact.start_tick; });
  }
  std::vector<Tick> TicksOfTouchDowns() const {
    return TicksOf(touch_downs_, [](const TouchDown& touch_down) { return touch_down.tick; });
  }

  FootstepRecord RecordOf(const PlannedContact& contact) const {
    FootstepRecord record;
    record.foot = static_cast<int>(foot_);
    record.contact = contact;
    return record;
  }

  template <typename Item>
  static void KeepUnpaired(const std::vector<bool>& is_paired, std::vector<Item>& items) {
    std::size_t at = 0;
    std::erase_if(items, [&](const Item&) { return is_paired[at++]; });
  }

  // Steps that the gait does not have, about the place that it has for the foot around then.
  void AppendExtras(std::vector<FootstepRecord>& records) const {
    const auto planned = PairByTime(TicksOfTouchDowns(), StartsOf(plan_));
    const Tick farthest = TickAt(kFarthestPlan_s, nominal_.tick_s());
    for (std::size_t at = 0; at < touch_downs_.size(); ++at) {
      const TouchDown& touch_down = touch_downs_[at];
      const std::size_t nearest = NearestStart(nominal_.starts(foot_), touch_down.tick);
      FootstepRecord record = RecordOf(contacts_[nearest]);
      record.contact.index = -1;
      record.contact.start_tick = touch_down.tick;
      record.contact.end_tick = touch_down.end_tick;
      record.contact.end_is_known = true;
      if (planned[at]) {
        const PlannedContact& plan = plan_[*planned[at]];
        if (std::abs(plan.start_tick - touch_down.tick) <= farthest) TakePlan(plan, record);
      }
      TakeTruth(touch_down, record);
      records.push_back(record);
    }
  }

  std::size_t foot_;
  const NominalMotion& nominal_;
  const std::vector<PlannedContact>& contacts_;
  std::vector<PlannedContact> plan_;
  std::vector<TouchDown> touch_downs_;
};

}  // namespace

std::vector<std::optional<std::size_t>> PairByTime(std::span<const Tick> slots,
                                                   std::span<const Tick> events) {
  std::vector<std::optional<std::size_t>> event_of(slots.size());
  if (slots.empty()) return event_of;
  for (std::size_t event = 0; event < events.size(); ++event) {
    const std::size_t slot = NearestStart(slots, events[event]);
    std::optional<std::size_t>& holder = event_of[slot];
    const auto distance = [&](std::size_t at) { return std::abs(events[at] - slots[slot]); };
    if (!holder || distance(event) < distance(*holder)) holder = event;
  }
  return event_of;
}

std::vector<FootstepRecord> MakeFootsteps(const NominalMotion& nominal, const StepLog& steps,
                                          const PlanLog& plan, Tick last_tick) {
  std::vector<FootstepRecord> records;
  for (std::size_t foot = 0; foot < nominal.num_feet(); ++foot) {
    FootJoiner(foot, nominal, steps, plan).Append(last_tick, records);
  }
  std::stable_sort(records.begin(), records.end(), [](const auto& left, const auto& right) {
    return left.contact.start_tick < right.contact.start_tick;
  });
  return records;
}

}  // namespace sidestep
