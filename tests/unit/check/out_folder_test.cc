// SPDX-License-Identifier: BSD-3-Clause
// What may be overwritten: nothing but a run, and that only when asked.

#include "sim/apps/commands/out_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "models/support/config_error.h"
#include "sim/record/run_files.h"
#include "tests/unit/check/check_test_support.h"

namespace sidestep::out_folder_test {
namespace {

namespace fs = std::filesystem;

// A run's folder, with its list.
void WriteRun(const ScratchFolder& scratch) {
  const std::vector<std::string> names{"scenario.yaml", "summary.json",  "trajectory.csv",
                                       "video.mp4",     "plots/com.svg", "plots/com.gp"};
  for (const std::string& name : names) scratch.Write(name, "x");
  ListRunFiles(scratch.path(), names);
}

TEST(OutFolderTest, AnAbsentFolderIsMadeAndAnEmptyOneTaken) {
  const ScratchFolder scratch;
  const fs::path folder = scratch.path() / "a/b";
  { const OutFolderLock lock = PrepareOutFolder(folder, false); }
  EXPECT_TRUE(fs::is_directory(folder));
  const OutFolderLock lock = PrepareOutFolder(folder, false);
}

TEST(OutFolderTest, ARunIsReplacedOnlyWhenAskedAndForeignFilesStay) {
  const ScratchFolder scratch;
  WriteRun(scratch);
  for (const char* name : {"plots/mine.svg", "notes.md"}) scratch.Write(name, "x");
  EXPECT_THROW(static_cast<void>(PrepareOutFolder(scratch.path(), false)), ConfigError);
  EXPECT_TRUE(fs::exists(scratch.path() / "summary.json"));
  const OutFolderLock lock = PrepareOutFolder(scratch.path(), true);
  for (const char* gone : {"scenario.yaml", "summary.json", "trajectory.csv", "video.mp4",
                           "plots/com.svg", "plots/com.gp", "run_files.txt"}) {
    EXPECT_FALSE(fs::exists(scratch.path() / gone)) << gone;
  }
  for (const char* kept : {"plots/mine.svg", "notes.md"}) {
    EXPECT_TRUE(fs::exists(scratch.path() / kept)) << kept;
  }
}

TEST(OutFolderTest, AUsersScenarioIsNoRun) {
  const ScratchFolder scratch;
  scratch.Write("scenario.yaml", "mine");
  scratch.Write("plots/mine.svg", "mine");
  EXPECT_THROW(static_cast<void>(PrepareOutFolder(scratch.path(), true)), ConfigError);
  EXPECT_EQ(fs::file_size(scratch.path() / "scenario.yaml"), 4U);
  EXPECT_TRUE(fs::exists(scratch.path() / "plots/mine.svg"));
}

TEST(OutFolderTest, AForeignFileWhereARunWouldWriteRefusesTheWholeFolder) {
  const ScratchFolder scratch;
  WriteRun(scratch);
  scratch.Write("mpc.csv", "mine");
  EXPECT_THROW(static_cast<void>(PrepareOutFolder(scratch.path(), true)), ConfigError);
  EXPECT_TRUE(fs::exists(scratch.path() / "mpc.csv"));
  EXPECT_TRUE(fs::exists(scratch.path() / "summary.json")) << "nothing is half removed";
}

TEST(OutFolderTest, NothingIsRemovedThroughALinkNorOutsideTheFolder) {
  const ScratchFolder scratch;
  const ScratchFolder elsewhere;
  const fs::path theirs = elsewhere.Write("com.svg", "theirs");
  WriteRun(scratch);
  fs::remove_all(scratch.path() / "plots");
  fs::create_directory_symlink(elsewhere.path(), scratch.path() / "plots");
  EXPECT_THROW(static_cast<void>(PrepareOutFolder(scratch.path(), true)), ConfigError);
  ListRunFiles(scratch.path(), {"../" + elsewhere.path().filename().string() + "/com.svg", theirs});
  RemoveListedRunFiles(scratch.path());
  EXPECT_TRUE(fs::exists(theirs));
  EXPECT_FALSE(fs::exists(scratch.path() / "summary.json"));
}

TEST(OutFolderTest, AFileInTheFolderIsListedHoweverEitherIsSpelled) {
  const ScratchFolder scratch;
  scratch.Write("run/sub/other.mp4", "");
  const fs::path run = scratch.path() / "run";
  for (const fs::path& spelled : {run, run / "", run / "sub/..", fs::relative(run)}) {
    ListIfInRun(spelled, run / "video.mp4");
    EXPECT_EQ(ListedRunFiles(run), std::vector<std::string>{"video.mp4"}) << spelled;
    RemoveListedRunFiles(run);
  }
  for (const char* elsewhere : {"run/sub/other.mp4", "video.mp4", "none/video.mp4"}) {
    ListIfInRun(run, scratch.path() / elsewhere);
    EXPECT_TRUE(ListedRunFiles(run).empty()) << elsewhere;
  }
}

TEST(OutFolderTest, TwoRunsAtOnceAreOneAndAnError) {
  const ScratchFolder scratch;
  const OutFolderLock first = PrepareOutFolder(scratch.path(), false);
  try {
    static_cast<void>(PrepareOutFolder(scratch.path(), true));
    FAIL() << "both";
  } catch (const ConfigError& error) {
    EXPECT_EQ(error.what(), scratch.path().string() + ": error: another run is writing to it");
  }
}

TEST(OutFolderTest, AFolderThatHoldsNoRunIsNeverTouched) {
  const ScratchFolder scratch;
  scratch.Write("summary.json", "of another program");
  EXPECT_THROW(static_cast<void>(PrepareOutFolder(scratch.path(), true)), ConfigError);
  EXPECT_TRUE(fs::exists(scratch.path() / "summary.json"));
}

TEST(OutFolderTest, CheckingChangesNothing) {
  const ScratchFolder scratch;
  CheckOutFolder(scratch.path() / "new", true);
  EXPECT_FALSE(fs::exists(scratch.path() / "new"));
  WriteRun(scratch);
  CheckOutFolder(scratch.path(), true);
  EXPECT_TRUE(fs::exists(scratch.path() / "scenario.yaml"));
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
  EXPECT_THROW(static_cast<void>(PrepareOutFolder(file, true)), ConfigError);
  EXPECT_THROW(static_cast<void>(PrepareOutFolder(file / "below", true)), ConfigError);
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
