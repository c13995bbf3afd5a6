// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/mjcf_bounds.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "models/mjcf/mjcf_sizes.h"
#include "models/support/config_error.h"
#include "models/support/xml_bounds.h"

namespace sidestep {
namespace {

/// Values of `file` in the text's <include> tags.
std::vector<std::string> IncludesOf(std::string_view text) {
  constexpr std::string_view kTag = "<include", kFile = "file";
  std::vector<std::string> files;
  for (std::size_t at = 0; (at = text.find(kTag, at)) != std::string_view::npos;) {
    const std::size_t end = std::min(text.find('>', at), text.size());
    std::string_view tag = text.substr(at, end - at);
    at = end;
    const std::size_t name = tag.find(kFile, kTag.size());
    if (name == std::string_view::npos) continue;
    tag.remove_prefix(name + kFile.size());
    const std::size_t open = tag.find_first_of("\"'");
    if (open == std::string_view::npos) continue;
    const std::size_t close = tag.find(tag[open], open + 1);
    files.emplace_back(tag.substr(open + 1, std::min(close, tag.size()) - open - 1));
  }
  return files;
}

std::ptrdiff_t NumElements(std::string_view text) {
  std::ptrdiff_t count = 0;
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string_view::npos; ++at) {
    const char next = at + 1 < text.size() ? text[at + 1] : '/';
    if (next != '/' && next != '!' && next != '?') ++count;
  }
  return count;
}

}  // namespace

void CheckMjcfBounds(const std::filesystem::path& mjcf) {
  std::set<std::filesystem::path> seen;
  std::vector<std::filesystem::path> open{mjcf};
  std::ptrdiff_t num_elements = 0;
  for (int depth = 0; !open.empty();) {
    const std::filesystem::path file = open.back();
    open.pop_back();
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored) || !seen.insert(file).second) continue;
    const std::string text = ReadXmlText(file);
    depth += CheckXmlBounds(file.string(), text);
    if (depth > kMaxMjcfDepth) {
      throw ConfigError(mjcf.string() + ": error: has elements nested deeper than " +
                        std::to_string(kMaxMjcfDepth) + ", with the files that it includes");
    }
    CheckMjcfSizes(file.string(), text);
    num_elements += NumElements(text);
    if (num_elements > kMaxMjcfElements) {
      throw ConfigError(mjcf.string() + ": error: has more than " +
                        std::to_string(kMaxMjcfElements) +
                        " elements, with the files that it includes");
    }
    for (const std::string& name : IncludesOf(text)) {
      open.push_back((mjcf.parent_path() / name).lexically_normal());
    }
  }
}

}  // namespace sidestep
