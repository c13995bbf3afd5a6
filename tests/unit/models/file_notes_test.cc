// SPDX-License-Identifier: BSD-3-Clause
#include "models/support/file_notes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/support/config_error.h"

namespace sidestep::file_notes_test {
namespace {

std::string ErrorOf(const FileNotes& notes) {
  try {
    notes.ThrowProblems();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

TEST(FileNotesTest, ProblemsComeInTheFilesOrderALineEach) {
  FileNotes notes("a.urdf");
  EXPECT_EQ(ErrorOf(notes), "no error");
  notes.Problem({7, 3}, "second");
  notes.Problem({2, 9}, "first");
  notes.Problem({7, 3}, "second");
  notes.Problem({}, "of the whole");
  EXPECT_EQ(ErrorOf(notes),
            "a.urdf: error: of the whole\na.urdf:2:9: error: first\na.urdf:7:3: error: second");
}

TEST(FileNotesTest, NoticesAreNoProblems) {
  FileNotes notes("a.urdf");
  notes.Notice({4, 1}, "two\nlines");
  EXPECT_FALSE(notes.has_problems());
  EXPECT_EQ(ErrorOf(notes), "no error");
  EXPECT_EQ(notes.notices(), std::vector<std::string>{"a.urdf:4:1: notice: two lines"});
}

TEST(FileNotesTest, OfTooManyProblemsTheRestIsCounted) {
  FileNotes notes("a.urdf");
  constexpr int kMany = 20'000;
  for (int i = 1; i <= kMany; ++i) notes.Problem({i, 1}, "wrong");
  const std::string text = ErrorOf(notes);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'),
            static_cast<std::ptrdiff_t>(FileNotes::kMostProblems));
  EXPECT_TRUE(text.ends_with("a.urdf: error: ... and 19800 more")) << text;
}

}  // namespace
}  // namespace sidestep::file_notes_test
