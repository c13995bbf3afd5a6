// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// scenario_schema: what an editor needs to complete and check a scenario while it is written.

#include <string>

namespace sidestep {

/// A JSON Schema (draft 2020-12) of a scenario file, generated from the key table: types, bounds,
/// choices, defaults and meanings; no other keys are allowed. It tells what each key may be; what
/// only keys together can tell (CheckScenario), names of robots and of bodies, and the letters of a
/// name are left to `sidestep validate`. Ends in a newline.
std::string ScenarioSchema();

}  // namespace sidestep
