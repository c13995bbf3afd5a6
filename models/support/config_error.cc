// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/config_error.h"

#include "models/support/plain_line.h"

namespace sidestep {
namespace {

std::string LinesOf(const std::vector<std::string>& messages) {
  std::string lines;
  for (const std::string& message : messages) {
    lines += (lines.empty() ? "" : "\n") + PlainLine(message);
  }
  return lines;
}

}  // namespace

ConfigError::ConfigError(const std::string& message) : std::runtime_error(PlainLine(message)) {}

ConfigError::ConfigError(const std::string& file, int line, int column, const std::string& what)
    : std::runtime_error(PlainLine(file + ":" + std::to_string(line) + ":" +
                                   std::to_string(column) + ": error: " + what)) {}

ConfigError::ConfigError(const std::vector<std::string>& messages)
    : std::runtime_error(LinesOf(messages)) {}

}  // namespace sidestep
