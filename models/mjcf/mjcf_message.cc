// SPDX-License-Identifier: BSD-3-Clause
#include "models/mjcf/mjcf_message.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace sidestep {
namespace {

/// Lines joined by "; ", without blanks around the joints.
std::string InOneLine(const std::string& text) {
  std::string joined;
  for (const char c : text) {
    if (c == '\n') {
      joined.erase(joined.find_last_not_of(" ;:") + 1);
      joined += "; ";
    } else if (c != ' ' || !joined.ends_with(' ')) {
      joined += c;
    }
  }
  joined.erase(joined.find_last_not_of(" ;:") + 1);
  return joined;
}

/// Cuts `word`, blanks, '=' and a number out of `text` and returns the number, 0 if there is none.
int CutNumber(const std::string& word, std::string* text) {
  const std::size_t start = text->find(word);
  if (start == std::string::npos) return 0;
  const std::size_t digits = text->find_first_not_of(" =", start + word.size());
  if (digits == std::string::npos) return 0;
  int number = 0;
  const char* const last = text->data() + text->size();
  const auto [end, error] = std::from_chars(text->data() + digits, last, number);
  if (error != std::errc()) return 0;
  text->erase(start, static_cast<std::size_t>(end - text->data()) - start);
  return number;
}

}  // namespace

MjcfMessage ReadMjcfMessage(const std::string& message) {
  MjcfMessage read{InOneLine(message), 0, 0};
  read.column = std::max(0, CutNumber(", column", &read.what));
  for (const char* word : {", line", " Line number", " line"}) {
    if (read.line == 0) read.line = std::max(0, CutNumber(word, &read.what));
  }
  return read;
}

}  // namespace sidestep
