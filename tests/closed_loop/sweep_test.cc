// SPDX-License-Identifier: BSD-3-Clause
// `sidestep sweep` as its user has it: in one or in shards, killed and gone on with, the table is
// the same; and a cell is its straight run.

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "sim/episode/run_episode.h"
#include "sim/process/process.h"
#include "sim/scenario/read_scenario.h"
#include "sim/sweep/cell_runner.h"
#include "sim/sweep/csv_line.h"
#include "tests/support/run_files.h"
#include "tests/support/sidestep_program.h"
#include "tests/support/temp_folder.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

// A hop that is shoved once; a tenth of a second of a core each.
constexpr const char* kHop = R"(sidestep: 1
name: hop
robot: hopper
duration_s: 5.5
gait:
  - {type: stand, start_s: 0.0}
  - {type: hop, start_s: 0.5, stance_s: 0.15, flight_s: 0.15, swing_height_m: 0.05}
pushes:
  - {body: trunk, force_N: [5, 0, 0], start_s: 2.0, duration_s: 0.3}
sensors: {gyro_noise_radps: 0.005, touch_noise_N: 0.05}
)";
constexpr const char* kSweep = R"(sidestep_sweep: 1
name: hop_map
scenario: hop.yaml
set: {pushes.0.after_s: 1.5}
vary:
  pushes.0.direction_rad: [0, 2]
  pushes.0.at_phase: [0.25, mid_stance]
limit: {key: pushes.0.impulse_Nspkg, ladder: [1, 2, 6], resolution: 1}
controllers:
  ours: {}
  fixed: {control.mpc.box_lower_m: [0, 0, 0], control.mpc.box_upper_m: [0, 0, 0]}
)";

class SweepTest : public testing::Test {
 protected:
  SweepTest() { folder_.Write("hop.yaml", kHop); }

  // In one go, into `folder`.
  ProcessResult Sweep(const fs::path& folder, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"sweep", sweep_, "-o", folder, "-q"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Sidestep(arguments);
  }

  // Waits until a file has so many lines; gives up after half a minute.
  static void WaitForLines(const fs::path& file, int lines) {
    for (int i = 0; i < 3000; ++i) {
      const std::string text = TextOf(file);
      if (std::count(text.begin(), text.end(), '\n') >= lines) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ADD_FAILURE() << file << " does not grow";
  }

  // All tables, without what a clock and the machine wrote.
  static std::string Tables(const fs::path& folder) {
    std::istringstream cells(TextOf(folder / "cells.csv"));
    std::string text = TextOf(folder / "rays.csv") + TextOf(folder / "strengths.csv");
    for (std::string line; std::getline(cells, line);) {
      std::vector<std::string> row = SplitCsvLine(line);
      row.resize(row.size() - 3);
      text += CsvLine(row) + "\n";
    }
    return text;
  }

  const TempFolder folder_;
  const fs::path sweep_ = folder_.Write("map.yaml", kSweep);
  const fs::path one_ = folder_.path() / "one";
  const fs::path other_ = folder_.path() / "other";
};

TEST_F(SweepTest, AFolderIsCheckedWithoutItsSweepsAndValidatedWithThem) {
  const ProcessResult both = Sidestep({"validate", folder_.path()});
  EXPECT_EQ(both.exit_code, 0) << both.err;
  EXPECT_EQ(folder_.Shorten(both.out), "ok: hop.yaml\nok: map.yaml\n");
  const ProcessResult check =
      Sidestep({"check", folder_.path(), "-q", "-o", one_, "--set", "duration_s=2.5"});
  EXPECT_EQ(check.exit_code, 0) << check.err;
  EXPECT_EQ(check.out.find("map"), std::string::npos) << check.out;

  const ProcessResult run = Sidestep({"run", sweep_, "-o", other_});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_EQ(folder_.Shorten(run.err),
            "map.yaml:1:1: error: is a sweep's file, no scenario's; sidestep sweep runs it\n");
}

// A value that no run of the sweep could have.
TEST_F(SweepTest, EveryRayOfASweepIsValidated) {
  std::string text = kSweep;
  text.replace(text.find("mid_stance"), 10, "mid_dance");
  folder_.Write("map.yaml", text);
  const ProcessResult run = Sidestep({"validate", sweep_});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("mid_dance"), std::string::npos) << run.err;
}

