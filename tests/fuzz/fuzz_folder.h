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

/// The folder of this program's inputs.
const FuzzFolder& InputFolder();

/// Writes the input there, as the file of that name, and returns its path.
std::filesystem::path WriteInput(const std::string& name, const std::uint8_t* data,
                                 std::size_t size);

/// Writes the files of these names anew, from an input that is taken apart at its lines `@@ name`:
/// after each stands the text of the file of that name. A file that has no such line is empty. What
/// comes before the first line, or after one of another name, is dropped.
void WriteFiles(const FuzzFolder& folder, std::string_view input,
                const std::vector<std::string>& names);

}  // namespace sidestep::fuzz
