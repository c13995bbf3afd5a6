// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/shard_name.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/support/temp_folder.h"

namespace sidestep::shard_name_test {
namespace {

using Environment = std::map<std::string, std::string>;

ShardName Parse(const std::string& text, const Environment& environment = {}) {
  return ParseShard(text, [&](const char* name) -> const char* {
    const auto found = environment.find(name);
    return found == environment.end() ? nullptr : found->second.c_str();
  });
}

std::string ErrorOf(const std::string& text, const Environment& environment = {}) {
  return TempFolder().ErrorOf([&] { Parse(text, environment); });
}

TEST(ShardNameTest, IsWhatIsTold) {
  EXPECT_EQ(Parse("3/7").shard, 3);
  EXPECT_EQ(Parse("3/7").shards, 7);
  for (const char* text : {"", "7/7", "-1/3", "1", "1/2x", "1/0", "a/b", "0/2000000"}) {
    EXPECT_NE(ErrorOf(text), "no error") << text;
  }
}

TEST(ShardNameTest, TheRankIsTheShard) {
  const ShardName rank = Parse("auto", {{"SLURM_PROCID", "2"}, {"SLURM_NTASKS", "4"}});
  EXPECT_EQ(rank.shard, 2);
  EXPECT_EQ(rank.shards, 4);
  const ShardName mpi = Parse("auto", {{"SLURM_PROCID", "0"},
                                       {"SLURM_NTASKS", "1"},
                                       {"OMPI_COMM_WORLD_RANK", "5"},
                                       {"OMPI_COMM_WORLD_SIZE", "8"}});
  EXPECT_EQ(mpi.shard, 5);
  EXPECT_EQ(mpi.shards, 8);
}

TEST(ShardNameTest, Errors) {
  EXPECT_EQ(ErrorOf("3/3"),
            "--shard 3/3: error: must read I/N with 0 <= I < N, such as 0/8, or auto");
  EXPECT_EQ(ErrorOf("auto"),
            "--shard auto: error: neither mpirun nor srun runs this in more than one process; "
            "write I/N");
  // An array submitted again in part counts its own tasks: it is no launcher.
  EXPECT_NE(ErrorOf("auto", {{"SLURM_ARRAY_TASK_ID", "1"}, {"SLURM_ARRAY_TASK_COUNT", "3"}}),
            "no error");
  EXPECT_EQ(ErrorOf("auto", {{"PMI_RANK", "12"}, {"PMI_SIZE", "3"}}),
            "--shard auto: error: PMI_RANK=12 of PMI_SIZE=3 is no shard; write I/N");
}

}  // namespace
}  // namespace sidestep::shard_name_test
