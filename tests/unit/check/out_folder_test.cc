// SPDX-License-Identifier: BSD-3-Clause
// What may be overwritten: nothing but a run, and that only when asked.

#include "sim/apps/commands/out_folder.h"

#include <gtest/gtest.h>

#include "models/support/config_error.h"
#include "tests/unit/check/check_test_support.h"

namespace sidestep::out_folder_test {
namespace {

namespace fs = std::filesystem;

TEST(OutFolderTest, AnAbsentFolderIsMadeAndAnEmptyOneTaken) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "a/b";
  PrepareOutFolder(folder, false);
  EXPECT_TRUE(fs::is_directory(folder));
  PrepareOutFolder(folder, false);
}

TEST(OutFolderTest, ARunIsReplacedOnlyWhenAskedAndForeignFilesStay) {
  const ScratchFolder scratch;
  for (const char* name :
       {"scenario.yaml", "summary.json", "trajectory.csv", "video.mp4", "plots/com.svg",
        "plots/com.png", "plots/com.gp", "plots/mine.txt", "notes.md"}) {
    scratch.Write(name, "x");
  }
  EXPECT_THROW(PrepareOutFolder(scratch.path(), false), ConfigError);
  EXPECT_TRUE(fs::exists(scratch.path() / "summary.json"));
  PrepareOutFolder(scratch.path(), true);
  for (const char* gone : {"scenario.yaml", "summary.json", "trajectory.csv", "video.mp4",
                           "plots/com.svg", "plots/com.png", "plots/com.gp"}) {
    EXPECT_FALSE(fs::exists(scratch.path() / gone)) << gone;
  }
  for (const char* kept : {"plots/mine.txt", "notes.md"}) {
    EXPECT_TRUE(fs::exists(scratch.path() / kept)) << kept;
  }
}

TEST(OutFolderTest, AFolderThatHoldsNoRunIsNeverTouched) {
  const ScratchFolder scratch;
  scratch.Write("summary.json", "of another program");
  EXPECT_THROW(PrepareOutFolder(scratch.path(), true), ConfigError);
  EXPECT_TRUE(fs::exists(scratch.path() / "summary.json"));
}

TEST(OutFolderTest, CheckingChangesNothing) {
  const ScratchFolder scratch;
  CheckOutFolder(scratch.path() / "new", true);
  EXPECT_FALSE(fs::exists(scratch.path() / "new"));
  const fs::path run = scratch.Write("scenario.yaml", "x");
  CheckOutFolder(scratch.path(), true);
  EXPECT_TRUE(fs::exists(run));
}

TEST(OutFileTest, AFileIsReplacedOnlyWhenAsked) {
  const ScratchFolder scratch;
  scratch.Write("film.mp4", "x");
  EXPECT_NO_THROW(CheckOutFile(scratch.path() / "new.mp4", false));
  EXPECT_NO_THROW(CheckOutFile(scratch.path() / "film.mp4", true));
  EXPECT_THROW(CheckOutFile(scratch.path() / "film.mp4", false), ConfigError);
}

TEST(OutFileTest, AFolderAndAFileInNoFolderAreRefusedEvenByForce) {
  const ScratchFolder scratch;
  fs::create_directories(scratch.path() / "folder");
  EXPECT_THROW(CheckOutFile(scratch.path() / "folder", true), ConfigError);
  EXPECT_THROW(CheckOutFile(scratch.path() / "absent/film.mp4", true), ConfigError);
  EXPECT_NO_THROW(CheckOutFile("a_bare_name.mp4", false)) << "it goes where we are";
}

TEST(OutFolderTest, AFileInItsPlaceIsRefused) {
  const ScratchFolder scratch;
  const fs::path file = scratch.Write("file", "x");
  EXPECT_THROW(PrepareOutFolder(file, true), ConfigError);
  EXPECT_THROW(PrepareOutFolder(file / "below", true), ConfigError);
  EXPECT_TRUE(fs::is_regular_file(file));
}

TEST(RunFolderTest, OnlyAFolderWithAScenarioIsARuns) {
  const ScratchFolder scratch;
  EXPECT_THROW(RequireRunFolder(scratch.path()), ConfigError);
  EXPECT_THROW(RequireRunFolder(scratch.path() / "absent"), ConfigError);
  scratch.Write("scenario.yaml", "x");
  RequireRunFolder(scratch.path());
}

TEST(WriteTextFileTest, MakesTheFolderAndRefusesAPathItCannotWrite) {
  const ScratchFolder scratch;
  WriteTextFile(scratch.path() / "deep/er/report.xml", "<a/>");
  EXPECT_EQ(fs::file_size(scratch.path() / "deep/er/report.xml"), 4U);
  EXPECT_THROW(WriteTextFile(scratch.path() / "deep", "x"), ConfigError);
}

}  // namespace
}  // namespace sidestep::out_folder_test
