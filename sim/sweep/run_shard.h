// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// run_shard: runs a sweep's rays, or one shard's share of them, on some processes.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>

#include "sim/sweep/keep_run.h"
#include "sim/sweep/sweep_plan.h"

namespace sidestep {

struct ShardOptions {
  int shard{0};  ///< Takes the rays whose index over `shards` leaves this.
  int shards{1};
  int jobs{1};  ///< Processes at once.
  /// No ray is started that would not end by then, going by the longest so far (s).
  double time_budget_s{std::numeric_limits<double>::infinity()};
  KeepOptions keep;
};

/// What a shard has come to.
struct ShardReport {
  std::size_t rays{0};       ///< Its share.
  std::size_t rays_done{0};  ///< Those of an earlier start included.
  std::size_t runs{0};       ///< Of this start.
  std::size_t invalid{0};    ///< INVALID rows, earlier ones included.
  bool was_interrupted{false};
};

/// Told now and then, and of what a user should see although nothing is wrong.
struct ShardListener {
  std::function<void(const ShardReport& so_far)> progress;
  std::function<void(const std::string& line)> note;
};

/// The file of a shard's rows.
std::filesystem::path RowsPath(const std::filesystem::path& folder, int shard, int shards);

/// Runs what is missing of the shard. On SIGINT or SIGTERM the cells in progress are given up and
/// all rows stay. A cell that ends its process is INVALID, reason ERROR.
/// @throws ConfigError if the rows' file is another process's or another sweep's, or a scenario
///         can't be read.
ShardReport RunShard(const SweepPlan& plan, const std::filesystem::path& folder,
                     const ShardOptions& options, const ShardListener& listener);

}  // namespace sidestep
