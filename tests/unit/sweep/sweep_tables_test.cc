// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/sweep_tables.h"

#include <gtest/gtest.h>

#include "sim/sweep/csv_line.h"
#include "tests/unit/sweep/sweep_fixture.h"

namespace sidestep::sweep_tables_test {
namespace {

class SweepTablesTest : public testing::Test {
 protected:
  std::vector<std::vector<std::string>> Table(const std::string& csv) const {
    std::istringstream in(csv);
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(in, line);) rows.push_back(SplitCsvLine(line));
    for (const auto& row : rows) EXPECT_EQ(row.size(), rows[0].size());
    return rows;
  }

  const SweepPlan plan_ = SmallPlan();
  const CellRows rows_ = RowsBelow(plan_, 30.0);
  const std::vector<RayResult> results_ = ResultsOf(plan_, rows_);
};

TEST_F(SweepTablesTest, ARayTellsItsBracketInItsOwnUnitAndAsImpulse) {
  const auto table = Table(RaysCsv(plan_, results_));
  ASSERT_EQ(table.size(), 5U);
  // ray, id, controller, direction, survived, lost_at, survived_Nspkg, lost_at_Nspkg, ladder_share
  EXPECT_EQ((std::vector<std::string>(table[1].begin(), table[1].begin() + 6)),
            (std::vector<std::string>{"0", "id0", "a", "0", "28.75", "30"}));
  EXPECT_EQ(table[1][6], "2.875");
  EXPECT_EQ(table[1][8].substr(0, 6), "0.6666");
  EXPECT_EQ(table[1].back(), "FALL at 3.000 s: low, very");
}

TEST_F(SweepTablesTest, AStrengthTellsItsRate) {
  const auto table = Table(StrengthsCsv(plan_, results_));
  // ray, id, controller, direction, strength, stage, impulse, runs, recovered, lost, invalid, rate
  EXPECT_EQ((std::vector<std::string>(table[1].begin() + 4, table[1].begin() + 12)),
            (std::vector<std::string>{"10", "ladder", "1", "2", "2", "0", "0", "1"}));
  EXPECT_EQ(table.size(), 1 + 4 * results_[0].search.tested.size());
}

TEST_F(SweepTablesTest, CellsAreInTheOrderOfTheSearch) {
  const auto table = Table(CellsCsv(plan_, results_));
  ASSERT_EQ(table.size(), 1 + rows_.size());
  EXPECT_EQ(table[1][4], "10");
  EXPECT_EQ(table[3][4], "20");
  EXPECT_EQ(table[5][4], "40");
  EXPECT_EQ(table[7][4], "30") << "the first halving";
}

TEST_F(SweepTablesTest, TheSummaryTellsEachControllersLimits) {
  const std::string text = SweepSummary(plan_, results_);
  EXPECT_NE(text.find("  b  pushes.0.direction_rad=1.5  [28.75, 30)  2.875 N s/kg  ladder 66.67 %"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("limit min 2.875, mean 2.875, max 2.875 N s/kg; worst ray 0"),
            std::string::npos);
  EXPECT_NE(text.find(": 2400 runs a core hour"), std::string::npos) << "1.5 s each";
}

}  // namespace
}  // namespace sidestep::sweep_tables_test
