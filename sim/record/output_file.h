// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// output_file: the ways in which a run's files come to disk.

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace sidestep {

/// Appends the shortest decimal that reads back as the same double ("nan", "inf" as such).
void AppendNumber(std::string& text, double value);

/// A file that grows by whole rows: what is on disk ends with a complete one.
/// Every member but the destructor throws ConfigError naming the file if it can't be written.
class OutputFile {
 public:
  /// Creates or empties the file.
  explicit OutputFile(const std::filesystem::path& file);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Adds one row as it is, line end included; it may stay in memory for a while.
  void Append(std::string_view row);

  /// Puts everything on disk. Nothing may be appended afterwards.
  void Close();

 private:
  void Flush();

  std::filesystem::path file_;
  std::ofstream out_;
  std::string buffer_;
};

/// Writes a whole file under a temporary name, then renames it: readers see all of it or nothing.
/// Throws ConfigError if it can't be written.
void WriteWholeFile(const std::filesystem::path& file, std::string_view text);

}  // namespace sidestep
