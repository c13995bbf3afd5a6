// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/config_error.h"

namespace sidestep {

ConfigError::ConfigError(const std::string& message) : std::runtime_error(message) {}

ConfigError::ConfigError(const std::string& file, int line, int column, const std::string& what)
    : std::runtime_error(file + ":" + std::to_string(line) + ":" + std::to_string(column) +
                         ": error: " + what) {}

}  // namespace sidestep
