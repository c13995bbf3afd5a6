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

void KeepRun(Keep keep, CellOutcome outcome, const Scenario& scenario,
             const std::filesystem::path& folder) {
  const bool is_failure = outcome != CellOutcome::kRecovered;
  if (keep == Keep::kNone || (keep == Keep::kFailures && !is_failure)) return;
  RunOptions options;
  options.out_dir = folder;
  RunScenario(scenario, options);
  if (keep != Keep::kSummary) return;
  for (const char* file : {"trajectory.csv", "mpc.csv", "states.bin", "footsteps.csv"}) {
    std::filesystem::remove(folder / file);
  }
  std::filesystem::remove_all(folder / "problems");
}

}  // namespace sidestep
