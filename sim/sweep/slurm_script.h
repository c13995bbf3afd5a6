// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// slurm_script: a planned sweep as jobs of Slurm, and as commands for those who have none.
//
// The array's tasks are the shards. What is missing is known from the rows alone, never from
// Slurm's accounting.

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace sidestep {

/// Slurm's MaxArraySize unless its administrator chose another: task numbers are below it.
constexpr int kUsualMaxArraySize = 1001;

/// How a planned sweep is to be run on a cluster.
struct SlurmSpec {
  std::string name;               ///< Of the jobs; as SweepSpec::name, a word without spaces.
  std::filesystem::path program;  ///< Absolute; where every node sees it.
  std::filesystem::path folder;   ///< Of the plan; absolute.
  int shards{1};
  std::vector<std::size_t> tasks;    ///< Numbers of the shards to run, rising.
  int throttle{0};                   ///< Tasks at once; 0: as many as there is room for.
  std::vector<std::string> options;  ///< More options of sbatch for the array: `--time=4:00:00`.
};

/// How many shards to make of so many rays: what comes before a push is simulated once a shard, so
/// more of them cost more; never more than `max_array_size` or than rays.
int UsualShards(std::size_t rays, int max_array_size);

/// The script that sbatch takes for the array. Tasks are requeued if their node is lost, and told
/// to end 120 s before their time is up; started again they go on.
/// @throws ConfigError if the folder's or the program's name has a line's end in it, or an option
///         does not begin with `--` or has one.
std::string ArrayScript(const SlurmSpec& spec);

/// The script that sbatch takes for the job that comes after the array. @throws as ArrayScript.
std::string MergeScript(const SlurmSpec& spec);

/// A script for a shell that submits both, and tells in its comments how to do without Slurm.
/// Its arguments go to the array's sbatch: `--array=3,7` as `sweep merge` says. @throws as
/// ArrayScript.
std::string SubmitScript(const SlurmSpec& spec);

}  // namespace sidestep
