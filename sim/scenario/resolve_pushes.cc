// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/resolve_pushes.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include "controller/types/tick.h"
#include "models/mjcf/mjcf.h"
#include "models/support/config_node.h"
#include "models/support/gravity.h"
#include "sim/scenario/nominal_motion.h"

namespace sidestep {
namespace {

/// Of the plant: the robot's by its description or its model, times world.mass_scale.
double PlantMass_kg(const Scenario& scenario) {
  const RobotDescription& robot = scenario.robot;
  double mass_kg = robot.mass_kg;
  if (mass_kg <= 0.0) {
    const RobotModel& model = RequireModel(robot);
    mass_kg = mj_getTotalmass(CompileMjcf(model.simulated_mjcf, "", model.file).get());
  }
  return scenario.world.mass_scale * mass_kg;
}

/// What pushes are told by, worked out once for all of them, and only if one asks for it.
class Yardstick {
 public:
  explicit Yardstick(const Scenario& scenario) : scenario_(scenario) {}

  double mass_kg() {
    if (!mass_kg_) mass_kg_ = PlantMass_kg(scenario_);
    return *mass_kg_;
  }
  const NominalMotion& motion() {
    if (!motion_) motion_.emplace(scenario_.robot, AskedGaitOf(scenario_));
    return *motion_;
  }

 private:
  const Scenario& scenario_;
  std::optional<double> mass_kg_;
  std::optional<NominalMotion> motion_;
};

double Magnitude_N(const PushEntry& entry, Yardstick* yardstick) {
  if (entry.magnitude_N) return *entry.magnitude_N;
  const double mass_kg = yardstick->mass_kg();
  if (entry.magnitude_mg) return *entry.magnitude_mg * mass_kg * kGravity_mps2;
  const double mean_share = MeanShare(entry.push.profile);
  return *entry.impulse_Nspkg * mass_kg / (entry.push.duration_s * mean_share);
}

/// From one lift-off of a foot to its next, with the touch-down between them.
struct Stride {
  Tick lift_off{0};
  Tick touch_down{0};
  Tick end{0};
};

/// The first whole stride that begins at `after` or later, if there is one.
std::optional<Stride> StrideFrom(const std::vector<PlannedContact>& contacts, Tick after) {
  for (std::size_t i = 0; i + 1 < contacts.size(); ++i) {
    const PlannedContact& next = contacts[i + 1];
    if (!contacts[i].end_is_known || !next.end_is_known || contacts[i].end_tick < after) continue;
    return Stride{contacts[i].end_tick, next.start_tick, next.end_tick};
  }
  return std::nullopt;
}

Tick InstantOf(const StridePhase& phase, const Stride& stride) {
  if (!phase.name) {
    const auto length = static_cast<double>(stride.end - stride.lift_off);
    return stride.lift_off + static_cast<Tick>(std::llround(phase.share * length));
  }
  switch (*phase.name) {
    case PhaseName::kMidSwing:
      return (stride.lift_off + stride.touch_down) / 2;
    case PhaseName::kSwingToStance:
      return stride.touch_down;
    case PhaseName::kMidStance:
      return (stride.touch_down + stride.end) / 2;
    case PhaseName::kStanceToSwing:
      break;
  }
  return stride.end;
}

double Start_s(const PushEntry& entry, const std::string& path, const Scenario& scenario,
               const ConfigTree& root, Yardstick* yardstick) {
  if (entry.start_s) return *entry.start_s;
  const NominalMotion& motion = yardstick->motion();
  const PushFoot side = entry.foot.value_or(PushFoot::kLeft);
  const std::size_t foot = side == PushFoot::kLeft ? 0 : 1;
  if (foot >= motion.num_feet()) {
    FailAtPath(root, path + ".foot",
               "= right needs a robot of 2 feet; '" + scenario.robot_name + "' has 1");
  }
  const double after_s = entry.after_s.value_or(0.0);
  const auto stride = StrideFrom(motion.contacts(foot), TickAt(after_s, motion.tick_s()));
  const bool is_in_run = stride && SecondsAt(stride->end, motion.tick_s()) <= scenario.duration_s;
  if (!is_in_run) {
    FailAtPath(root, path + ".at_phase",
               "has no stride to be in: the gait has no whole one of the " +
                   std::string(EnumName(side)) + " foot between " + NumberText(after_s) +
                   " s and the end at " + NumberText(scenario.duration_s) + " s");
  }
  return SecondsAt(InstantOf(*entry.at_phase, *stride), motion.tick_s());
}

}  // namespace

std::optional<double> PhaseAt(const Scenario& scenario, double time_s) {
  if (scenario.gait.empty() || scenario.robot.feet.empty()) return std::nullopt;
  const NominalMotion motion(scenario.robot, AskedGaitOf(scenario));
  const Tick tick = TickAt(time_s, motion.tick_s());
  for (auto stride = StrideFrom(motion.contacts(0), 0); stride;
       stride = StrideFrom(motion.contacts(0), stride->end)) {
    if (tick < stride->lift_off) return std::nullopt;
    if (tick < stride->end) {
      return static_cast<double>(tick - stride->lift_off) /
             static_cast<double>(stride->end - stride->lift_off);
    }
  }
  return std::nullopt;
}

std::vector<Push> ResolvePushes(const std::vector<PushEntry>& entries, const Scenario& scenario,
                                const ConfigTree& root) {
  std::vector<Push> pushes;
  Yardstick yardstick(scenario);
  for (const PushEntry& entry : entries) {
    const std::string path = "pushes." + std::to_string(pushes.size());
    Push& push = pushes.emplace_back(entry.push);
    push.start_s = Start_s(entry, path, scenario, root, &yardstick);
    if (entry.force_N) {
      push.force_N = *entry.force_N;
      continue;
    }
    const double direction_rad = *entry.direction_rad;
    push.force_N = Magnitude_N(entry, &yardstick) *
                   Eigen::Vector3d(std::cos(direction_rad), std::sin(direction_rad), 0);
    push.frame = PushFrame::kHeading;
  }
  return pushes;
}

}  // namespace sidestep
