// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/config_error.h"

#include <algorithm>

namespace sidestep {
namespace {

std::string InOneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string LinesOf(const std::vector<std::string>& messages) {
  std::string lines;
  for (const std::string& message : messages) {
    lines += (lines.empty() ? "" : "\n") + InOneLine(message);
  }
  return lines;
}

}  // namespace

ConfigError::ConfigError(const std::string& message) : std::runtime_error(message) {}

ConfigError::ConfigError(const std::string& file, int line, int column, const std::string& what)
    : std::runtime_error(file + ":" + std::to_string(line) + ":" + std::to_string(column) +
                         ": error: " + what) {}

ConfigError::ConfigError(const std::vector<std::string>& messages)
    : std::runtime_error(LinesOf(messages)) {}

}  // namespace sidestep
