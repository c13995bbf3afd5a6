// SPDX-License-Identifier: BSD-3-Clause
// What a recorder keeps of a run's ticks, by its detail.
#include "sim/record/log_detail.h"

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "models/support/config_error.h"
#include "sim/record/recorder.h"
#include "sim/record/run_files.h"
#include "sim/record/run_reader.h"
#include "sim/record/run_summary.h"
#include "tests/unit/record/record_test_support.h"

namespace sidestep::log_detail_test {
namespace {

namespace fs = std::filesystem;

constexpr double kThird = 1.0 / 3.0;

class LogDetailTest : public RecordTest {
 protected:
  std::unique_ptr<Recorder> Start(const std::string& name, LogDetail detail) {
    return std::make_unique<Recorder>(scenario_, world_, folder_ / name, std::vector<std::string>{},
                                      detail);
  }
  void Add(Recorder* recorder, int first, int end) {
    for (int i = first; i < end; ++i) {
      world_.written.p_WC = {kThird * i, -1e-9, 0.5};
      recorder->Add(2 * i, world_.truth(), BusyControl(2 * i), TimesOf(kThird, 1.0, 0.25));
    }
  }
  fs::path Record(const std::string& name, LogDetail detail, int ticks) {
    const auto recorder = Start(name, detail);
    Add(recorder.get(), 0, ticks);
    recorder->Finish({}, 1.0, {1.0, 1.0});
    return folder_ / name;
  }

  const Scenario scenario_ = TwoFeetScenario();
  ScriptedWorld world_{scenario_, {{"hip"}}};
};

TEST_F(LogDetailTest, NormalHasTheFirstEverySecondAndTheLastTick) {
  for (const int ticks : {1, 2, 3, 6, 7}) {
    const std::string at = std::to_string(ticks);
    const CsvTable full = ReadTrajectory(Record("full" + at, LogDetail::kFull, ticks));
    const CsvTable normal = ReadTrajectory(Record("normal" + at, LogDetail::kNormal, ticks));
    EXPECT_EQ(full.header(), normal.header());
    std::vector<std::string> expected, seen;
    for (int i = 0; i < ticks; ++i) {
      if (i % 2 == 0 || i + 1 == ticks) {
        expected.push_back(full.Text(static_cast<std::size_t>(i), "time_s"));
      }
    }
    for (std::size_t row = 0; row < normal.num_rows(); ++row) {
      seen.push_back(normal.Text(row, "time_s"));
    }
    EXPECT_EQ(seen, expected) << ticks;
    EXPECT_EQ(ReadWholeFile(folder_ / ("full" + at) / "states.bin"),
              ReadWholeFile(folder_ / ("normal" + at) / "states.bin"));
  }
}

TEST_F(LogDetailTest, NormalRoundsEachColumnByItsUnit) {
  const CsvTable table = ReadTrajectory(Record("run", LogDetail::kNormal, 2));
  ASSERT_EQ(table.num_rows(), 2U);
  EXPECT_EQ(table.Text(1, "truth_p_WC_x_m"), "0.3333333");
  EXPECT_EQ(table.Text(1, "truth_p_WC_y_m"), "0") << "no -0";
  EXPECT_EQ(table.Text(1, "wall_control_ms"), "0.333");
  EXPECT_EQ(table.Text(1, "mpc_age_s"), "0.004");
  EXPECT_EQ(table.Text(1, "time_s"),
            ReadTrajectory(Record("full", LogDetail::kFull, 2)).Text(1, "time_s"));
}

TEST_F(LogDetailTest, AForkGoesOnWithTheRowThatItsOriginalHeldBack) {
  for (const int fork_tick : {3, 4}) {
    const std::string at = std::to_string(fork_tick);
    const auto original = Start("original" + at, LogDetail::kNormal);
    Add(original.get(), 0, fork_tick);
    const auto fork = original->ForkTo(folder_ / ("fork" + at));
    fork->Finish({}, 1.0, {1.0, 1.0});
    Add(original.get(), fork_tick, 9);
    original->Finish({}, 1.0, {1.0, 1.0});
    for (const auto& [name, ticks] : {std::pair{"fork", fork_tick}, std::pair{"original", 9}}) {
      EXPECT_EQ(ReadWholeFile(folder_ / (name + at) / "trajectory.csv"),
                ReadWholeFile(Record("straight", LogDetail::kNormal, ticks) / "trajectory.csv"))
          << name << at;
    }
  }
}

TEST_F(LogDetailTest, NoneLeavesNoTicksAndSaysHowToGetThem) {
  Record("run", LogDetail::kFull, 3);  // an older one, in the same folder
  const fs::path run = Record("run", LogDetail::kNone, 3);
  for (const char* name : {"trajectory.csv", "states.bin"}) EXPECT_FALSE(fs::exists(run / name));
  for (const char* name : {"mpc.csv", "footsteps.csv", "scenario.yaml"}) {
    EXPECT_TRUE(fs::exists(run / name)) << name;
  }
  EXPECT_EQ(ReadSummary(run).log, LogDetail::kNone);
  EXPECT_EQ(CsvTable::Read(run / "mpc.csv").num_rows(), 3U);
  EXPECT_TRUE(RecordsNoTicks(run));
  try {
    ReadStates(run);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.what(), (run / "states.bin").string() +
                                ": error: is not there: the run was recorded with --log none; run "
                                "it again with --log normal");
  }
  EXPECT_THROW(ReadTrajectory(run), ConfigError);
}

TEST_F(LogDetailTest, AFileThatIsMissingForAnotherReasonIsJustMissing) {
  const fs::path run = Record("run", LogDetail::kNormal, 3);
  EXPECT_FALSE(RecordsNoTicks(run));
  EXPECT_NO_THROW(RequireTicksFile(run, "nothing.csv"));
  std::ofstream(run / "summary.json") << "{";
  EXPECT_FALSE(RecordsNoTicks(run)) << "who needs the summary tells that it is broken";
}

TEST_F(LogDetailTest, ASummaryFromBeforeTheOptionIsOfAFullLog) {
  RunSummary summary;
  summary.log = LogDetail::kNone;
  std::string text = SummaryJson(summary);
  const std::size_t at = text.find("  \"log\": \"none\",\n");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(ParseSummary(text, "summary.json").log, LogDetail::kNone);
  EXPECT_EQ(ParseSummary(text.erase(at, 17), "summary.json").log, LogDetail::kFull);
}

}  // namespace
}  // namespace sidestep::log_detail_test
