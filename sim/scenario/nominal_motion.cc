// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/nominal_motion.h"

#include <algorithm>

#include "controller/planner/gait_geometry.h"
#include "models/support/require.h"

namespace sidestep {
namespace {

// Beyond the duration: a robot may be ahead of its schedule by less.
constexpr double kMargin_s = 5.0;

// The box of a step's adjustment is the controller's, and none is asked for.
NominalGait GaitOf(const RobotDescription& robot, const AskedGait& asked, Tick end_tick) {
  const GaitGeometry geometry = MakeGaitGeometry(robot, asked.sway);
  return BuildNominalGait(asked.segments, geometry, end_tick, asked.tick_s);
}

}  // namespace

AskedGait AskedGaitOf(const Scenario& scenario) {
  return {scenario.gait, scenario.control.planner.sway, scenario.duration_s, scenario.world.step_s};
}

std::size_t NearestStart(std::span<const Tick> starts, Tick tick) {
  SIDESTEP_REQUIRE(!starts.empty(), tick);
  const auto next = std::upper_bound(starts.begin(), starts.end(), tick);
  if (next == starts.begin()) return 0;
  const auto before = static_cast<std::size_t>(next - starts.begin()) - 1;
  if (next == starts.end()) return before;
  return *next - tick < tick - starts[before] ? before + 1 : before;
}

NominalMotion::NominalMotion(const RobotDescription& robot, const AskedGait& asked)
    : tick_s_(asked.tick_s), end_tick_(TickAt(asked.duration_s + kMargin_s, tick_s_)) {
  gait_ = GaitOf(robot, asked, end_tick_);
  for (const std::vector<NominalContact>& contacts : gait_.feet) {
    std::vector<PlannedContact>& foot = feet_.emplace_back();
    std::vector<Tick>& starts = starts_.emplace_back();
    for (const NominalContact& nominal : contacts) {
      foot.push_back(nominal.contact);
      starts.push_back(nominal.contact.start_tick);
    }
  }
}

ComReference NominalMotion::ComAt(Tick tick) const { return NominalComAt(gait_, tick, tick_s_); }

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
