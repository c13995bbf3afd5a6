// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/plain_line.h"

#include <algorithm>

#include "models/support/utf8.h"

namespace sidestep {
namespace {

constexpr char kGap[] = " ... ";
constexpr std::size_t kEnd = 400;  // of a line that is cut: where programs say what went wrong

bool ContinuesCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

}  // namespace

std::string PlainLine(std::string text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = Utf8Length(text, at);
    const auto code = static_cast<unsigned char>(text[at]);
    const bool is_line_end = code == '\n' || code == '\r' || code == '\t';
    if (is_line_end) {
      text[at] = ' ';
    } else if (length == 0 || code < 0x20U || code == 0x7FU) {
      text[at] = '?';
    }
    at += std::max<std::size_t>(length, 1);
  }
  if (text.size() <= kLongestLine) return text;
  std::size_t head = kLongestLine - kEnd - sizeof kGap, tail = text.size() - kEnd;
  while (ContinuesCharacter(text[head])) --head;
  while (tail < text.size() && ContinuesCharacter(text[tail])) ++tail;
  return text.substr(0, head) + kGap + text.substr(tail);
}

}  // namespace sidestep
