// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/gait_generator.h"

#include <algorithm>

#include "controller/planner/gait_writer.h"

namespace sidestep {
namespace {

// Of the knots beyond the horizon: one ends the last quintic, the other sets its speed there.
constexpr std::ptrdiff_t kKnotsBeyond = 2;

// Steps beyond the horizon: until the knots and the ends of contacts are there.
constexpr std::size_t kStepsBeyond = 8;

constexpr std::size_t kKnotsOfAStep = 2;

// Empties the schedule and keeps room for as many steps as can be made.
void Clear(const GaitSetup& setup, Tick horizon, ContactSchedule* schedule) {
  const auto most_steps =
      static_cast<std::size_t>(SecondsAt(horizon, setup.tick_s) / kShortestStep_s) +
      setup.segments.size() + kStepsBeyond;
  schedule->feet.resize(static_cast<std::size_t>(setup.geometry.num_feet));
  for (auto& contacts : schedule->feet) {
    contacts.clear();
    contacts.reserve(most_steps);
  }
  schedule->com.clear();
  schedule->com.reserve(kKnotsOfAStep * most_steps);
}

bool HasEnded(const PlannedContact& contact, Tick tick) {
  return contact.end_is_known && contact.end_tick <= tick;
}

// All that GenerateSchedule() promises is written, should the gait go on.
bool IsComplete(const ContactSchedule& schedule, Tick tick, Tick end) {
  for (const auto& contacts : schedule.feet) {
    if (contacts.empty()) return false;
    const PlannedContact& last = contacts.back().contact;
    if (HasEnded(last, tick) || (last.start_tick <= end && !last.end_is_known)) return false;
  }
  const auto is_beyond = [end](const ComKnot& knot) { return knot.tick > end; };
  return std::count_if(schedule.com.begin(), schedule.com.end(), is_beyond) >= kKnotsBeyond;
}

// Drops what has ended and what begins beyond the horizon, but for a foot's only contact.
void Trim(Tick tick, Tick end, std::vector<NominalContact>* contacts) {
  const auto has_ended = [tick](const NominalContact& nominal) {
    return HasEnded(nominal.contact, tick);
  };
  contacts->erase(contacts->begin(),
                  std::find_if_not(contacts->begin(), contacts->end(), has_ended));
  while (contacts->size() > 1 && contacts->back().contact.start_tick > end) contacts->pop_back();
}

}  // namespace

GaitSupport StandingSupport(const GaitSetup& setup) {
  GaitWriter writer(setup, GaitSupport{}, nullptr);
  writer.StandAtTheBegin();
  return writer.support();
}

std::optional<GaitSupport> NextSupport(const GaitSetup& setup, const GaitSupport& support) {
  GaitWriter writer(setup, support, nullptr);
  if (!writer.Step()) return std::nullopt;
  return writer.support();
}

void GenerateSchedule(const GaitSetup& setup, const GaitSupport& support, Tick tick, Tick horizon,
                      ContactSchedule* schedule) {
  const Tick end = tick + horizon;
  Clear(setup, horizon, schedule);
  GaitWriter writer(setup, support, schedule);
  bool goes_on = true;
  while (goes_on && (writer.support().tick <= end || !IsComplete(*schedule, tick, end))) {
    goes_on = writer.Step();
  }
  writer.CloseAt(end + 1);
  for (auto& contacts : schedule->feet) Trim(tick, end, &contacts);
}

}  // namespace sidestep
