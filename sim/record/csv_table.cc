// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "models/support/config_error.h"
#include "models/support/parse_number.h"
#include "models/support/require.h"
#include "sim/record/run_reader.h"

namespace sidestep {

CsvTable CsvTable::Read(const std::filesystem::path& file) {
  return Parse(ReadWholeFile(file), file);
}

CsvTable CsvTable::Parse(std::string whole, const std::filesystem::path& file) {
  CsvTable table;
  table.file_ = file;
  table.text_ = std::move(whole);
  const std::string& text = table.text_;

  int line = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    ++line;
    const std::size_t newline = text.find('\n', begin);
    const bool is_whole = newline != std::string::npos;
    std::size_t end = is_whole ? newline : text.size();
    const std::size_t next = is_whole ? newline + 1 : text.size();
    if (end > begin && text[end - 1] == '\r') --end;

    const std::size_t first_cell = table.starts_.size();
    for (std::size_t cell = begin; cell <= end;) {
      const std::size_t comma = std::min(text.find(',', cell), end);
      table.starts_.push_back(cell);
      table.lengths_.push_back(comma - cell);
      cell = comma + 1;
    }
    const std::size_t width = table.starts_.size() - first_cell;
    if (line == 1) {
      for (std::size_t i = 0; i < width; ++i) {
        table.header_.emplace_back(text, table.starts_[i], table.lengths_[i]);
      }
      table.starts_.clear();
      table.lengths_.clear();
    } else if (is_whole && width == table.header_.size()) {
      ++table.num_rows_;
    } else if (next == text.size()) {
      table.starts_.resize(first_cell);  // cut short while it was written
      table.lengths_.resize(first_cell);
    } else {
      throw ConfigError(file.string(), line, 1,
                        "expected " + std::to_string(table.header_.size()) + " cells, found " +
                            std::to_string(width));
    }
    begin = next;
  }
  if (table.header_.empty()) throw ConfigError(file.string() + ": error: the file is empty");
  return table;
}

bool CsvTable::has(std::string_view column) const {
  return std::find(header_.begin(), header_.end(), column) != header_.end();
}

std::size_t CsvTable::IndexOf(std::string_view column) const {
  const auto found = std::find(header_.begin(), header_.end(), column);
  if (found == header_.end()) {
    throw ConfigError(file_.string() + ": error: has no column '" + std::string(column) + "'");
  }
  return static_cast<std::size_t>(found - header_.begin());
}

std::string CsvTable::Text(std::size_t row, std::string_view column) const {
  SIDESTEP_REQUIRE(row < num_rows_, row);
  return std::string(Cell(row, IndexOf(column)));
}

std::vector<double> CsvTable::Numbers(std::string_view column) const {
  const std::size_t index = IndexOf(column);
  std::vector<double> values(num_rows_);
  for (std::size_t row = 0; row < num_rows_; ++row) {
    values[row] =
        ParseAs<double>(Cell(row, index)).value_or(std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

}  // namespace sidestep
