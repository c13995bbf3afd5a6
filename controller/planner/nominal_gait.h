// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// nominal_gait: the gait of an undisturbed robot over a whole episode, for those who measure by it.
//
// A pure function of the scenario: no state of a planner, no shift, no order. The robot starts
// standing, feet side by side. The CoM's motion along it is NominalComAt (contact_schedule.h).

#include <vector>

#include "controller/planner/contact_schedule.h"
#include "controller/planner/gait_setup.h"
#include "controller/types/gait_params.h"
#include "controller/types/tick.h"

namespace sidestep {

/// A schedule whose horizon is the episode.
using NominalGait = ContactSchedule;

/// Lays contacts out until `end_tick` at least. `segments` are in order of start_s, the first at 0.
/// A contact whose end is not known lasts to the end; its end_tick is no earlier than `end_tick`.
/// Throws ContractViolation without segments. Takes memory.
NominalGait BuildNominalGait(const std::vector<GaitParams>& segments, const GaitGeometry& geometry,
                             Tick end_tick, double tick_s);

}  // namespace sidestep
