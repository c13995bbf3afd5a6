// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/shard_name.h"

#include <cstdio>
#include <optional>

#include "models/support/config_error.h"

namespace sidestep {
namespace {

constexpr int kMostShards = 1'000'000;

struct Launcher {
  const char* rank;
  const char* size;
};

constexpr Launcher kLaunchers[] = {{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                   {"PMI_RANK", "PMI_SIZE"},
                                   {"SLURM_PROCID", "SLURM_NTASKS"}};

std::optional<ShardName> ParsePair(const std::string& text) {
  ShardName name;
  int length = 0;
  const bool is_pair =
      std::sscanf(text.c_str(), "%d/%d%n", &name.shard, &name.shards, &length) == 2;
  const bool is_good = is_pair && static_cast<std::size_t>(length) == text.size() &&
                       name.shard >= 0 && name.shard < name.shards && name.shards <= kMostShards;
  return is_good ? std::optional(name) : std::nullopt;
}

}  // namespace

ShardName ParseShard(const std::string& text,
                     const std::function<const char*(const char*)>& getenv) {
  if (text != "auto") {
    if (const auto name = ParsePair(text)) return *name;
    throw ConfigError("--shard " + text +
                      ": error: must read I/N with 0 <= I < N, such as 0/8, or auto");
  }
  for (const Launcher& launcher : kLaunchers) {
    const char* const rank = getenv(launcher.rank);
    const char* const size = getenv(launcher.size);
    if (rank == nullptr || size == nullptr) continue;
    const auto name = ParsePair(std::string(rank) + "/" + size);
    if (!name) {
      throw ConfigError(std::string("--shard auto: error: ") + launcher.rank + "=" + rank + " of " +
                        launcher.size + "=" + size + " is no shard; write I/N");
    }
    if (name->shards > 1) return *name;
  }
  throw ConfigError(
      "--shard auto: error: neither mpirun nor srun runs this in more than one "
      "process; write I/N");
}

}  // namespace sidestep
