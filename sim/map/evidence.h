// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// evidence: a map's worst cells, run once more with plots and video.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/map/sweep_map.h"
#include "sim/sweep/sweep_plan.h"

namespace sidestep::map {

/// A cell and its point to be shown: the smallest impulse that was lost.
struct WorstPoint {
  std::size_t cell{0};  ///< In SweepMap::cells.
  const MapPoint* point{nullptr};
};

/// Of each controller the cells that survive least and were lost, `most` at most; by controller,
/// the worst first, cells that are alike in the map's order. Points into `map`.
std::vector<WorstPoint> WorstPoints(const SweepMap& map, std::size_t most);

/// What a run folder shows and how its verdict compares with the row's `expected`.
/// @throws ConfigError if it holds no summary.
CellEvidence ReadEvidence(const std::filesystem::path& run_dir, CellOutcome expected);

/// The worst cells' runs: how many a controller, and who runs them.
struct EvidenceOrder {
  int worst{0};
  std::filesystem::path program;  ///< `sidestep`; its `run` is asked for.
};

/// Runs the worst cells' smallest lost pushes into `folder`/cells/ray_..., each as its row's
/// command has it, and fills in every cell's `evidence`, also of runs that lie there from before;
/// what was run is not run again. Trajectory and states, the bulk of a run, do not stay. `note` is
/// told of a run that failed to be made, or whose verdict is not its row's.
void AddEvidence(const SweepPlan& plan, const std::filesystem::path& folder,
                 const EvidenceOrder& order, const std::function<void(const std::string&)>& note,
                 SweepMap* map);

}  // namespace sidestep::map
