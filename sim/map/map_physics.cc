// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/map_physics.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "controller/types/tick.h"
#include "models/support/config_error.h"
#include "models/support/gravity.h"
#include "sim/limit/limit_subject.h"
#include "sim/limit/limit_table.h"
#include "sim/scenario/nominal_motion.h"

namespace sidestep::map {
namespace {

constexpr std::size_t kMostPanels = 64;  // a pendulum's limits take about a second a panel

/// The push that a sweep is about: of the first of its keys that begins with `pushes.`.
std::size_t PushOf(const SweepSpec& spec) {
  std::vector<std::string> keys;
  for (const Axis& axis : spec.axes) keys.push_back(axis.key);
  if (spec.limit) keys.push_back(spec.limit->key);
  for (const std::string& key : keys) {
    constexpr std::string_view kList = "pushes.";
    if (!key.starts_with(kList)) continue;
    return static_cast<std::size_t>(std::atoi(key.c_str() + kList.size()));
  }
  return 0;
}

double DirectionOf(const Push& push) { return std::atan2(push.force_N.y(), push.force_N.x()); }

double LimitFor(const Scenario& scenario, const Push& push) {
  const limit::LimitSubject subject = limit::LimitSubjectOf(scenario);
  const StepMoment moment = MomentOf(scenario, push.start_s);
  limit::LimitTask task;
  task.params = subject.params;
  task.gait = subject.gait;
  task.is_planar = subject.is_planar;
  task.moments = {{"push", moment.time_s}};
  const double direction_rad = DirectionOf(push);
  task.directions_rad = {moment.is_mirrored ? -direction_rad : direction_rad};
  const limit::LimitTable table =
      limit::MakeLimitTable(scenario.name, task, push.duration_s, std::nullopt);
  return table.limits.front().front();
}

Scenario ScenarioOfCell(const SweepPlan& plan, const MapCell& cell) {
  const Ray& ray = plan.rays.at(cell.points.front().ray).ray;
  return ScenarioOf(plan.spec, ray, FirstCell(plan.spec, ray));
}

std::string NoteOf(const Scenario& scenario, const Push& push) {
  // A hop's limit is of an instant push (limit_table.h).
  const limit::LimitSubject subject = limit::LimitSubjectOf(scenario);
  const bool is_hop = subject.gait == GaitType::kHop;
  char text[400];
  std::snprintf(
      text, sizeof text,
      "a linear pendulum of omega %.2f /s, pushed at its CoM for %s (the map's pushes act "
      "on '%s' for %.3g s)",
      subject.params.omega_per_s, is_hop ? "an instant" : "as long", push.body.c_str(),
      push.duration_s);
  return text;
}

void Fill(const SweepPlan& plan, SweepMap* map) {
  const std::size_t number = PushOf(plan.spec);
  for (MapCell& cell : map->cells) {
    if (cell.controller != 0) continue;
    const Scenario scenario = ScenarioOfCell(plan, cell);
    map->omega_per_s = std::sqrt(kGravity_mps2 / scenario.robot.com_height_m);
    if (number >= scenario.pushes.size()) {
      map->physics_note = "none: nothing is pushed";
      return;
    }
    const Push& push = scenario.pushes[number];
    cell.physical_Nspkg = LimitFor(scenario, push);
    if (map->physics_note.empty()) map->physics_note = NoteOf(scenario, push);
  }
  for (MapCell& cell : map->cells) {
    const MapCell* first = FindCell(*map, 0, cell.panel, cell.direction);
    if (first != nullptr) cell.physical_Nspkg = first->physical_Nspkg;
  }
}

}  // namespace

StepMoment MomentOf(const Scenario& scenario, double push_s) {
  const NominalMotion motion(scenario.robot, AskedGaitOf(scenario));
  const Tick tick = TickAt(push_s, motion.tick_s());
  const bool is_hop = motion.num_feet() == 1;
  StepMoment moment;
  Tick begin = 0;
  for (std::size_t foot = 0; foot < motion.num_feet(); ++foot) {
    const std::vector<PlannedContact>& contacts = motion.contacts(foot);
    for (std::size_t i = 0; i + 1 < contacts.size(); ++i) {
      if (!contacts[i].end_is_known) continue;
      const Tick start = is_hop ? contacts[i + 1].start_tick : contacts[i].end_tick;
      if (start > tick || start < begin) continue;
      begin = start;
      moment = {SecondsAt(tick - start, motion.tick_s()), foot == 1};
    }
  }
  return moment;
}

void AddPhysics(const SweepPlan& plan, SweepMap* map) {
  if (map->panels.size() > kMostPanels) {
    map->physics_note = "none: it is not asked of so many combinations";
    return;
  }
  try {
    Fill(plan, map);
  } catch (const ConfigError& error) {
    map->physics_note = std::string("none: ") + error.what();
  }
}

}  // namespace sidestep::map
