// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// check_test_support: folders and files that a test throws away.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "sim/record/run_summary.h"

namespace sidestep {

/// The text of a whole summary of a run that ended with `verdict` and measured nothing.
inline std::string BareSummary(VerdictClass verdict) {
  RunSummary summary;
  summary.verdict = verdict;
  return SummaryJson(summary);
}

/// A new empty folder, removed at the end of the test.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "sidestep_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) ADD_FAILURE() << "no folder " << pattern;
    path_ = pattern;
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Writes a file of the folder, making the folders on its way.
  std::filesystem::path Write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace sidestep
