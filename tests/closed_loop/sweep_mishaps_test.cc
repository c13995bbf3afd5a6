// SPDX-License-Identifier: BSD-3-Clause
// `sidestep sweep` where things go wrong around it, and the jobs it writes for a cluster: one clear
// line, and nothing that was run is lost.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/process/process.h"
#include "tests/support/run_files.h"
#include "tests/support/sidestep_program.h"
#include "tests/support/temp_folder.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHopInPlace = R"(sidestep: 1
name: hop
robot: hopper
duration_s: 1.5
gait:
  - {type: stand, start_s: 0.0}
  - {type: hop, start_s: 0.5, stance_s: 0.15, flight_s: 0.15, swing_height_m: 0.05}
sensors: {gyro_noise_radps: 0.005}
)";

class SweepMishapsTest : public testing::Test {
 protected:
  // Of a shell in which $sidestep, $hop and $map are what they say.
  ProcessResult Shell(const std::string& command) const {
    return RunProcess({"env", "sidestep=" SIDESTEP_BINARY, "hop=" + hop_.string(),
                       "map=" + map_.string(), "bash", "-c", command});
  }

  std::vector<std::string> WholeSweep() const {
    return {"sweep", hop_, "-o", map_, "-q", "--vary", "seed=1:12:12"};
  }

  const TempFolder folder_;
  const fs::path hop_ = folder_.Write("hop.yaml", kHopInPlace);
  const fs::path map_ = folder_.path() / "it's a map";
};

// A limit on the size of files stands for a disk that is full.
TEST_F(SweepMishapsTest, ADiskThatIsFullLosesNoRow) {
  const std::string sweep = "exec $sidestep sweep $hop -o \"$map\" -q --vary seed=1:12:12";
  const ProcessResult full = Shell("ulimit -f 6; trap '' XFSZ; " + sweep);
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_EQ(folder_.Shorten(full.err),
            "it's a map/rows-0-of-1.csv: error: can't be written: File too large\n");
  const std::string kept = TextOf(map_ / "rows-0-of-1.csv");
  const std::string whole = kept.substr(0, kept.rfind('\n') + 1);
  EXPECT_GT(std::count(whole.begin(), whole.end(), '\n'), 2);
  const ProcessResult again = Sidestep(WholeSweep());
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_TRUE(TextOf(map_ / "rows-0-of-1.csv").starts_with(whole));
}

TEST_F(SweepMishapsTest, APlanThatWasCutShortIsPlannedAgain) {
  fs::create_directory(map_);
  std::ofstream(map_ / "sweep.yaml.part") << "sidestep_sw";
  const ProcessResult run = Sidestep(WholeSweep());
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST_F(SweepMishapsTest, AFolderOfOtherThingsIsLeftAlone) {
  folder_.Write("it's a map/thesis.tex", "");
  const ProcessResult run = Sidestep(WholeSweep());
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(folder_.Shorten(run.err),
            "it's a map: error: is not empty and holds no sweep; take another folder\n");
}

TEST_F(SweepMishapsTest, StandardOutputThatIsFullIsTold) {
  ASSERT_EQ(Sidestep(WholeSweep()).exit_code, 0);
  const ProcessResult merge = Shell("$sidestep sweep merge \"$map\" >/dev/full");
  EXPECT_EQ(merge.exit_code, 2);
  EXPECT_EQ(merge.err,
            "sidestep: error: standard output can't be written: No space left on device\n");
}

TEST_F(SweepMishapsTest, NumbersThatAreNoneAreRefused) {
  std::vector<std::string> words = WholeSweep();
  words.insert(words.end(), {"--time-budget", "nan"});
  const ProcessResult run = Sidestep(words);
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(run.err, "sidestep: error: --time-budget: 'nan' is no number above 0 (see --help)\n");
}

// What the array asks for is what the rows lack.
TEST_F(SweepMishapsTest, SlurmIsAskedForTheShardsThatAreMissing) {
  const auto slurm = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"sweep", "slurm", map_};
    words.insert(words.end(), more.begin(), more.end());
    return Sidestep(words);
  };
  std::vector<std::string> plan = WholeSweep();
  plan.insert(plan.begin() + 1, "plan");
  ASSERT_EQ(Sidestep(plan).exit_code, 0);
  const ProcessResult first = slurm({"--shards", "3", "--throttle", "2"});
  EXPECT_EQ(first.exit_code, 0) << first.err;
  EXPECT_NE(first.out.find("#SBATCH --array=0-2%2\n"), std::string::npos) << first.out;

  ASSERT_EQ(Sidestep({"sweep", "run", map_, "--shard", "1/3", "-q"}).exit_code, 0);
  const ProcessResult rest = slurm({});
  EXPECT_NE(rest.out.find("#SBATCH --array=0,2\n"), std::string::npos) << rest.out;
  const ProcessResult too_many = slurm({"--shards", "2000"});
  EXPECT_EQ(too_many.exit_code, 2);
  EXPECT_EQ(too_many.err,
            "sweep slurm: error: 2000 shards are more than an array may have, 1001 (Slurm's "
            "MaxArraySize: scontrol show config); --max-array if it is another\n");

  for (const char* shard : {"0/3", "2/3"}) {
    ASSERT_EQ(Sidestep({"sweep", "run", map_, "--shard", shard, "-q"}).exit_code, 0);
  }
  const ProcessResult none = slurm({});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_EQ(folder_.Shorten(none.err),
            "it's a map: error: no shard is missing; sidestep sweep merge joins them\n");
}

}  // namespace
}  // namespace sidestep
