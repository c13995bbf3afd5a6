// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/keep_run.h"

#include <string>

#include "sim/episode/run_scenario.h"

namespace sidestep {

std::filesystem::path KeptRunFolder(const std::filesystem::path& sweep_folder,
                                    const CellKey& cell) {
  std::string name = "ray_" + std::to_string(cell.ray);
  if (!cell.strength.empty()) name += "_" + cell.strength;
  if (!cell.seed.empty()) name += "_seed_" + cell.seed;
  return sweep_folder / "runs" / name;
}

void KeepRun(const KeepOptions& options, CellOutcome outcome, const Scenario& scenario,
             const std::filesystem::path& folder) {
  const Keep keep = options.keep;
  const bool is_failure = outcome != CellOutcome::kRecovered;
  if (keep == Keep::kNone || (keep == Keep::kFailures && !is_failure)) return;
  RunOptions run;
  run.out_dir = folder;
  run.log = keep == Keep::kSummary ? LogDetail::kNone : options.log;
  RunScenario(scenario, run);
  if (keep != Keep::kSummary) return;
  for (const char* file : {"mpc.csv", "footsteps.csv"}) {
    std::filesystem::remove(folder / file);
  }
  std::filesystem::remove_all(folder / "problems");
}

}  // namespace sidestep
