// SPDX-License-Identifier: BSD-3-Clause
#include "sim/process/process.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "models/support/config_error.h"
#include "sim/process/interrupt.h"

namespace sidestep::process_test {
namespace {

TEST(ProcessTest, WhatGoesInComesOut) { EXPECT_EQ(RunProcess({"cat"}, "hello\n").out, "hello\n"); }

TEST(ProcessTest, AMegabyteEachWayDoesNotBlock) {
  const std::string megabyte(1 << 20, 'x');
  EXPECT_EQ(RunProcess({"cat"}, megabyte).out, megabyte);
}

TEST(ProcessTest, ArgumentsReachTheProgramUnquotedAndUnsplit) {
  EXPECT_EQ(RunProcess({"printf", "%s|", "a b", "$(id)", "'; ls", ""}).out, "a b|$(id)|'; ls||");
}

TEST(ProcessTest, ErrorsAndExitCodesAreKeptApartFromTheOutput) {
  const ProcessResult result = RunProcess({"sh", "-c", "echo good; echo bad >&2; exit 7"});
  EXPECT_EQ(result.out, "good\n");
  EXPECT_EQ(result.err, "bad\n");
  EXPECT_EQ(result.exit_code, 7);
}

TEST(ProcessTest, ASignalsEndIsAFailure) {
  EXPECT_EQ(RunProcess({"sh", "-c", "kill -TERM $$"}).exit_code, 128 + SIGTERM);
}

TEST(ProcessTest, AProgramThatStopsReadingDoesNotKillUs) {
  Process process({"sh", "-c", "exec 0<&-; echo gave up >&2; exit 2"});
  const std::string block(1 << 16, 'x');
  bool is_open = true;
  for (int i = 0; i < 1000 && is_open; ++i) is_open = process.Write(block.data(), block.size());
  EXPECT_FALSE(is_open);
  EXPECT_EQ(process.Finish().err, "gave up\n");
}

TEST(ProcessTest, AnUnknownProgramIsNamed) {
  try {
    RunProcess({"sidestep-no-such-program"});
    FAIL() << "started";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("can't start sidestep-no-such-program: No such file"),
              std::string::npos)
        << error.what();
  }
}

TEST(ProcessTest, AFailureQuotesTheProgramsLastWords) {
  try {
    RunOrThrow({"sh", "-c", "echo disk full >&2; exit 1"});
    FAIL() << "succeeded";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "sh failed with exit code 1: disk full");
  }
}

TEST(ProcessTest, ItRunsInTheFolderAskedFor) {
  const auto folder = std::filesystem::canonical(std::filesystem::temp_directory_path());
  EXPECT_EQ(RunProcess({"pwd", "-P"}, "", {folder}).out, folder.string() + "\n");
}

TEST(ProcessTest, AnUnfinishedProgramIsEndedWithItsObject) {
  // Hangs here for an hour if the destructor waits without ending the program.
  const Process process({"sleep", "3600"});
}

TEST(ProcessTest, AToolSeesWhereThingsAreButNoSettings) {
  setenv("SIDESTEP_TEST_SETTING", "pink", 1);
  const std::string seen = RunTool({"env"}).out;
  EXPECT_NE(RunProcess({"env"}).out.find("pink"), std::string::npos);
  unsetenv("SIDESTEP_TEST_SETTING");
  EXPECT_EQ(seen.find("pink"), std::string::npos) << seen;
  EXPECT_NE(seen.find(std::string("PATH=") + std::getenv("PATH") + "\n"), std::string::npos);
}

TEST(ProcessTest, AToolThatHangsIsKilledAndNamed) {
  ProcessOptions options = ToolOptions();
  options.patience_s = 1.0;
  try {
    RunProcess({"sleep", "3600"}, {}, options);
    FAIL() << "ended";
  } catch (const ConfigError& error) {
    EXPECT_STREQ(error.what(), "sleep did nothing for 1 s and was killed");
  }
}

TEST(ProcessTest, AToolThatTakesNoInputIsKilledAndNamed) {
  ProcessOptions options = ToolOptions();
  options.patience_s = 0.1;
  EXPECT_THROW(RunProcess({"sleep", "3600"}, std::string(1 << 22, 'x'), options), ConfigError);
}

TEST(ProcessTest, AnInterruptEndsAToolAtOnce) {
  internal::interrupt_flag = true;
  EXPECT_THROW(RunTool({"sleep", "3600"}), Interrupted);
  EXPECT_THROW(RunTool({"sleep", "3600"}, std::string(1 << 22, 'x')), Interrupted);
  internal::interrupt_flag = false;
}

TEST(ProcessTest, AProgramDiesWithItsParentHoweverThatEnds) {
  int ends[2] = {-1, -1};
  ASSERT_EQ(pipe(ends), 0);
  const pid_t parent = fork();
  if (parent == 0) {
    const Process process({"sleep", "3600"});
    const pid_t pid = process.pid();
    [[maybe_unused]] const ssize_t wrote = write(ends[1], &pid, sizeof pid);
    pause();
  }
  pid_t child = -1;
  ASSERT_EQ(read(ends[0], &child, sizeof child), static_cast<ssize_t>(sizeof child));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  const auto is_alive = [&] {  // a zombie, which init may leave for a while, is dead
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    std::string word, state;
    stat >> word >> word >> state;
    return !state.empty() && state != "Z" && state != "X";
  };
  for (int i = 0; i < 500 && is_alive(); ++i) usleep(10'000);
  EXPECT_FALSE(is_alive());
  for (const int end : ends) close(end);
}

}  // namespace
}  // namespace sidestep::process_test
