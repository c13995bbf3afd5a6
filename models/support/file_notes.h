// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// file_notes: all that a reader has to say of one file: what is wrong, and what it took silently.

#include <cstddef>
#include <string>
#include <vector>

#include "models/support/text_place.h"

namespace sidestep {

/// Problems and notices of one file, so that a user hears of all at once.
class FileNotes {
 public:
  static constexpr std::size_t kMostProblems = 200;  ///< Told; of more, only how many.

  explicit FileNotes(std::string file) : file_(std::move(file)) {}

  /// Something that must be mended: `what` names it and says how. Later ones on the same place with
  /// the same words are not told twice.
  void Problem(const TextPlace& place, const std::string& what);

  /// Something that is harmless, and how it was taken.
  void Notice(const TextPlace& place, const std::string& what);

  bool has_problems() const { return !problems_.empty(); }

  /// Throws ConfigError with every problem, in the file's order, if there is one.
  void ThrowProblems() const;

  /// `file:line:column: notice: what`, in the file's order.
  std::vector<std::string> notices() const;

 private:
  struct Note {
    TextPlace place;
    std::string what;
  };

  std::vector<std::string> LinesOf(std::vector<Note> notes, const std::string& kind) const;

  std::string file_;
  std::vector<Note> problems_;
  std::vector<Note> notices_;
};

}  // namespace sidestep
