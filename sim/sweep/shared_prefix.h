// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// shared_prefix: what scenarios share that differ in their pushes only.

#include <string>

#include "controller/types/tick.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

/// The scenario without what is written of a run or decides whether it passes: nothing in the run
/// itself depends on that.
Scenario WithoutWords(Scenario scenario);

/// Scenarios with the same text differ in nothing that happens before their first push but its
/// time: pushes are reduced to their number and bodies, and what only names or judges is left out.
std::string PrefixText(const Scenario& scenario);

/// Tick at which the first push starts; -1 without pushes.
Tick FirstPushTick(const Scenario& scenario);

}  // namespace sidestep
