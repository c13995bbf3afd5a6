// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/nominal_motion.h"

#include <algorithm>

#include "controller/planner/gait_geometry.h"

namespace sidestep {
namespace {

// Beyond the duration: a robot may be ahead of its schedule by less.
constexpr double kMargin_s = 5.0;

NominalGait GaitOf(const Scenario& scenario, Tick end_tick) {
  const RobotDescription& robot = scenario.robot;
  const GaitGeometry geometry =
      MakeGaitGeometry(robot, scenario.control.planner, scenario.control.mpc);
  return BuildNominalGait(scenario.gait, geometry, end_tick, scenario.world.step_s);
}

}  // namespace

NominalMotion::NominalMotion(const Scenario& scenario)
    : tick_s_(scenario.world.step_s), end_tick_(TickAt(scenario.duration_s + kMargin_s, tick_s_)) {
  gait_ = GaitOf(scenario, end_tick_);
  for (const std::vector<NominalContact>& contacts : gait_.feet) {
    std::vector<PlannedContact>& foot = feet_.emplace_back();
    for (const NominalContact& nominal : contacts) foot.push_back(nominal.contact);
  }
}

ComReference NominalMotion::ComAt(Tick tick) const { return NominalComAt(gait_, tick, tick_s_); }

std::size_t NominalMotion::NearestContact(std::size_t foot, Tick tick) const {
  const std::vector<PlannedContact>& contacts = feet_.at(foot);
  const auto next = std::upper_bound(
      contacts.begin(), contacts.end(), tick,
      [](Tick value, const PlannedContact& contact) { return value < contact.start_tick; });
  if (next == contacts.begin()) return 0;
  const auto at = static_cast<std::size_t>(next - contacts.begin());
  if (next == contacts.end()) return at - 1;
  return next->start_tick - tick < tick - contacts[at - 1].start_tick ? at : at - 1;
}

Eigen::Vector3d NominalMotion::StepTo(std::size_t foot, std::size_t index) const {
  const PlannedContact& contact = feet_.at(foot).at(index);
  if (num_feet() != 2) {
    const std::size_t before = index == 0 ? 0 : index - 1;
    return contact.nominal_p_WF - feet_[foot][before].nominal_p_WF;
  }
  const PlannedContact* other = &feet_[1 - foot].front();
  for (const PlannedContact& candidate : feet_[1 - foot]) {
    if (candidate.start_tick <= contact.start_tick) other = &candidate;
  }
  return contact.nominal_p_WF - other->nominal_p_WF;
}

}  // namespace sidestep
