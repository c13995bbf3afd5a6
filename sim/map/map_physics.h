// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// map_physics: the limit of a linear pendulum under the measured map (sim/limit).

#include <string>

#include "sim/map/sweep_map.h"
#include "sim/scenario/scenario.h"
#include "sim/sweep/sweep_plan.h"

namespace sidestep::map {

/// When a push comes, in the frame of a step as sim/limit has it.
struct StepMoment {
  double time_s{0.0};       ///< Since the step's begin.
  bool is_mirrored{false};  ///< The right foot swings, or landed last: left and right change.
};

/// The step that `scenario` asks for at `push_s`. Of a walk it is the one of the foot in the air,
/// or of the foot that landed last, since its lift-off; of a hop since touch-down; of a stand 0.
StepMoment MomentOf(const Scenario& scenario, double push_s);

/// Fills in omega, and every cell's `physical_Nspkg`: what a pendulum with this robot's soles,
/// reach and swing survives of a push at its CoM that begins at the cell's moment and lasts as
/// long. One for all controllers, from the first one's scenario: it is physics, and no controller's
/// choice. Where there is none (a run, a scenario without pushes) `physics_note` says why. Never
/// throws.
void AddPhysics(const SweepPlan& plan, SweepMap* map);

}  // namespace sidestep::map
