// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// read_sections: the parts of a scenario file that are more than a list of fields.
//
// Every function throws ConfigError at the offending place.

#include <optional>
#include <vector>

#include "models/support/config_node.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

/// `gait: {...}` or a list of them; standing if there is none. Unless told otherwise a robot
/// of one foot has step_width_m 0, one that moves in a plane its own feet's distance.
std::vector<GaitParams> ReadGaits(const std::optional<ConfigNode>& node,
                                  const RobotDescription& robot);

/// `pushes: [...]`, each with one way to tell its force and one to tell its start.
std::vector<PushEntry> ReadPushes(const ConfigNode& node);

/// `expect: {metric: number | bool | {min, max}}`, in the file's order.
std::vector<Expectation> ReadExpectations(const ConfigNode& node);

/// `video: {size, fps, camera}`, `true` or `false`.
VideoParams ReadVideo(const ConfigNode& node);

}  // namespace sidestep
