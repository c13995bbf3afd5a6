// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// keep_run: which cells of a sweep leave more than a row, and what.

#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "controller/types/field.h"
#include "sim/record/log_detail.h"
#include "sim/scenario/scenario.h"
#include "sim/sweep/rays.h"

namespace sidestep {

/// What stays beside the rows. What is kept is run once more, whole, with a recorder: the same run.
enum class Keep {
  kNone,
  kFailures,  ///< The run folders of cells that did not recover.
  kSummary,   ///< scenario.yaml and summary.json of every cell.
  kAll        ///< The run folder of every cell.
};

template <>
struct EnumNames<Keep> {
  static constexpr std::array<std::pair<Keep, std::string_view>, 4> kNames{
      {{Keep::kNone, "none"},
       {Keep::kFailures, "failures"},
       {Keep::kSummary, "summary"},
       {Keep::kAll, "all"}}};
};

/// Where a cell's run is kept within a sweep's folder: runs/ray_R[_strength][_seed_N].
std::filesystem::path KeptRunFolder(const std::filesystem::path& sweep_folder, const CellKey& cell);

/// What is kept, and of a run folder how much of its ticks.
struct KeepOptions {
  Keep keep{Keep::kNone};
  LogDetail log{LogDetail::kNormal};
};

/// Keeps what `options` ask of a cell that came out as `outcome`.
void KeepRun(const KeepOptions& options, CellOutcome outcome, const Scenario& scenario,
             const std::filesystem::path& folder);

}  // namespace sidestep
