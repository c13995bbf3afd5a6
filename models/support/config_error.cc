// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/config_error.h"

#include <sstream>
#include <utility>

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

std::vector<std::string> ConfigError::messages() const {
  std::vector<std::string> lines;
  std::istringstream text(what());
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

void Mistakes::Add(const ConfigError& error) {
  for (std::string& message : error.messages()) messages_.push_back(std::move(message));
}

void Mistakes::Throw() const {
  if (!messages_.empty()) throw ConfigError(messages_);
}

}  // namespace sidestep
