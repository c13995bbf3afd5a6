// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/mjcf_sizes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "models/support/config_error.h"

namespace sidestep {
namespace {

/// The product of the numbers that an attribute holds may be `most`.
struct SizeBound {
  std::string_view element;
  std::string_view attribute;  ///< "*": any other of the element.
  double most;
};

constexpr std::array<SizeBound, 10> kBounds{{
    {"size", "nstack", 1e8},  // doubles
    {"size", "nuserdata", 1e6},
    {"size", "*", 5000},  // njmax among them, of which the stack holds five squares
    {"texture", "width", 8192},
    {"texture", "height", 8192},
    {"texture", "gridsize", 100},
    {"hfield", "nrow", 2000},
    {"hfield", "ncol", 2000},
    {"composite", "count", 500},  // bodies
    {"numeric", "size", 500},
}};

const SizeBound* BoundOf(std::string_view element, std::string_view attribute) {
  const auto found = std::find_if(kBounds.begin(), kBounds.end(), [&](const SizeBound& bound) {
    return bound.element == element && (bound.attribute == attribute || bound.attribute == "*");
  });
  return found == kBounds.end() ? nullptr : &*found;
}

/// Of the magnitudes; 0 of what is no list of numbers, which MuJoCo refuses itself.
double ProductOf(const std::string& value) {
  std::istringstream words(value);
  double product = 1.0;
  for (std::string word; words >> word;) product *= std::abs(std::strtod(word.c_str(), nullptr));
  return product;
}

constexpr std::string_view kBlanks = " \t\r\n";

/// Goes through the elements of a text and their attributes.
class SizeScanner {
 public:
  SizeScanner(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  void Scan() {
    while ((at_ = text_.find('<', at_)) != std::string_view::npos) {
      if (Skip("<!--", "-->") || Skip("<![CDATA[", "]]>")) continue;
      ReadElement();
    }
  }

 private:
  bool Skip(std::string_view begin, std::string_view end) {
    if (text_.substr(at_, begin.size()) != begin) return false;
    const std::size_t stop = text_.find(end, at_ + begin.size());
    at_ = stop == std::string_view::npos ? text_.size() : stop + end.size();
    return true;
  }

  void ReadElement() {
    const std::size_t start = at_++;
    const std::string_view element = Word();
    const bool is_joint = element == "joint" || element == "freejoint";
    if (is_joint && ++num_joints_ > kMaxMjcfJoints) {
      Fail(start, "is one joint too many: an MJCF may have " + std::to_string(kMaxMjcfJoints));
    }
    while (at_ < text_.size() && text_[at_] != '>') {
      at_ = text_.find_first_not_of(kBlanks, at_);
      if (at_ == std::string_view::npos) return;
      const std::string_view attribute = Word();
      if (attribute.empty()) {
        if (text_[at_] != '>') ++at_;  // a slash, or what is no XML
        continue;
      }
      CheckAttribute(start, element, attribute);
    }
  }

  void CheckAttribute(std::size_t start, std::string_view element, std::string_view attribute) {
    std::size_t quote = text_.find_first_not_of(kBlanks, at_);
    if (quote == std::string_view::npos || text_[quote] != '=') return;
    quote = text_.find_first_not_of(kBlanks, quote + 1);
    if (quote == std::string_view::npos || (text_[quote] != '"' && text_[quote] != '\'')) return;
    const std::size_t end = std::min(text_.find(text_[quote], quote + 1), text_.size());
    const std::string value(text_.substr(quote + 1, end - quote - 1));
    at_ = std::min(end + 1, text_.size());
    const SizeBound* bound = BoundOf(element, attribute);
    if (bound == nullptr) return;
    const bool is_spelled_out = value.find('&') == std::string::npos;
    if (is_spelled_out && ProductOf(value) <= bound->most) return;
    std::ostringstream what;
    what << "<" << element << "> has " << attribute << " = '" << value << "', more than a robot's "
         << bound->most;
    Fail(start, what.str());
  }

  /// What stands here up to a blank, a quote or one of <>/=.
  std::string_view Word() {
    const std::size_t end = std::min(text_.find_first_of(" \t\r\n<>/='\"", at_), text_.size());
    const std::string_view word = text_.substr(at_, end - at_);
    at_ = end;
    return word;
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
  int num_joints_{0};
};

}  // namespace

void CheckMjcfSizes(const std::string& file, const std::string& text) {
  SizeScanner(file, text).Scan();
}

}  // namespace sidestep