// The smallest push that fixed footholds lose, from the command that the page shows for it.
TEST_F(SweepTest, WorstCellsAreRunAgainWithPlotsAndVideo) {
  std::string text = kSweep;
  text.replace(text.find("direction_rad: [0, 2]"), 21, "direction_rad: [0]");
  text.replace(text.find("[0.25, mid_stance]"), 18, "[0.25]");
  folder_.Write("map.yaml", text);
  ASSERT_EQ(Sweep(one_, {"-j2"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(one_ / "cells"));
  const ProcessResult merge = Sidestep({"sweep", "merge", one_, "--evidence", "1"});
  EXPECT_EQ(merge.exit_code, 0);
  EXPECT_EQ(merge.err, "") << "the run again is what its row says";
  const std::string page = TextOf(one_ / "map.html");
  int shown = 0;
  for (const fs::directory_entry& cell : fs::directory_iterator(one_ / "cells")) {
    const std::string name = "cells/" + cell.path().filename().string();
    EXPECT_TRUE(fs::exists(cell.path() / "plots/com.svg"));
    EXPECT_TRUE(fs::exists(cell.path() / "video.mp4"));
    EXPECT_NE(page.find("src=\"" + name + "/video.mp4\""), std::string::npos);
    EXPECT_NE(page.find("src=\"" + name + "/plots/com.svg\""), std::string::npos);
    EXPECT_FALSE(fs::exists(cell.path() / "trajectory.csv"));
    ++shown;
  }
  EXPECT_EQ(shown, 2) << "a controller each";

  const auto made = fs::last_write_time(one_ / "cells");
  ASSERT_EQ(Sidestep({"sweep", "merge", one_}).exit_code, 0);
  EXPECT_EQ(TextOf(one_ / "map.html"), page) << "what is there is shown again";
  EXPECT_EQ(fs::last_write_time(one_ / "cells"), made);
}

TEST_F(SweepTest, InSevenShardsAndInOneGoItIsTheSameTable) {
  const ProcessResult one = Sweep(one_, {"-j2"});
  EXPECT_EQ(one.exit_code, 0) << one.err << "falls are results";
  EXPECT_NE(one.out.find("fixed: "), std::string::npos) << one.out;

  EXPECT_EQ(Sidestep({"sweep", "plan", sweep_, "-o", other_, "-q"}).exit_code, 0);
  const auto run_shard = [&](int shard, const char* jobs) {
    return Sidestep({"sweep", "run", other_, "--shard", std::to_string(shard) + "/7", jobs, "-q"});
  };
  for (const int shard : {0, 2, 3, 6}) {
    const ProcessResult run = run_shard(shard, "-j1");
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }
  const ProcessResult early = Sidestep({"sweep", "merge", other_});
  EXPECT_EQ(early.exit_code, 3);
  EXPECT_EQ(early.err, other_.string() +
                           ": error: 3 of 8 rays are not complete; shards of 7 to run: "
                           "--array=1,4,5\n");
  for (const int shard : {1, 4, 5}) EXPECT_EQ(run_shard(shard, "-j2").exit_code, 0);
  EXPECT_EQ(Sidestep({"sweep", "merge", other_}).exit_code, 0);
  EXPECT_GT(Tables(one_).size(), 10000U);
  EXPECT_EQ(Tables(other_), Tables(one_));

  const std::string row = TextOf(one_ / "cells.csv");
  EXPECT_NE(row.find(",RECOVERED,"), std::string::npos);
  EXPECT_NE(row.find(",LOST,"), std::string::npos) << "else the table tells little";
  EXPECT_EQ(row.find(",INVALID,"), std::string::npos);
}

TEST_F(SweepTest, EndsInAMapThatCanBeCompared) {
  ASSERT_EQ(Sweep(one_, {"-j2"}).exit_code, 0);
  const std::string page = TextOf(one_ / "map.html");
  EXPECT_NE(page.find("<th scope=\"row\">ours</th>"), std::string::npos);
  EXPECT_NE(page.find("ours less fixed"), std::string::npos);
  EXPECT_NE(page.find("The limit under the map: a linear pendulum"), std::string::npos);
  EXPECT_NE(page.find("sidestep run " + (folder_.path() / "hop.yaml").string() + " --set "),
            std::string::npos);
  EXPECT_NE(TextOf(one_ / "map.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(TextOf(one_ / "map.png").substr(1, 3), "PNG");

  const ProcessResult same = Sidestep({"compare", one_, one_, "--fail-on", "lost>0"});
  EXPECT_EQ(same.exit_code, 0) << same.err;
  EXPECT_NE(same.out.find("B against A: 0 cells won, 0 lost, "), std::string::npos) << same.out;
  EXPECT_EQ(Sidestep({"compare", one_, one_, "--fail-on", "undecided>0"}).exit_code, 1);
  const ProcessResult typo = Sidestep({"compare", one_, one_, "--fail-on", "mean>0"});
  EXPECT_EQ(typo.exit_code, 2);
  EXPECT_EQ(typo.err, "--fail-on mean>0: error: there is no mean to compare\n");
}

TEST_F(SweepTest, RunsAreComparedToTheFirstRowThatDiffers) {
  const auto run = [&](const fs::path& folder, const char* push) {
    return Sidestep({"run", folder_.path() / "hop.yaml", "-o", folder, "-q", "--no-video",
                     "--no-plots", "--set", push})
        .exit_code;
  };
  ASSERT_LE(run(one_, "pushes.0.force_N=[5, 0, 0]"), 1);
  ASSERT_LE(run(other_, "pushes.0.force_N=[6, 0, 0]"), 1);
  const ProcessResult result = Sidestep({"compare", one_, other_, "--fail-on", "drift_m>+1%"});
  EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
  EXPECT_NE(result.out.find("  pushes.0.force_N.0: 5 -> 6\n"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("part at row 500, 2 s, in push_force_W_x_N"), std::string::npos)
      << result.out;
  const ProcessResult same = Sidestep({"compare", one_, one_, "--fail-on", "drift_m>+1%"});
  EXPECT_EQ(same.exit_code, 0);
  EXPECT_NE(same.out.find("trajectories: the same"), std::string::npos) << same.out;
}

TEST_F(SweepTest, KilledAtAnyMomentItEndsInTheSameTable) {
  ASSERT_EQ(Sweep(one_).exit_code, 0);
  const fs::path rows = other_ / "rows-0-of-1.csv";
  for (const auto& [signal, after_lines] :
       {std::pair<int, int>{SIGKILL, 3}, {SIGTERM, 10}, {SIGKILL, 16}}) {
    Process process({SIDESTEP_BINARY, "sweep", sweep_, "-o", other_, "-q", "-j2"});
    WaitForLines(rows, after_lines);
    kill(process.pid(), signal);
    const int exit_code = process.Finish().exit_code;
    EXPECT_EQ(exit_code, signal == SIGTERM ? 3 : 128 + SIGKILL);
    EXPECT_FALSE(fs::exists(other_ / "cells.csv")) << "it was to be killed before its end";
    if (signal == SIGKILL) std::ofstream(rows, std::ios::app) << "3,half a ro";
  }
  const ProcessResult last = Sidestep({"sweep", sweep_, "-o", other_, "-j2"});
  EXPECT_EQ(last.exit_code, 0) << last.err;
  EXPECT_NE(last.err.find("dropped a half-written last row"), std::string::npos) << last.err;
  EXPECT_EQ(Tables(other_), Tables(one_));
}

TEST_F(SweepTest, ARunThatEndsItsProcessIsOneInvalidCell) {
  Process process({SIDESTEP_BINARY, "sweep", sweep_, "-o", other_, "-q", "-j1"});
  WaitForLines(other_ / "rows-0-of-1.csv", 3);  // the third of a ladder's runs goes on
  const std::string pid = std::to_string(process.pid());
  std::ifstream children("/proc/" + pid + "/task/" + pid + "/children");
  pid_t worker = 0;
  ASSERT_TRUE(children >> worker);
  kill(worker, SIGKILL);
  const ProcessResult result = process.Finish();
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_NE(result.out.find(", 1 INVALID"), std::string::npos) << result.out << result.err;
  EXPECT_NE(TextOf(other_ / "cells.csv").find(",INVALID,ERROR: the program ended in this run,"),
            std::string::npos);
}

TEST_F(SweepTest, OneLineTellsWhatIsWrong) {
  ASSERT_EQ(Sidestep({"sweep", "plan", sweep_, "-o", one_, "-q"}).exit_code, 0);
  const auto error = [&](const std::vector<std::string>& arguments) {
    const ProcessResult result = Sidestep(arguments);
    EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
    return folder_.Shorten(result.err);
  };
  EXPECT_EQ(error({"sweep", sweep_, "-o", one_, "--seeds", "2", "-q"}),
            "one: error: holds another sweep (see its sweep.yaml); take another folder\n");
  EXPECT_EQ(error({"sweep", "hopper_push", "-o", other_, "--vary", "world.friction=0.1:1:1000",
                   "--vary", "world.mass_scale=0.9:1.1:1000", "--seeds", "10"}),
            "error: this sweep may have 1e+07 runs; --yes if that is meant\n");
  EXPECT_EQ(error({"sweep", "hopper_push", "-o", other_, "--vary", "world.friction=0.1:1:1000",
                   "--vary", "world.mass_scale=0.9:1.1:10000"}),
            "vary: error: makes 1e+07 combinations with the controllers, more than 1e+06\n");
  EXPECT_EQ(error({"sweep", "hopper_push", "-o", other_, "--vary", "pushes.0.magnitude=1:2:3"}),
            "--vary pushes.0.magnitude=1:2:3: error: pushes.magnitude is not a known key; did you "
            "mean 'magnitude_N'?\n");
  EXPECT_FALSE(fs::exists(other_));
  EXPECT_EQ(error({"sweep", "run", one_, "--shard", "3/3"}),
            "--shard 3/3: error: must read I/N with 0 <= I < N, such as 0/8, or auto\n");
  std::string manifest = TextOf(one_ / "manifest.csv");
  const std::string mine = manifest.substr(0, manifest.find('\n'));
  folder_.Write("one/manifest.csv",
                manifest.replace(0, mine.size(), "# sidestep sweep manifest 1, program 0"));
  const std::string other_program = error({"sweep", "run", one_, "-q"});
  EXPECT_TRUE(other_program.starts_with(
      "one/manifest.csv: error: was planned by another build of the program"))
      << other_program;
  EXPECT_EQ(error({"sweep", "merge", folder_.path()}),
            folder_.path().string() + ": error: holds no sweep (no manifest.csv)\n");
}

TEST_F(SweepTest, AScenarioThatChangedSinceThePlanIsRefused) {
  ASSERT_EQ(Sidestep({"sweep", "plan", sweep_, "-o", one_, "-q"}).exit_code, 0);
  folder_.Write("hop.yaml", Edit(kHop, "touch_noise_N: 0.05", "touch_noise_N: 0.06"));
  const ProcessResult run = Sidestep({"sweep", "run", one_, "-q"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("was planned from another scenario or robot"), std::string::npos);
}

TEST_F(SweepTest, KeepsTheRunsThatItIsAskedTo) {
  const ProcessResult run =
      Sidestep({"sweep", folder_.path() / "hop.yaml", "-o", one_, "-q", "--keep", "failures",
                "--set", "pushes.0.direction_rad=0", "--vary", "pushes.0.magnitude_N=[1, 60]"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_FALSE(fs::exists(one_ / "runs/ray_0"));
  EXPECT_TRUE(fs::exists(one_ / "runs/ray_1/states.bin"));
}

// A hop goes lower than this bound allows: by the verdict it has fallen before it is pushed.
TEST_F(SweepTest, ARobotThatIsNotSettledMakesItsCellsInvalid) {
  const ProcessResult run = Sidestep(
      {"sweep", folder_.path() / "hop.yaml", "-o", one_, "-q", "--set", "pushes.0.direction_rad=0",
       "--set", "verdict.min_base_height_ratio=0.98", "--vary", "pushes.0.magnitude_N=[1, 60]"});
  EXPECT_EQ(run.exit_code, 3) << run.out;
  EXPECT_NE(run.out.find("0 lost, 2 INVALID"), std::string::npos) << run.out;
  EXPECT_NE(TextOf(one_ / "cells.csv").find(",INVALID,UNSETTLED: "), std::string::npos);
}

std::string BitsOf(const Metrics& metrics) {
  std::string text;
  for (const auto& [name, value] : metrics) {
    text += name;
    if (const double* number = std::get_if<double>(&value)) {
      text.append(reinterpret_cast<const char*>(number), sizeof *number);
    } else {
      text += std::get<bool>(value) ? "1" : "0";
    }
  }
  return text;
}

TEST_F(SweepTest, ACellThatSharesItsBeginningIsItsStraightRunBitForBit) {
  CellRunner sharing;
  std::string last;
  for (const auto& [force_N, start_s] : {std::pair<const char*, const char*>{"4", "2"},
                                         {"9", "2"},
                                         {"30", "2"},
                                         {"6", "2.15"},
                                         {"6", "1.9"}}) {
    const Scenario scenario =
        ReadScenario(folder_.path() / "hop.yaml",
                     {std::string("pushes.0.magnitude_N=") + force_N, "pushes.0.direction_rad=1",
                      std::string("pushes.0.start_s=") + start_s});
    Episode straight = StartEpisode(scenario);
    RunEpisode(&straight, {});
    const std::string bits = BitsOf(sharing.Run(scenario).metrics);
    EXPECT_TRUE(bits == BitsOf(straight.judge.Conclude().metrics))
        << force_N << " N at " << start_s << " s";
    EXPECT_FALSE(bits == last) << "the pushes do nothing";
    last = bits;
  }
}

}  // namespace
}  // namespace sidestep
