// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// csv_line: a row of a table of texts and numbers, as RFC 4180 quotes it.

#include <string>
#include <string_view>
#include <vector>

namespace sidestep {

/// The cells as one line without its end. Line ends within a cell become spaces.
std::string CsvLine(const std::vector<std::string>& cells);

/// The cells of a line without its end.
std::vector<std::string> SplitCsvLine(std::string_view line);

}  // namespace sidestep
