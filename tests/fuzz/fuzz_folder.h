// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// fuzz_folder: what libFuzzer hands over, as the files that a reader reads.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sidestep::fuzz {

/// The input as text.
inline std::string TextOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A folder that lasts as long as the program.
class FuzzFolder {
 public:
  FuzzFolder();
  ~FuzzFolder();
  FuzzFolder(const FuzzFolder&) = delete;
  FuzzFolder& operator=(const FuzzFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Writes the file anew and returns its path.
  std::filesystem::path Write(const std::string& name, std::string_view text) const;

 private:
  std::filesystem::path path_;
};

/// A file of several that one input holds.
struct FilePart {
  std::string name;
  std::string text;
};

/// Takes an input apart at its lines `@@ name`: after each follows the text of the file of that
/// name, one of `names`. Files of other names, and what comes before the first such line, are
/// dropped.
std::vector<FilePart> SplitFiles(std::string_view input, const std::vector<std::string>& names);

}  // namespace sidestep::fuzz
