// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/problem_dump.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "models/support/config_error.h"
#include "sim/record/run_reader.h"
#include "tests/unit/record/record_test_support.h"

namespace sidestep::problem_dump_test {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

class ProblemDumpTest : public RecordTest {
 protected:
  static std::string Text(const std::string& name) { return "problem " + name + "\n"; }

  static Names FilesOf(const fs::path& run_dir) {
    Names names;
    if (!fs::exists(run_dir / "problems")) return names;
    for (const auto& entry : fs::directory_iterator(run_dir / "problems")) {
      names.push_back(entry.path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
};

TEST_F(ProblemDumpTest, AFailedProblemIsAFileNamedAfterItsTime) {
  ProblemDump dump(folder_, false);
  dump.Add(1.2345, true, Text);
  EXPECT_EQ(FilesOf(folder_), Names{"mpc_0001235.json"});
  EXPECT_EQ(ReadWholeFile(folder_ / "problems" / "mpc_0001235.json"), "problem mpc_0001235\n");
}

TEST_F(ProblemDumpTest, ASolvedProblemIsNotEvenWrittenOutUnlessAllAreWanted) {
  int num_asked = 0;
  const auto text = [&](const std::string& name) {
    ++num_asked;
    return name;
  };
  ProblemDump(folder_, false).Add(0.1, false, text);
  EXPECT_EQ(num_asked, 0);
  EXPECT_FALSE(fs::exists(folder_ / "problems"));
  ProblemDump(folder_, true).Add(0.1, false, text);
  EXPECT_EQ(num_asked, 1);
  EXPECT_EQ(FilesOf(folder_), Names{"mpc_0000100.json"});
}

TEST_F(ProblemDumpTest, OfFailedProblemsTheFirstTenAreKept) {
  ProblemDump dump(folder_, false);
  for (int i = 0; i < 15; ++i) dump.Add(i, true, Text);
  EXPECT_EQ(FilesOf(folder_).size(), 10U);
  EXPECT_EQ(FilesOf(folder_).back(), "mpc_0009000.json");
}

TEST_F(ProblemDumpTest, AForkHasTheFilesSoFarAndBothCountOn) {
  ProblemDump dump(folder_ / "a", false);
  for (int i = 0; i < 8; ++i) dump.Add(i, true, Text);
  ProblemDump fork = dump.ForkTo(folder_ / "b");
  for (int i = 100; i < 105; ++i) fork.Add(i, true, Text);
  dump.Add(50, true, Text);
  EXPECT_EQ(FilesOf(folder_ / "a").size(), 9U);
  const Names of_fork = FilesOf(folder_ / "b");
  ASSERT_EQ(of_fork.size(), 10U) << "eight before the fork, two after it";
  EXPECT_EQ(of_fork[7], "mpc_0007000.json");
  EXPECT_EQ(of_fork[8], "mpc_0100000.json");
  EXPECT_EQ(ReadWholeFile(folder_ / "b" / "problems" / of_fork[0]), "problem mpc_0000000\n");
}

TEST_F(ProblemDumpTest, AForkBeforeAnyFailureMakesNoFolder) {
  const ProblemDump dump(folder_ / "a", true);
  const ProblemDump fork = dump.ForkTo(folder_ / "b");
  EXPECT_FALSE(fs::exists(folder_ / "b"));
}

TEST_F(ProblemDumpTest, AForkIntoTheOwnFolderOrWithoutItsFilesIsRefused) {
  ProblemDump dump(folder_ / "a", false);
  EXPECT_THROW(dump.ForkTo(folder_ / "a"), ConfigError) << "though no folder is there yet";
  dump.Add(1.0, true, Text);
  EXPECT_THROW(dump.ForkTo(folder_ / "b" / ".." / "a"), ConfigError);
  fs::remove_all(folder_ / "a");
  EXPECT_THROW(dump.ForkTo(folder_ / "b"), ConfigError);
}

}  // namespace
}  // namespace sidestep::problem_dump_test
