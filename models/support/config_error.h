// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// config_error: a mistake in a user's file or command line.

#include <stdexcept>
#include <string>

namespace sidestep {

/// One line for the user: `file:line:column: error: what was expected`. Caught only in main,
/// which prints it and exits with 2. Line and column count from 1.
class ConfigError : public std::runtime_error {
 public:
  /// A complete message, for mistakes that have no place in a file (a missing file, a flag).
  explicit ConfigError(const std::string& message);

  /// A message with its place.
  ConfigError(const std::string& file, int line, int column, const std::string& what);
};

}  // namespace sidestep
