// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/fuzz_folder.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace sidestep::fuzz {

FuzzFolder::FuzzFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "sidestep_fuzz_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) std::abort();
  path_ = pattern;
}

FuzzFolder::~FuzzFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path FuzzFolder::Write(const std::string& name, std::string_view text) const {
  std::filesystem::path file = path_ / name;
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

std::vector<FilePart> SplitFiles(std::string_view input, const std::vector<std::string>& names) {
  constexpr std::string_view kMark = "@@ ";
  std::vector<FilePart> parts;
  bool is_kept = false;
  while (!input.empty()) {
    const std::size_t end = std::min(input.find('\n'), input.size() - 1) + 1;
    const std::string_view line = input.substr(0, end);
    input.remove_prefix(end);
    if (!line.starts_with(kMark)) {
      if (is_kept) parts.back().text += line;
      continue;
    }
    const std::string name(line.substr(kMark.size(), line.find('\n') - kMark.size()));
    is_kept = std::find(names.begin(), names.end(), name) != names.end();
    if (is_kept) parts.push_back({name, ""});
  }
  return parts;
}

}  // namespace sidestep::fuzz
