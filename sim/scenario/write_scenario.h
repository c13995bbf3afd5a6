// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// write_scenario: a scenario as the file that would give it again, whatever defaults become.

#include <string>

#include "sim/scenario/scenario.h"

namespace sidestep {

/// The scenario as YAML with every default written out and every push by its force_N and start_s.
/// Reading it back gives the same scenario, bit for bit. A robot that ships is written by its name,
/// any other by the absolute path of its robot.yaml, so that the text may be put anywhere.
std::string ResolvedYaml(const Scenario& scenario);

}  // namespace sidestep
