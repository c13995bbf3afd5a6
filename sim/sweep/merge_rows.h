// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// merge_rows: the rows of all shards as one, and what is missing of them.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/sweep/cell_row.h"
#include "sim/sweep/sweep_plan.h"

namespace sidestep {

/// All rows of a sweep's folder.
struct MergedRows {
  CellRows rows;
  int shards{1};  ///< Largest N of the files rows-I-of-N.csv.
};

/// Reads every file of rows. A cell that is there twice must be the same but for the columns of the
/// machine. Half-written last rows are passed over, with a note.
/// @throws ConfigError if two rows of a cell differ or a row is of another sweep.
MergedRows ReadAllRows(const SweepPlan& plan, const std::filesystem::path& folder,
                       const std::function<void(const std::string&)>& note);

/// A ray as its rows tell it.
struct RayResult {
  std::size_t ray{0};
  LimitResult search;                 ///< Not complete: rows are missing.
  std::vector<const CellRow*> cells;  ///< In the order of the search.
};

/// Walks every ray through the rows; in order of their index.
std::vector<RayResult> ResultsOf(const SweepPlan& plan, const CellRows& rows);

/// What an option `--array=` of Slurm takes for these numbers, rising: `3,7,12-15`.
std::string ArrayText(const std::vector<std::size_t>& numbers);

/// The shards, of `shards`, whose rays are not complete; rising.
std::vector<std::size_t> MissingShards(const std::vector<RayResult>& results, int shards);

}  // namespace sidestep
