// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// problems: all that is wrong with a file, told at once, and what was done to make it right.

#include <string>
#include <utility>
#include <vector>

#include "models/support/config_error.h"
#include "models/support/text_place.h"

namespace sidestep::importer {

/// `file:line:column`; the file alone where the line is unknown.
inline std::string AtPlace(const std::string& file, const TextPlace& place) {
  if (place.line < 1) return file;
  return file + ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
}

/// Lines `file:line:column: error: ...` of one file.
class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}

  void Add(const TextPlace& place, const std::string& what) { AddAt(AtPlace(file_, place), what); }

  /// @param place  `file:line:column`, where it is another file.
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
