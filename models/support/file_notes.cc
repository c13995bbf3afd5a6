// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/file_notes.h"

#include <algorithm>
#include <tuple>

#include "models/support/config_error.h"
#include "models/support/plain_line.h"

namespace sidestep {
namespace {

template <typename Note>
bool IsThere(const std::vector<Note>& notes, const Note& note) {
  return std::any_of(notes.begin(), notes.end(), [&](const Note& other) {
    return other.place.line == note.place.line && other.place.column == note.place.column &&
           other.what == note.what;
  });
}

}  // namespace

void FileNotes::Problem(const TextPlace& place, const std::string& what) {
  const Note note{place, what};
  const bool is_counted_only = problems_.size() >= kMostProblems;
  if (is_counted_only || !IsThere(problems_, note)) problems_.push_back(note);
}

void FileNotes::Notice(const TextPlace& place, const std::string& what) {
  notices_.push_back({place, what});
}

std::vector<std::string> FileNotes::LinesOf(std::vector<Note> notes,
                                            const std::string& kind) const {
  std::stable_sort(notes.begin(), notes.end(), [](const Note& a, const Note& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  std::vector<std::string> lines;
  for (const Note& note : notes) {
    const TextPlace& at = note.place;
    const std::string place =
        at.line > 0 ? ":" + std::to_string(at.line) + ":" + std::to_string(at.column) : "";
    lines.push_back(PlainLine(file_ + place + ": " + kind + ": " + note.what));
  }
  return lines;
}

void FileNotes::ThrowProblems() const {
  if (problems_.empty()) return;
  std::vector<std::string> lines = LinesOf(problems_, "error");
  if (lines.size() > kMostProblems) {
    const std::string rest = std::to_string(lines.size() - kMostProblems);
    lines.resize(kMostProblems);
    lines.push_back(file_ + ": error: ... and " + rest + " more");
  }
  throw ConfigError(lines);
}

std::vector<std::string> FileNotes::notices() const { return LinesOf(notices_, "notice"); }

}  // namespace sidestep
