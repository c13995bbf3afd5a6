// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/slurm_script.h"

#include <gtest/gtest.h>

#include "sim/process/process.h"
#include "tests/support/run_files.h"
#include "tests/support/temp_folder.h"

namespace sidestep::slurm_script_test {
namespace {

SlurmSpec SevenShards() {
  SlurmSpec spec;
  spec.name = "hop_map";
  spec.program = "/opt/side step/sidestep";
  spec.folder = "/data/it's 50%/map";
  spec.shards = 7;
  spec.tasks = {0, 1, 2, 3, 4, 5, 6};
  return spec;
}

bool Has(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST(SlurmScriptTest, ShardsAreNoMoreThanRaysOrThanAnArrayMayHave) {
  EXPECT_EQ(UsualShards(0, 1001), 1);
  EXPECT_EQ(UsualShards(8, 1001), 8);
  EXPECT_EQ(UsualShards(100000, 1001), 100);
  EXPECT_EQ(UsualShards(100000, 30), 30);
}

TEST(SlurmScriptTest, TheArrayIsTheShardsThatAreAskedFor) {
  SlurmSpec spec = SevenShards();
  spec.tasks = {1, 3, 4, 5};
  spec.throttle = 2;
  spec.options = {"--time=4:00:00"};
  EXPECT_EQ(ArrayScript(spec), R"(#!/bin/bash
#SBATCH --job-name=hop_map
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --array=1,3-5%2
#SBATCH --signal=B:USR1@120
#SBATCH --output="/data/it's 50%%/map/slurm-%A_%a.log"
#SBATCH --open-mode=append
#SBATCH --time=4:00:00
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
exec '/opt/side step/sidestep' sweep run '/data/it'\''s 50%/map' --shard $SLURM_ARRAY_TASK_ID/7 --jobs 1 --quiet
)");
}

TEST(SlurmScriptTest, TheMergeKnowsHowManyShardsThereAre) {
  EXPECT_TRUE(
      Has(MergeScript(SevenShards()), " sweep merge '/data/it'\\''s 50%/map' --shards 7\n"));
}

TEST(SlurmScriptTest, TellsHowToDoWithoutSlurm) {
  SlurmSpec spec = SevenShards();
  EXPECT_TRUE(Has(SubmitScript(spec), " --shard {}/7 --jobs 1 --quiet ::: {0..6}; "));
  EXPECT_TRUE(Has(SubmitScript(spec), "srun -n 7 "));
  spec.tasks = {2, 5};
  EXPECT_TRUE(Has(SubmitScript(spec), " ::: 2 5; "));
}

// A shell of ours runs it with an sbatch that keeps what it is given.
TEST(SlurmScriptTest, SubmitsTheArrayAndTheMergeAfterIt) {
  const TempFolder folder;
  const std::filesystem::path sbatch =
      folder.Write("sbatch",
                   "#!/bin/bash\nn=$(ls \"$KEPT\" | wc -l)\n"
                   "{ echo \"$@\"; cat; } >\"$KEPT/$n\"\necho \"4$n;cluster\"\n");
  std::filesystem::permissions(sbatch, std::filesystem::perms::owner_all);
  const std::filesystem::path kept = folder.path() / "kept";
  std::filesystem::create_directory(kept);
  const ProcessResult said = RunProcess(
      {"env", "KEPT=" + kept.string(), "PATH=" + folder.path().string() + ":/usr/bin:/bin", "bash",
       "-s", "--", "--array=3,5"},
      SubmitScript(SevenShards()));
  EXPECT_EQ(said.out, "array 40, merge 41\n") << said.err;
  EXPECT_EQ(TextOf(kept / "0"), "--parsable --array=3,5\n" + ArrayScript(SevenShards()));
  EXPECT_EQ(TextOf(kept / "1"),
            "--parsable --dependency=afterany:40\n" + MergeScript(SevenShards()));
}

TEST(SlurmScriptTest, Errors) {
  const TempFolder folder;
  SlurmSpec spec = SevenShards();
  spec.folder = "/data/a\nb";
  EXPECT_EQ(folder.ErrorOf([&] { ArrayScript(spec); }),
            "sweep slurm: error: the folder's name has a line's end in it");
  spec = SevenShards();
  spec.options = {"time=4"};
  EXPECT_EQ(folder.ErrorOf([&] { SubmitScript(spec); }),
            "--sbatch time=4: error: must be an option of sbatch, such as "
            "--sbatch=--time=4:00:00");
}

}  // namespace
}  // namespace sidestep::slurm_script_test
