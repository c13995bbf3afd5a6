// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// check_scenario: what no single key of a scenario can tell: whether the keys fit together.

#include "models/support/config_tree.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

/// Checks that the robot suits plant, mode, sensing and gaits, that pushes name its parts and end
/// in time, that a robot in a plane is asked for nothing sideways, that rates are whole numbers of
/// physics steps and that boxes are not empty. `root` is the tree the scenario was read from;
/// throws ConfigError at the offending place.
void CheckScenario(const Scenario& scenario, const ConfigTree& root);

/// Its first part: robot, rates, boxes and gaits. What this passes has a nominal gait, by which
/// pushes are told.
void CheckMotion(const Scenario& scenario, const ConfigTree& root);

/// The rest of it: ground, pushes, and what they do to a robot in a plane.
void CheckSurroundings(const Scenario& scenario, const ConfigTree& root);

}  // namespace sidestep
