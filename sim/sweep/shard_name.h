// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// shard_name: which share of a sweep a process takes, as told or as its launcher tells it.

#include <functional>
#include <string>

namespace sidestep {

struct ShardName {
  int shard{0};
  int shards{1};  ///< 0 <= shard < shards.
};

/// `I/N`, or `auto`: rank and size of mpirun (OMPI_COMM_WORLD_*, PMI_*) or of srun (SLURM_PROCID,
/// SLURM_NTASKS), the first of them that has more than one process. Not of a Slurm array: one that
/// is submitted again in part counts only that part.
/// @param getenv  Gives an environment variable or null.
/// @throws ConfigError if it is neither, or there is no such launcher.
ShardName ParseShard(const std::string& text,
                     const std::function<const char*(const char*)>& getenv);

}  // namespace sidestep
