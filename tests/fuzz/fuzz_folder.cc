// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/fuzz_folder.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>

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

const FuzzFolder& InputFolder() {
  static const FuzzFolder folder;
  return folder;
}

std::filesystem::path WriteInput(const std::string& name, const std::uint8_t* data,
                                 std::size_t size) {
  return InputFolder().Write(name, TextOf(data, size));
}

void WriteFiles(const FuzzFolder& folder, std::string_view input,
                const std::vector<std::string>& names) {
  constexpr std::string_view kMark = "@@ ";
  std::map<std::string, std::string> texts;
  for (const std::string& name : names) texts[name] = "";
  std::string* text = nullptr;  // of the file that is being read
  while (!input.empty()) {
    const std::size_t end = std::min(input.find('\n'), input.size() - 1) + 1;
    const std::string_view line = input.substr(0, end);
    input.remove_prefix(end);
    if (line.starts_with(kMark)) {
      const auto named =
          texts.find(std::string(line.substr(kMark.size(), line.find('\n') - kMark.size())));
      text = named == texts.end() ? nullptr : &named->second;
      if (text != nullptr) text->clear();
    } else if (text != nullptr) {
      *text += line;
    }
  }
  for (const auto& [name, whole] : texts) folder.Write(name, whole);
}

}  // namespace sidestep::fuzz
