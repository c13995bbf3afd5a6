// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// temp_folder: files for the length of a test, and the text of the error that reading them gives.

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "models/support/config_error.h"

namespace sidestep {

/// A folder of its own for each test, removed with its contents.
class TempFolder {
 public:
  TempFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "sidestep_XXXXXX").string();
    const char* made = mkdtemp(pattern.data());
    EXPECT_NE(made, nullptr);
    path_ = made != nullptr ? made : "";
  }
  ~TempFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  std::filesystem::path Write(const std::string& name, const std::string& text) const {
    std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  /// `text` without this folder's path.
  std::string Shorten(std::string text) const {
    const std::string prefix = path_.string() + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
      text.erase(at, prefix.size());
    }
    return text;
  }

  /// The ConfigError that `act` throws, shortened; "no error" if it returns.
  template <typename Act>
  std::string ErrorOf(Act&& act) const {
    try {
      act();
    } catch (const ConfigError& error) {
      return Shorten(error.what());
    }
    return "no error";
  }

 private:
  std::filesystem::path path_;
};

/// `text` with its only occurrence of `from` replaced.
inline std::string Edit(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << "nothing to edit: " << from;
  EXPECT_EQ(text.find(from, at + 1), std::string::npos) << "ambiguous: " << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace sidestep
