// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/row_file.h"

#include <gtest/gtest.h>

#include "tests/support/run_files.h"
#include "tests/unit/sweep/sweep_fixture.h"

namespace sidestep::row_file_test {
namespace {

class RowFileTest : public testing::Test {
 protected:
  std::string Line(std::size_t ray) const {
    return RowOf(plan_, {ray, "10", "1", SearchStage::kLadder}, CellOutcome::kRecovered).line;
  }
  const std::function<void(const std::string&)> note_ = [this](const std::string& line) {
    notes_ += folder_.Shorten(line) + "\n";
  };

  const SweepPlan plan_ = SmallPlan();
  const TempFolder folder_;
  const std::filesystem::path path_ = folder_.path() / "rows.csv";
  std::string notes_;
};

TEST_F(RowFileTest, GoesOnWhereItStopped) {
  RowFile(plan_.spec, path_, note_).Append(Line(0));
  {
    RowFile file(plan_.spec, path_, note_);
    ASSERT_EQ(file.rows().size(), 1U);
    file.Append(Line(1));
  }
  EXPECT_EQ(TextOf(path_), RowHeader(plan_.spec) + "\n" + Line(0) + "\n" + Line(1) + "\n");
  EXPECT_EQ(notes_, "");
}

TEST_F(RowFileTest, AHalfRowIsDroppedAndTold) {
  RowFile(plan_.spec, path_, note_).Append(Line(0));
  const std::string whole = TextOf(path_);
  // Killed anywhere in the row, its line end and the header included.
  for (const std::size_t kept : {std::size_t{1}, Line(1).size() / 2, Line(1).size()}) {
    folder_.Write("rows.csv", whole + Line(1).substr(0, kept));
    EXPECT_EQ(RowFile(plan_.spec, path_, note_).rows().size(), 1U);
    EXPECT_EQ(TextOf(path_), whole);
  }
  folder_.Write("rows.csv", "ray,id");
  EXPECT_EQ(RowFile(plan_.spec, path_, note_).rows().size(), 0U);
  const std::string note =
      "rows.csv: note: dropped a half-written last row; its run is done again\n";
  EXPECT_EQ(notes_, note + note + note + note);
}

// Such as a device, which may have no end.
TEST_F(RowFileTest, WhatIsNoFileIsNotRead) {
  std::filesystem::create_symlink("/dev/full", path_);
  EXPECT_EQ(folder_.ErrorOf([&] { ReadRows(plan_.spec, path_); }),
            "rows.csv: error: is no file of rows");
  EXPECT_EQ(folder_.ErrorOf([&] { RowFile(plan_.spec, path_, note_); }),
            "rows.csv: error: is no file of rows");
}

TEST_F(RowFileTest, Errors) {
  RowFile(plan_.spec, path_, note_).Append(Line(0));
  const auto error = [&] { return folder_.ErrorOf([&] { RowFile(plan_.spec, path_, note_); }); };
  {
    const RowFile other(plan_.spec, path_, note_);
    EXPECT_EQ(error(),
              "rows.csv: error: another sweep is writing here; wait for it or take another folder");
  }
  EXPECT_EQ(error(), "no error");
  folder_.Write("rows.csv", RowHeader(plan_.spec) + "\nbroken\n" + Line(0) + "\n");
  EXPECT_TRUE(error().starts_with("rows.csv:2: error: is no row of this sweep"));
  folder_.Write("rows.csv", "ray,other\n");
  EXPECT_EQ(error(), "rows.csv:1: error: has the columns of another sweep or program");
}

}  // namespace
}  // namespace sidestep::row_file_test
