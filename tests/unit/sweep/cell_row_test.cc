// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/cell_row.h"

#include <gtest/gtest.h>

#include "sim/sweep/csv_line.h"
#include "tests/unit/sweep/sweep_fixture.h"

namespace sidestep::cell_row_test {
namespace {

const CellKey kCell{2, "20", "1", SearchStage::kBisect};

TEST(CellRowTest, ReadsBackAsItWasWritten) {
  const SweepPlan plan = SmallPlan();
  const CellRow row = RowOf(plan, kCell, CellOutcome::kLost);
  const CellRow read = ReadRow(plan.spec, row.line, "here");
  EXPECT_EQ(NameOf(read.cell), NameOf(kCell));
  EXPECT_EQ(read.cell.stage, SearchStage::kBisect);
  EXPECT_EQ(read.id, "id2");
  EXPECT_EQ(read.outcome, CellOutcome::kLost);
  EXPECT_EQ(read.reasons, "FALL at 3.000 s: low, very");
  EXPECT_DOUBLE_EQ(read.impulse_Nspkg, 2.0);
  EXPECT_DOUBLE_EQ(read.cpu_s, 1.5);
}

TEST(CellRowTest, HasACellForEveryColumn) {
  const SweepPlan plan = SmallPlan();
  EXPECT_EQ(SplitCsvLine(RowOf(plan, kCell, CellOutcome::kLost).line).size(),
            SplitCsvLine(RowHeader(plan.spec)).size());
}

TEST(CellRowTest, OnlyTheMachinesColumnsMayDiffer) {
  const SweepPlan plan = SmallPlan();
  const CellRow row = RowOf(plan, kCell, CellOutcome::kLost, 1.0);
  EXPECT_EQ(row.Repeatable(), RowOf(plan, kCell, CellOutcome::kLost, 2.0).Repeatable());
  EXPECT_NE(row.line, RowOf(plan, kCell, CellOutcome::kLost, 2.0).line);
  EXPECT_NE(row.Repeatable(), RowOf(plan, kCell, CellOutcome::kInvalid, 1.0).Repeatable());
}

TEST(CellRowTest, Errors) {
  const TempFolder folder;
  const SweepPlan plan = SmallPlan();
  const auto error = [&](const std::string& line) {
    return folder.ErrorOf([&] { ReadRow(plan.spec, line, "rows.csv:7"); });
  };
  const std::string line = RowOf(plan, kCell, CellOutcome::kLost).line;
  EXPECT_TRUE(error("a,b").starts_with(
      "rows.csv:7: error: is no row of this sweep: it has 2 columns, not "));
  EXPECT_EQ(error(Edit(line, ",LOST,", ",GONE,")),
            "rows.csv:7: error: is no row of this sweep: a column is not what it should be");
}

}  // namespace
}  // namespace sidestep::cell_row_test
