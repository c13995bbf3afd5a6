// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// scratch_dir: where a picture or a video is put together before it takes its place.

#include <filesystem>
#include <string_view>

namespace sidestep::render {

/// A folder beside the file that is being made, on the same disk; removed with all that is in it
/// when it goes out of scope. Making one also removes those that killed processes have left there.
class ScratchDir {
 public:
  /// Makes the folder, and those above it. @throws ConfigError if it can't be made.
  explicit ScratchDir(const std::filesystem::path& file);
  ~ScratchDir();
  ScratchDir(const ScratchDir&) = delete;
  ScratchDir& operator=(const ScratchDir&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Renames a file of this folder to `target`, which appears whole or stays what it was.
  /// @throws ConfigError naming `target` if that can't be.
  void MoveOut(std::string_view name, const std::filesystem::path& target) const;

 private:
  std::filesystem::path path_;
  int lock_{-1};  // A descriptor; while it is open, the folder is in use.
};

}  // namespace sidestep::render
