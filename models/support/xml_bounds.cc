// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/xml_bounds.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "models/support/config_error.h"
#include "models/support/utf8.h"

namespace sidestep {
namespace {

/// Goes from tag to tag.
class TagScanner {
 public:
  TagScanner(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  /// Returns the depth.
  int Scan() {
    while ((at_ = text_.find('<', at_)) != std::string_view::npos) {
      // TinyXML ends <? ...> like <! ...>, at the first '>'.
      if (Skip("<!--", "-->") || Skip("<![CDATA[", "]]>") || Skip("<?", ">")) continue;
      if (Skip("</", ">")) {
        depth_ = std::max(depth_ - 1, 0);
      } else if (!Skip("<!", ">")) {
        Open();
      }
    }
    return deepest_;
  }

 private:
  /// Passes what begins here with `begin` and ends with `end`, if it does begin so.
  bool Skip(std::string_view begin, std::string_view end) {
    if (text_.substr(at_, begin.size()) != begin) return false;
    const std::size_t stop = text_.find(end, at_ + begin.size());
    at_ = stop == std::string_view::npos ? text_.size() : stop + end.size();
    return true;
  }

  void Open() {
    const std::size_t start = at_;
    if (++num_elements_ > kMaxXmlElements) {
      Fail(start, "has more than " + std::to_string(kMaxXmlElements) + " elements");
    }
    if (++depth_ > kMaxXmlDepth) {
      Fail(start, "has elements nested deeper than " + std::to_string(kMaxXmlDepth));
    }
    deepest_ = std::max(deepest_, depth_);
    int num_attributes = 0;
    for (++at_; at_ < text_.size() && text_[at_] != '>'; ++at_) {
      if (text_[at_] == '=' && ++num_attributes > kMaxXmlAttributes) {
        Fail(start,
             "has an element with more than " + std::to_string(kMaxXmlAttributes) + " attributes");
      }
      if (text_[at_] == '"' || text_[at_] == '\'') {
        at_ = std::min(text_.find(text_[at_], at_ + 1), text_.size());
      }
    }
    if (at_ < text_.size() && text_[at_ - 1] == '/') --depth_;
  }

  [[noreturn]] void Fail(std::size_t at, const std::string& what) const {
    const std::string_view before = text_.substr(0, at);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    throw ConfigError(file_, static_cast<int>(line), static_cast<int>(at - line_start) + 1, what);
  }

  const std::string& file_;
  std::string_view text_;
  std::size_t at_{0};
  int depth_{0};
  int deepest_{0};
  int num_elements_{0};
};

[[noreturn]] void FailAsTooLong(const std::string& file) {
  throw ConfigError(file + ": error: is longer than " + std::to_string(kMaxXmlBytes >> 20U) +
                    " MiB");
}

}  // namespace

int CheckXmlBounds(const std::string& file, const std::string& text) {
  if (text.size() > kMaxXmlBytes) FailAsTooLong(file);
  return TagScanner(file, text).Scan();
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
