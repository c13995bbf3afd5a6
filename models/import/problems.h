// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// problems: all that is wrong with a file, told at once, and what was done to make it right.

#include <string>
#include <utility>
#include <vector>

#include "models/support/config_error.h"

namespace sidestep::importer {

/// Lines `file:line: error: ...` of one file.
class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}

  /// @param line  From 1; 0 where no line is to blame.
  void Add(int line, const std::string& what) {
    AddAt(line > 0 ? file_ + ":" + std::to_string(line) : file_, what);
  }

  /// @param place  `file:line`, where it is another file.
  void AddAt(const std::string& place, const std::string& what) {
    lines_.push_back(place + ": error: " + what);
  }

  /// Throws ConfigError with every line if there is one.
  void ThrowIfAny() const {
    if (!lines_.empty()) throw ConfigError(lines_);
  }

  const std::string& file() const { return file_; }

 private:
  std::string file_;
  std::vector<std::string> lines_;
};

/// What was done, one sentence each, for the report.
using Notes = std::vector<std::string>;

}  // namespace sidestep::importer
