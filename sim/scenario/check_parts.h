// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// check_parts: the parts of CheckScenario() that have files of their own. Each throws ConfigError
// at the offending place of `root`, the tree that the scenario was read from.

#include <string>

#include "models/support/config_tree.h"
#include "sim/scenario/renamed_keys.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

/// Whether a robot that moves in a plane is asked for nothing sideways: its feet keep the distance
/// that they have, and neither steps nor the CoM's reference nor pushes leave the plane.
void CheckPlane(const Scenario& scenario, const ConfigTree& root);

/// Whether the servos that move the robot are stable in the world's physics steps.
void CheckServos(const Scenario& scenario, const ConfigTree& root);

/// Tells `note` of servos that are allowed but worth a warning, at their place in the robot.yaml.
void WarnOfServos(const Scenario& scenario, const NoteSink& note);

/// Whether the ground's patches are rectangles, clear of each other and of the robot's soles where
/// it starts.
void CheckGround(const Scenario& scenario, const ConfigTree& root);

/// Fails about `path` at its own place or, if the file leaves it to its default, at `other`'s.
[[noreturn]] void FailAtEither(const ConfigTree& root, const std::string& path,
                               const std::string& other, const std::string& what);

}  // namespace sidestep
