// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// row_file: the rows of one process's share of a sweep, on disk before the next run begins.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sim/sweep/cell_row.h"

namespace sidestep {

/// What a file of rows holds.
struct RowsOnDisk {
  std::vector<CellRow> rows;
  std::size_t whole_bytes{0};  ///< Up to the end of the last whole row.
  bool has_half_row{false};    ///< A last line without its end: the process was killed in it.
};

/// Reads a file of rows; one that is not there has none. @throws ConfigError `file:line: error:
/// ...` if a whole line is no row of `spec`, or the header is another sweep's.
RowsOnDisk ReadRows(const SweepSpec& spec, const std::filesystem::path& file);

/// A file of rows that grows. Nobody else may write to it meanwhile: it is locked.
class RowFile {
 public:
  /// Opens or creates the file, locks it, and takes off a half-written last row, with a note.
  /// @throws ConfigError if another process has it, and as ReadRows.
  RowFile(const SweepSpec& spec, const std::filesystem::path& file,
          const std::function<void(const std::string&)>& note);
  ~RowFile();
  RowFile(const RowFile&) = delete;
  RowFile& operator=(const RowFile&) = delete;

  /// What was there when it was opened.
  const std::vector<CellRow>& rows() const { return rows_; }

  /// Appends a line and waits until it is on disk. @throws ConfigError if that fails.
  void Append(const std::string& line);

  /// For a process forked off: gives up the file there, so that the lock ends with its owner.
  void Forget();

 private:
  std::filesystem::path file_;
  int descriptor_{-1};
  std::vector<CellRow> rows_;
};

}  // namespace sidestep
