// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/csv_line.h"

#include <gtest/gtest.h>

namespace sidestep::csv_line_test {
namespace {

TEST(CsvLineTest, AnyTextComesBack) {
  const std::vector<std::string> cells{"", "a", "1, 2", "say \"no\"", "\"", ",", "last"};
  EXPECT_EQ(SplitCsvLine(CsvLine(cells)), cells);
  EXPECT_EQ(CsvLine({"1, 2", "\""}), "\"1, 2\",\"\"\"\"");
}

TEST(CsvLineTest, ACellHasNoLineEnds) { EXPECT_EQ(CsvLine({"two\nlines", "b"}), "two lines,b"); }

}  // namespace
}  // namespace sidestep::csv_line_test
