// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// output_file: the ways in which a run's files come to disk.

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace sidestep {

/// Appends the shortest decimal that reads back as the same double ("nan", "inf" as such).
void AppendNumber(std::string& text, double value);

/// Throws ConfigError: `file: error: can't be written`, with what errno says.
[[noreturn]] void FailToWrite(const std::filesystem::path& file);

/// A file that grows by whole rows: what is on disk ends with a complete one, unless the disk is
/// full. Every member but the destructor throws ConfigError naming file and reason if it can't be
/// written.
class OutputFile {
 public:
  /// Creates or empties the file.
  explicit OutputFile(const std::filesystem::path& file);

  /// Creates or overwrites a file that begins with all rows of `start`, those that are still in
  /// memory included; both grow on their own from here. Throws also if `start`'s file on disk no
  /// longer is what was written to it. Precondition: `start` is not closed.
  OutputFile(const std::filesystem::path& file, const OutputFile& start);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// Adds one row as it is, line end included; it may stay in memory for a while.
  void Append(std::string_view row);

  /// Puts all rows so far on disk.
  void Flush();

  /// As Flush; nothing may be appended afterwards.
  void Close();

 private:
  std::filesystem::path file_;
  std::ofstream out_;
  std::string buffer_;
  std::uintmax_t bytes_on_disk_{0};
};

/// Writes a whole file under a temporary name, then renames it: readers see all of it or nothing.
/// Throws ConfigError if it can't be written.
void WriteWholeFile(const std::filesystem::path& file, std::string_view text);

/// Copies a file, over an older one. Throws ConfigError naming `to` if it can't be done.
void CopyWholeFile(const std::filesystem::path& from, const std::filesystem::path& to);

/// Throws ConfigError if a fork of the run in `run_dir` was to write into that same folder, however
/// it is spelled.
void RequireOtherFolder(const std::filesystem::path& run_dir,
                        const std::filesystem::path& fork_dir);

}  // namespace sidestep
