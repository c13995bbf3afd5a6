// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// out_folder: the folder that a run is left in, and what may be overwritten.

#include <filesystem>
#include <string>

namespace sidestep {

/// Throws ConfigError if PrepareOutFolder would; changes nothing.
void CheckOutFolder(const std::filesystem::path& folder, bool may_replace);

/// Held for as long as a run writes to its folder; another one that wants it is refused. It ends
/// with the process, however that ends.
class OutFolderLock {
 public:
  /// Throws ConfigError if another process holds it.
  explicit OutFolderLock(const std::filesystem::path& folder);
  OutFolderLock(OutFolderLock&& other) noexcept;
  OutFolderLock(const OutFolderLock&) = delete;
  OutFolderLock& operator=(const OutFolderLock&) = delete;
  ~OutFolderLock();

 private:
  int descriptor_;
};

/// Makes `folder` an existing folder without a run in it, and ours.
///
/// A folder that is not empty is refused unless `may_replace`, and even then unless it is a run's:
/// it has a list of the files that the program wrote (run_files.h), and no file of somebody else's
/// stands where a run would write. Only listed files are removed; whatever else lies there stays.
/// @throws ConfigError if it is refused, is no folder, can't be made, or another run writes to it.
[[nodiscard]] OutFolderLock PrepareOutFolder(const std::filesystem::path& folder, bool may_replace);

/// Throws ConfigError unless `folder` is one that a run left (it holds a scenario.yaml).
void RequireRunFolder(const std::filesystem::path& folder);

/// Throws ConfigError unless a file may be written there: its folder exists, and it is no folder
/// itself and not there yet, or a file and `may_replace`.
void CheckOutFile(const std::filesystem::path& file, bool may_replace);

/// Writes a whole file, making the folder that it lies in. Throws ConfigError if it can't.
void WriteTextFile(const std::filesystem::path& file, const std::string& text);

}  // namespace sidestep
