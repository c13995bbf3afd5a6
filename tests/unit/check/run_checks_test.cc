// SPDX-License-Identifier: BSD-3-Clause
// The pool of processes, with a shell script in the program's place.

#include "sim/check/run_checks.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>

#include "models/support/config_error.h"
#include "tests/unit/check/check_test_support.h"

namespace sidestep::run_checks_test {
namespace {

// Called as: script run FILE --out DIR ...; does what the file says.
constexpr const char* kScript = R"(#!/bin/sh
file=$2; dir=$4; mkdir -p "$dir"
verdict=$(cat "$file")
[ "$verdict" = HANG ] && exec sleep 60
if [ "$verdict" = DRAWS ]; then  # judged, and told to end while it draws
  sed "s/INVALID/PASS/" "$(dirname "$0")/summary.json" > "$dir/summary.json"
  trap 'kill $!; exit 0' TERM
  sleep 60 & wait
fi
[ "$verdict" = CRASH ] && { echo "about to crash" >&2; kill -SEGV $$; }
sed "s/INVALID/$verdict/" "$(dirname "$0")/summary.json" > "$dir/summary.json"
echo "$*" > "$dir/arguments"
[ "$verdict" = PASS ]
)";

struct Fixture {
  ScratchFolder folder;
  CheckPlan plan;

  explicit Fixture(const std::vector<std::string>& verdicts) {
    plan.program = folder.Write("program", kScript);
    folder.Write("summary.json", BareSummary(VerdictClass::kInvalid));
    std::filesystem::permissions(plan.program, std::filesystem::perms::owner_all);
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
      const std::string name = "s" + std::to_string(i);
      plan.items.push_back({name, folder.Write(name + ".yaml", verdicts[i]), folder.path() / name});
    }
  }
};

TEST(RunChecksTest, OutcomesComeInTheItemsOrderWhateverTheNumberOfJobs) {
  for (const int jobs : {1, 2, 8}) {
    Fixture fixture({"PASS", "FAIL", "CRASH", "PASS"});
    fixture.plan.jobs = jobs;
    std::size_t last_done = 0;
    const auto outcomes = RunChecks(
        fixture.plan, [] { return false; },
        [&](const Outcome&, std::size_t num_done) { EXPECT_EQ(num_done, ++last_done); });
    ASSERT_EQ(outcomes.size(), 4U);
    EXPECT_EQ(last_done, 4U);
    EXPECT_EQ(outcomes[0].verdict, VerdictClass::kPass);
    EXPECT_EQ(outcomes[1].verdict, VerdictClass::kFail);
    EXPECT_EQ(outcomes[2].verdict, VerdictClass::kInvalid);
    EXPECT_EQ(outcomes[2].error_output, "about to crash");
    EXPECT_EQ(outcomes[3].name, "s3");
  }
}

TEST(RunChecksTest, EveryRunGetsThePlansArguments) {
  Fixture fixture({"PASS"});
  fixture.plan.arguments = {"--no-video", "--set", "world.friction=0.5"};
  RunChecks(
      fixture.plan, [] { return false; }, [](const Outcome&, std::size_t) {});
  std::ifstream in(fixture.folder.path() / "s0/arguments");
  std::string arguments;
  std::getline(in, arguments);
  EXPECT_NE(arguments.find("--force --quiet --no-video --set world.friction=0.5"),
            std::string::npos)
      << arguments;
}

TEST(RunChecksTest, AfterAStopNothingIsStartedAndTheRestIsInvalid) {
  Fixture fixture({"PASS", "PASS", "PASS"});
  std::atomic<bool> stop{false};
  const auto outcomes = RunChecks(
      fixture.plan, [&] { return stop.load(); }, [&](const Outcome&, std::size_t) { stop = true; });
  EXPECT_EQ(outcomes[0].verdict, VerdictClass::kPass);
  EXPECT_EQ(outcomes[1].verdict, VerdictClass::kInvalid);
  EXPECT_EQ(outcomes[2].reasons[0], "INTERRUPTED: it was not started");
  EXPECT_FALSE(std::filesystem::exists(fixture.folder.path() / "s1"));
}

TEST(RunChecksTest, AStopEndsTheRunsInProgress) {
  Fixture fixture({"PASS", "HANG"});
  const auto start = std::chrono::steady_clock::now();
  const auto outcomes = RunChecks(
      fixture.plan,
      [&] { return std::chrono::steady_clock::now() - start > std::chrono::seconds(1); },
      [](const Outcome&, std::size_t) {});
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
  EXPECT_EQ(outcomes[1].verdict, VerdictClass::kInvalid);
  EXPECT_NE(outcomes[1].reasons[0].find("signal 15"), std::string::npos) << outcomes[1].reasons[0];
}

TEST(RunChecksTest, TheTimeLimitEndsARunButNoVerdictThatStands) {
  Fixture fixture({"HANG", "DRAWS"});
  fixture.plan.jobs = 2;
  fixture.plan.time_limit_s = 3.0;  // that DRAWS has been judged by then on any machine
  const auto outcomes = RunChecks(
      fixture.plan, [] { return false; }, [](const Outcome&, std::size_t) {});
  EXPECT_EQ(outcomes[0].verdict, VerdictClass::kInvalid);
  EXPECT_EQ(outcomes[0].reasons[0], "ERROR: took longer than the time limit");
  EXPECT_EQ(outcomes[1].verdict, VerdictClass::kPass);
  EXPECT_TRUE(outcomes[1].reasons.empty());
}

TEST(RunChecksTest, WhatAnEarlierRunLeftIsClearedBeforeARunThatMayDie) {
  Fixture fixture({"CRASH"});
  fixture.folder.Write("s0/summary.json", BareSummary(VerdictClass::kPass));
  fixture.plan.clear = [](const std::filesystem::path& run_dir) {
    std::filesystem::remove(run_dir / "summary.json");
  };
  const auto outcomes = RunChecks(
      fixture.plan, [] { return false; }, [](const Outcome&, std::size_t) {});
  ASSERT_EQ(outcomes[0].verdict, VerdictClass::kInvalid);
  EXPECT_EQ(outcomes[0].reasons[0].find("PASS"), std::string::npos) << outcomes[0].reasons[0];
  fixture.plan.clear = [](const std::filesystem::path&) { throw ConfigError("is not ours"); };
  const auto refused = RunChecks(
      fixture.plan, [] { return false; }, [](const Outcome&, std::size_t) {});
  EXPECT_EQ(refused[0].reasons[0], "ERROR: is not ours");
}

TEST(RunChecksTest, AProgramThatCannotBeStartedIsInvalid) {
  Fixture fixture({"PASS"});
  fixture.plan.program = fixture.folder.path() / "absent";
  const auto outcomes = RunChecks(
      fixture.plan, [] { return false; }, [](const Outcome&, std::size_t) {});
  EXPECT_EQ(outcomes[0].verdict, VerdictClass::kInvalid);
}

}  // namespace
}  // namespace sidestep::run_checks_test
