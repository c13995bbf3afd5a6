// SPDX-License-Identifier: BSD-3-Clause
#include "sim/process/process.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <string>

#include "models/support/config_error.h"

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
  EXPECT_EQ(RunProcess({"pwd", "-P"}, "", folder).out, folder.string() + "\n");
}

TEST(ProcessTest, AnUnfinishedProgramIsEndedWithItsObject) {
  // Hangs here for an hour if the destructor waits without ending the program.
  const Process process({"sleep", "3600"});
}

}  // namespace
}  // namespace sidestep::process_test
