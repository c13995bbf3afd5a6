// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/fuzz_reader.h"

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "models/support/plain_line.h"
#include "models/support/utf8.h"

namespace sidestep::fuzz {
namespace {

bool HasKind(const std::string& line) {
  for (const char* kind : {": error: ", ": note: ", ": notice: ", ": warning: "}) {
    if (line.find(kind) != std::string::npos && line.find(kind) > 0) return true;
  }
  return false;
}

bool IsClean(const std::string& line) {
  for (std::size_t at = 0; at < line.size();) {
    const auto code = static_cast<unsigned char>(line[at]);
    const std::size_t length = Utf8Length(line, at);
    if (length == 0 || code < 0x20U || code == 0x7FU) return false;
    at += length;
  }
  return true;
}

}  // namespace

void Require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: %s\n", what.c_str());
  std::abort();
}

void RequireWords(const std::string& message) {
  static const bool is_told = std::getenv("FUZZ_TELL") != nullptr;
  if (is_told) std::fprintf(stderr, "%s\n", message.c_str());
  std::istringstream lines(message);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    Require(HasKind(line), "no `place: error: what`: " + line);
    Require(IsClean(line), "control characters or no UTF-8: " + line);
    Require(line.size() <= kLongestLine, "a line of " + std::to_string(line.size()) + " bytes");
  }
  Require(count > 0, "an error without words");
}

}  // namespace sidestep::fuzz
