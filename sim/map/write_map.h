// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// write_map: the pictures of a sweep's folder.

#include <filesystem>
#include <functional>
#include <string>

#include "sim/map/evidence.h"
#include "sim/sweep/sweep_plan.h"

namespace sidestep {

/// Writes folder/map.svg, map.png and map.html from folder/cells.csv and the plan. Without gnuplot
/// there is no PNG, with a note. `evidence` says how many of the worst cells are run again for
/// their plots and video (map/evidence.h).
/// @throws ConfigError if cells.csv is missing or broken, or a file can't be written.
void WriteMap(const SweepPlan& plan, const std::filesystem::path& folder,
              const map::EvidenceOrder& evidence,
              const std::function<void(const std::string&)>& note);

}  // namespace sidestep
