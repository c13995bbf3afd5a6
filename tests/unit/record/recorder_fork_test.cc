// SPDX-License-Identifier: BSD-3-Clause
// A recorder that is copied in mid-run: both folders end as those of runs that were never forked.
#include <gtest/gtest.h>

#include <fstream>

#include "models/support/config_error.h"
#include "models/support/require.h"
#include "sim/record/output_file.h"
#include "sim/record/recorder.h"
#include "sim/record/run_reader.h"
#include "sim/record/run_summary.h"
#include "tests/unit/record/record_test_support.h"

namespace sidestep::recorder_fork_test {
namespace {

namespace fs = std::filesystem;

const TickTimes kTimes = TimesOf(1.5, 1.0, 0.25);
constexpr Tick kLong = 2000;  // 1,000 rows exceed every buffer
const std::vector<std::string> kFiles{"scenario.yaml", "trajectory.csv", "states.bin",
                                      "mpc.csv",       "footsteps.csv",  "summary.json"};

class RecorderForkTest : public RecordTest {
 protected:
  /// Adds the rows from `begin` up to `end`; `lean` makes two runs differ.
  void AddRows(Recorder* recorder, Tick begin, Tick end, double lean = 0.0) {
    for (Tick tick = begin; tick < end; tick += 2) {
      world_.written.p_WC = {static_cast<double>(tick) / 3.0, lean, 0.5};
      recorder->Add(tick, world_.truth(), BusyControl(tick), kTimes);
    }
  }
  void Finish(Recorder* recorder, double lean = 0.0) {
    RunOutcome outcome;
    outcome.metrics = {{"energy_J", 1.0 + lean}};
    recorder->Finish(outcome, 4.0, {2.0, 1.0});
  }
  std::unique_ptr<Recorder> Start(const fs::path& run_dir) {
    return std::make_unique<Recorder>(scenario_, world_, run_dir,
                                      std::vector<std::string>{"sidestep", "run"});
  }
  /// The folder of a run that was never forked.
  fs::path Straight(const std::string& name, Tick fork_tick, Tick end, double lean) {
    const auto recorder = Start(folder_ / name);
    AddRows(recorder.get(), 0, fork_tick);
    AddRows(recorder.get(), fork_tick, end, lean);
    Finish(recorder.get(), lean);
    return folder_ / name;
  }
  void ExpectSameFiles(const fs::path& one, const fs::path& other) {
    for (const std::string& file : kFiles) {
      EXPECT_EQ(ReadWholeFile(one / file), ReadWholeFile(other / file)) << other << " " << file;
    }
  }

  const Scenario scenario_ = TwoFeetScenario();
  ScriptedWorld world_{scenario_};
};

TEST_F(RecorderForkTest, BothFoldersAreThoseOfStraightRuns) {
  // At once, within the first buffer, and after many: rows on disk and rows in memory.
  for (const Tick fork_tick : {Tick{0}, Tick{20}, kLong}) {
    const std::string at = "_" + std::to_string(fork_tick);
    const auto recorder = Start(folder_ / ("original" + at));
    AddRows(recorder.get(), 0, fork_tick);
    const auto fork = recorder->ForkTo(folder_ / ("fork" + at));
    AddRows(recorder.get(), fork_tick, fork_tick + kLong, 0.1);
    AddRows(fork.get(), fork_tick, fork_tick + 100, 0.2);
    Finish(fork.get(), 0.2);
    Finish(recorder.get(), 0.1);
    ExpectSameFiles(Straight("a" + at, fork_tick, fork_tick + kLong, 0.1),
                    folder_ / ("original" + at));
    ExpectSameFiles(Straight("b" + at, fork_tick, fork_tick + 100, 0.2), folder_ / ("fork" + at));
    EXPECT_NE(ReadWholeFile(folder_ / ("a" + at) / "trajectory.csv"),
              ReadWholeFile(folder_ / ("b" + at) / "trajectory.csv"))
        << "negative control: the two runs differ";
  }
}

TEST_F(RecorderForkTest, AForkOfAForkHoldsTheRowsOfBoth) {
  const auto first = Start(folder_ / "first");
  AddRows(first.get(), 0, 20);
  const auto second = first->ForkTo(folder_ / "second");
  AddRows(second.get(), 20, 40);
  const auto third = second->ForkTo(folder_ / "third");
  AddRows(third.get(), 40, 60);
  Finish(third.get());
  ExpectSameFiles(Straight("straight", 20, 60, 0.0), folder_ / "third");
}

TEST_F(RecorderForkTest, AForkThatIsAbandonedKeepsEveryRowAndIsInvalid) {
  const auto recorder = Start(folder_ / "original");
  AddRows(recorder.get(), 0, 20);
  recorder->ForkTo(folder_ / "fork").reset();
  EXPECT_EQ(CsvTable::Read(folder_ / "fork" / "trajectory.csv").num_rows(), 10U);
  EXPECT_EQ(ReadStates(folder_ / "fork").rows.size(), 10U);
  EXPECT_EQ(ReadSummary(folder_ / "fork").verdict, VerdictClass::kInvalid);
}

TEST_F(RecorderForkTest, AnOlderRunInTheForksFolderIsOverwritten) {
  Straight("fork", 20, kLong, 0.3);
  const auto recorder = Start(folder_ / "original");
  AddRows(recorder.get(), 0, 20);
  const auto fork = recorder->ForkTo(folder_ / "fork");
  EXPECT_EQ(ReadSummary(folder_ / "fork").verdict, VerdictClass::kInvalid);
  AddRows(fork.get(), 20, 40);
  Finish(fork.get());
  ExpectSameFiles(Straight("straight", 20, 40, 0.0), folder_ / "fork");
}

TEST_F(RecorderForkTest, TheOwnFolderIsRefusedHoweverItIsSpelled) {
  const auto recorder = Start(folder_ / "run");
  AddRows(recorder.get(), 0, 20);
  fs::create_directory_symlink(folder_ / "run", folder_ / "link");
  for (const fs::path& own : {folder_ / "run", folder_ / "run" / "", folder_ / "." / "run",
                              folder_ / "link", folder_ / "link" / ".." / "run"}) {
    EXPECT_THROW(recorder->ForkTo(own), ConfigError) << own;
  }
  Finish(recorder.get());
  EXPECT_EQ(CsvTable::Read(folder_ / "run" / "trajectory.csv").num_rows(), 10U) << "nothing lost";
}

TEST_F(RecorderForkTest, ARunWhoseFilesWereTamperedWithIsNotForked) {
  const auto recorder = Start(folder_ / "run");
  AddRows(recorder.get(), 0, kLong);
  fs::resize_file(folder_ / "run" / "trajectory.csv", 100);
  EXPECT_THROW(recorder->ForkTo(folder_ / "fork"), ConfigError);
  fs::remove(folder_ / "run" / "trajectory.csv");
  EXPECT_THROW(recorder->ForkTo(folder_ / "fork"), ConfigError);
}

TEST_F(RecorderForkTest, AFinishedRunIsNotForked) {
  const auto recorder = Start(folder_ / "run");
  Finish(recorder.get());
  EXPECT_THROW(recorder->ForkTo(folder_ / "fork"), ContractViolation);
}

}  // namespace
}  // namespace sidestep::recorder_fork_test
