// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/merge_rows.h"

#include <gtest/gtest.h>

#include "tests/unit/sweep/sweep_fixture.h"

namespace sidestep::merge_rows_test {
namespace {

class MergeRowsTest : public testing::Test {
 protected:
  // Writes rows of some shards of `shards`; a row of every ray that the shard has.
  void WriteShard(int shard, int shards, const CellRows& rows, const std::string& more = "") const {
    std::string text = RowHeader(plan_.spec) + "\n";
    for (const auto& [name, row] : rows) {
      if (static_cast<int>(row.cell.ray) % shards == shard) text += row.line + "\n";
    }
    folder_.Write("rows-" + std::to_string(shard) + "-of-" + std::to_string(shards) + ".csv",
                  text + more);
  }
  MergedRows Merged() {
    return ReadAllRows(plan_, folder_.path(), [&](const std::string& line) { notes_ += line; });
  }

  const SweepPlan plan_ = SmallPlan();
  const TempFolder folder_;
  std::string notes_;
};

TEST_F(MergeRowsTest, ShardsTogetherAreTheWhole) {
  const CellRows rows = RowsBelow(plan_, 30.0);
  for (const int shard : {0, 1, 2}) WriteShard(shard, 3, rows);
  folder_.Write("rows-of-nobody.csv", "not looked at");
  const MergedRows merged = Merged();
  EXPECT_EQ(merged.rows.size(), rows.size());
  EXPECT_EQ(merged.shards, 3);
  const std::vector<RayResult> results = ResultsOf(plan_, merged.rows);
  EXPECT_TRUE(MissingShards(results, 3).empty());
  EXPECT_EQ(BracketOf(results[3].search.tested).survived, 28.75);
}

TEST_F(MergeRowsTest, TellsWhichShardsAreMissing) {
  WriteShard(1, 3, RowsBelow(plan_, 30.0));
  const std::vector<RayResult> results = ResultsOf(plan_, Merged().rows);
  EXPECT_EQ(MissingShards(results, 3), (std::vector<std::size_t>{0, 2}));
}

TEST_F(MergeRowsTest, TwoRowsOfACellMustBeTheSameRun) {
  WriteShard(0, 1, RowsBelow(plan_, 30.0, 1.0));
  WriteShard(0, 2, RowsBelow(plan_, 30.0, 2.0));
  EXPECT_EQ(Merged().rows.size(), RowsBelow(plan_, 30.0).size()) << "only the clock differs";
  WriteShard(0, 2, RowsBelow(plan_, 15.0));
  EXPECT_EQ(folder_.ErrorOf([&] { Merged(); }),
            "rows-0-of-2.csv: error: ray 0 strength '20' seed '1' is there twice, and the rows "
            "differ: runs are not repeatable here");
}

TEST_F(MergeRowsTest, AHalfRowIsPassedOver) {
  WriteShard(0, 1, RowsBelow(plan_, 30.0), "2,id2,b");
  EXPECT_EQ(Merged().rows.size(), RowsBelow(plan_, 30.0).size());
  EXPECT_NE(notes_.find("passed over a half-written last row"), std::string::npos);
}

TEST_F(MergeRowsTest, RowsOfAnotherProgramAreRefused) {
  SweepPlan other = plan_;
  other.rays[1].id = "another";
  WriteShard(0, 1, RowsBelow(other, 30.0));
  EXPECT_EQ(folder_.ErrorOf([&] { Merged(); }),
            "rows-0-of-1.csv: error: a row of ray 1 is of another sweep or program");
}

TEST(ArrayTextTest, IsWhatSlurmReads) {
  EXPECT_EQ(ArrayText({3, 7, 12, 13, 14, 15}), "3,7,12-15");
  EXPECT_EQ(ArrayText({0, 1}), "0,1");
  EXPECT_EQ(ArrayText({}), "");
}

}  // namespace
}  // namespace sidestep::merge_rows_test
