// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sweep_plan: a sweep's rays, each with an id that tells what it is of, and the folder they are in.
//
// A folder holds sweep.yaml (the whole sweep), manifest.csv (a line a ray), rows-I-of-N.csv (what
// shard I of N has run), and in the end cells.csv, strengths.csv and rays.csv. Who plans and who
// runs may be different processes on different machines that see the same folder and program.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "controller/types/tick.h"
#include "sim/scenario/scenario.h"
#include "sim/sweep/rays.h"

namespace sidestep {

/// A ray with what its first cell tells.
struct PlannedRay {
  Ray ray;
  std::string id;  ///< Hash of the resolved scenario, the robot's files, the search, the program.
  std::string prefix;  ///< Hash of PrefixText().
  Tick start_tick{0};  ///< FirstPushTick().
};

struct SweepPlan {
  SweepSpec spec;
  std::vector<PlannedRay> rays;  ///< In order of their index.
};

/// Tells this program from any other: a hash of its own file.
std::string ProgramHash();

/// The scenario of a cell. @throws ConfigError as ReadScenario.
Scenario ScenarioOf(const SweepSpec& spec, const Ray& ray, const CellKey& cell);

/// The ray as this program plans it. Reads its first cell; throws ConfigError if that is no
/// scenario.
PlannedRay PlanRay(const SweepSpec& spec, const Ray& ray, const std::string& program_hash);

/// Plans all rays. @param progress  Told of the share that is done.
SweepPlan MakePlan(const SweepSpec& spec, const std::function<void(double)>& progress);

/// Writes sweep.yaml and manifest.csv. If the folder holds the very same sweep, by the same
/// program, it is left as it is. @throws ConfigError if it holds another.
void WritePlan(const SweepPlan& plan, const std::filesystem::path& folder);

/// Whether the folder holds this very sweep by this very program, so that MakePlan is not needed.
/// @throws ConfigError if it holds another sweep, or one that another program planned.
bool HoldsPlan(const SweepSpec& spec, const std::filesystem::path& folder);

/// Reads what WritePlan wrote. @throws ConfigError if it is not there, not whole, or planned by
/// another program than this one.
SweepPlan ReadPlan(const std::filesystem::path& folder);

}  // namespace sidestep
