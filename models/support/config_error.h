// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// config_error: a mistake in a user's file or command line.

#include <stdexcept>
#include <string>
#include <vector>

namespace sidestep {

/// Lines for the user, nearly always one: `file:line:column: error: what was expected`. Caught only
/// in main, which prints them and exits with 2. Line and column count from 1.
class ConfigError : public std::runtime_error {
 public:
  /// A complete message, for mistakes that have no place in a file (a missing file, a flag).
  explicit ConfigError(const std::string& message);

  /// A message with its place.
  ConfigError(const std::string& file, int line, int column, const std::string& what);

  /// Complete messages of all that is wrong, at least one. Each takes a line, whatever is in it.
  explicit ConfigError(const std::vector<std::string>& messages);

  /// What is told, a line each.
  std::vector<std::string> messages() const;
};

/// All that is wrong with a file, to be told at once.
class Mistakes {
 public:
  /// Does what may throw a ConfigError, and keeps it. @return  Whether nothing was wrong.
  template <typename Action>
  bool Try(Action&& action) {
    try {
      action();
      return true;
    } catch (const ConfigError& error) {
      Add(error);
      return false;
    }
  }

  void Add(const ConfigError& error);

  /// Throws what was kept, if anything.
  void Throw() const;

 private:
  std::vector<std::string> messages_;
};

}  // namespace sidestep
