// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/xml_bounds.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <system_error>

#include "models/support/config_error.h"
#include "models/support/utf8.h"
#include "models/support/xml_tags.h"

namespace sidestep {
namespace {

[[noreturn]] void FailAsTooLong(const std::string& file) {
  throw ConfigError(file + ": error: is longer than " + std::to_string(kMaxXmlBytes >> 20U) +
                    " MiB");
}

}  // namespace

void CheckXmlBounds(const std::string& file, const std::string& text) {
  if (text.size() > kMaxXmlBytes) FailAsTooLong(file);
  XmlTags tags(file, text);
  int num_elements = 0;
  while (const auto tag = tags.Next()) {
    if (++num_elements > kMaxXmlElements) {
      tags.Fail(tag->begin, "has more than " + std::to_string(kMaxXmlElements) + " elements");
    }
    if (tag->depth > kMaxXmlDepth) {
      tags.Fail(tag->begin, "has elements nested deeper than " + std::to_string(kMaxXmlDepth));
    }
  }
}

std::string ReadXmlText(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size > kMaxXmlBytes) FailAsTooLong(file.string());
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (error || !stream || (size > 0 && !(text << stream.rdbuf()))) {
    throw ConfigError(file.string() + ": error: can't be read");
  }
  CheckXmlBounds(file.string(), text.str());
  return text.str();
}

std::string WithoutStrayBytes(std::string text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = Utf8Length(text, at);
    const auto code = static_cast<unsigned char>(text[at]);
    const bool is_control =
        (code < 0x20U && code != '\t' && code != '\n' && code != '\r') || code == 0x7FU;
    if (length == 0 || is_control) text[at] = '?';
    at += std::max<std::size_t>(length, 1);
  }
  return text;
}

}  // namespace sidestep
