// SPDX-License-Identifier: BSD-3-Clause
// The program as the shell sees it: exit codes, one-line errors, what it overwrites, Ctrl-C.

#include <gtest/gtest.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "sim/process/process.h"
#include "sim/record/run_files.h"
#include "tests/support/run_files.h"
#include "tests/support/sidestep_program.h"
#include "tests/unit/check/check_test_support.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

// Stands for a moment: the shortest run that uses every room.
constexpr const char* kStanding = R"(sidestep: 1
name: standing
robot: hopper
duration_s: 0.3
expect: {fall: false}
)";
// Does nothing, and so falls once a push takes it off its balance on a point.
constexpr const char* kFalling = R"(sidestep: 1
name: falling
robot: hopper
duration_s: 3.0
control: {mode: passive}
pushes:
  - {body: trunk, force_N: [0, 5, 0], start_s: 0.1, duration_s: 0.2}
expect: {fall: false}
)";

// As `run` of `file` into `out`, without pictures.
ProcessResult RunOf(const fs::path& file, const fs::path& out,
                    const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"run", file, "-o", out, "--no-video", "--no-plots", "-q"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return Sidestep(arguments);
}

nlohmann::json SummaryOf(const fs::path& run_dir) {
  return nlohmann::json::parse(TextOf(run_dir / "summary.json"));
}

TEST(ExitCodeTest, APassIsZero) {
  const ScratchFolder folder;
  const ProcessResult result = RunOf(folder.Write("s.yaml", kStanding), folder.path() / "out");
  EXPECT_EQ(result.exit_code, 0) << result.err << result.out;
  EXPECT_EQ(SummaryOf(folder.path() / "out")["verdict"], "PASS");
  EXPECT_NE(result.out.find("standing: PASS"), std::string::npos) << result.out;
}

TEST(ExitCodeTest, AFallThatIsNotExpectedIsOne) {
  const ScratchFolder folder;
  const ProcessResult result = RunOf(folder.Write("s.yaml", kFalling), folder.path() / "out");
  EXPECT_EQ(result.exit_code, 1) << result.err << result.out;
  EXPECT_EQ(SummaryOf(folder.path() / "out")["verdict"], "FAIL");
  EXPECT_NE(result.out.find("FALL"), std::string::npos) << result.out;
}

TEST(ExitCodeTest, AFallThatIsExpectedIsZero) {
  const ScratchFolder folder;
  const ProcessResult result = RunOf(folder.Write("s.yaml", kFalling), folder.path() / "out",
                                     {"--set", "expect={fall: true}"});
  EXPECT_EQ(result.exit_code, 0) << result.err << result.out;
}

TEST(ExitCodeTest, MistakesOfTheUserAreTwoAndOneLineOnStderr) {
  const ScratchFolder folder;
  const std::string good = folder.Write("s.yaml", kStanding);
  const std::string bad = folder.Write("bad.yaml", std::string(kStanding) + "wrold: {}\n");
  const std::string out = folder.path() / "out";
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {},
           {"frobnicate"},
           {"run"},
           {"run", good, "--frobnicate"},
           {"run", "absent.yaml", "-o", out},
           {"run", bad, "-o", out},
           {"run", good, "-o", out, "--set", "world.friction"},
           {"run", good, "-o", out, "--set", "world.frictoin=0.4"},
           {"run", good, "-o", out, "--set", "world.friction=lots"},
           {"validate", bad},
           {"check", bad},
           {"check", good, "--jobs", "0"},
           {"render", folder.path()},
           {"film", folder.path(), folder.path(), "-o", out},
           {"solve", good},
           {"robots", "no_such_robot"},
           {"run", ""},
           {"run", good, "-o", ""},
           {"check", good, "--junit", ""},
           {"check", good, "--timeout", "inf"},
           {"render", folder.path(), "--speed", "nan"},
           {"plot", folder.path(), "--around", "nan"},
           {"solve", good, "--tolerance", "nan"},
           {"limit", "hopper", "--push-s", "nan"},
           {"sweep", good, "--time-budget", "nan"},
           {"sweep", good, "--resolution", "inf"}}) {
    ExpectMistake(arguments);
  }
  EXPECT_FALSE(fs::exists(out)) << "a run that never began left a folder";
}

TEST(ExitCodeTest, AMistakeInAFileIsToldWithItsPlace) {
  const ScratchFolder folder;
  const fs::path bad = folder.Write("bad.yaml", std::string(kStanding) + "wrold: {}\n");
  const ProcessResult result = Sidestep({"validate", bad});
  EXPECT_EQ(result.err.find(bad.string() + ":6:1: error: "), 0U) << result.err;
}

TEST(ExitCodeTest, HelpAndVersionAreZeroAndGoToStdout) {
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"--help"}, {"--version"}, {"run", "--help"}, {"check", "--help"}}) {
    const ProcessResult result = Sidestep(arguments);
    EXPECT_EQ(result.exit_code, 0) << testing::PrintToString(arguments);
    EXPECT_NE(result.out, "");
    EXPECT_EQ(result.err, "");
  }
}

// `run ... | head -1` ended the run by SIGPIPE; with stderr closed, progress went into whatever
// file was opened first.
TEST(StandardStreamTest, NoneThatIsClosedTouchesARun) {
  const ScratchFolder folder;
  const std::string run = std::string(SIDESTEP_BINARY) + " run " +
                          folder.Write("s.yaml", kStanding).string() +
                          " --log full --no-video --no-plots -o ";
  const fs::path whole = folder.path() / "whole";
  ASSERT_EQ(RunProcess({"bash", "-c", run + whole.string()}).exit_code, 0);
  int count = 0;
  for (const char* streams : {"2>&1 | true", ">&-", "2>&-", "<&- >&- 2>&-"}) {
    const fs::path out = folder.path() / std::to_string(count++);
    const ProcessResult result =
        RunProcess({"bash", "-c", "set -o pipefail; " + run + out.string() + " " + streams});
    EXPECT_EQ(result.exit_code, 0) << streams << result.err;
    ASSERT_TRUE(fs::exists(out / "summary.json")) << streams;
    EXPECT_EQ(SummaryOf(out)["verdict"], "PASS") << streams;
    EXPECT_EQ(WithoutWallClock(out / "trajectory.csv"), WithoutWallClock(whole / "trajectory.csv"))
        << streams;
  }
}

TEST(StandardStreamTest, AFullDiskUnderStdoutIsToldAndTheVerdictStays) {
  const ScratchFolder folder;
  const fs::path out = folder.path() / "out";
  const ProcessResult result = RunProcess(
      {"bash", "-c",
       std::string(SIDESTEP_BINARY) + " run " + folder.Write("s.yaml", kStanding).string() +
           " --no-video --no-plots -q -o " + out.string() + " >/dev/full"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.err,
            "sidestep: error: standard output can't be written: No space left on device\n");
  EXPECT_EQ(SummaryOf(out)["verdict"], "PASS");
}

TEST(OutputFolderTest, AFolderThatIsNotEmptyIsRefusedAndKept) {
  const ScratchFolder folder;
  const fs::path file = folder.Write("s.yaml", kStanding);
  folder.Write("out/thesis.tex", "years of work");
  const fs::path out = folder.path() / "out";
  EXPECT_EQ(RunOf(file, out).exit_code, 2);
  EXPECT_EQ(RunOf(file, out, {"--force"}).exit_code, 2) << "it holds no run";
  EXPECT_EQ(TextOf(out / "thesis.tex"), "years of work");
}

TEST(OutputFolderTest, ForceReplacesARunAndNothingElse) {
  const ScratchFolder folder;
  const fs::path file = folder.Write("s.yaml", kStanding);
  const fs::path out = folder.path() / "out";
  ASSERT_EQ(RunOf(file, out).exit_code, 0);
  folder.Write("out/notes.txt", "mine");
  folder.Write("out/video.mp4", "of the older run");
  ListRunFiles(out, {"video.mp4"});
  EXPECT_EQ(RunOf(file, out).exit_code, 2);
  EXPECT_TRUE(fs::exists(out / "video.mp4"));
  EXPECT_EQ(RunOf(file, out, {"--force"}).exit_code, 0);
  EXPECT_EQ(TextOf(out / "notes.txt"), "mine");
  EXPECT_FALSE(fs::exists(out / "video.mp4")) << "a video of another run";
}

TEST(LogOptionTest, NormalIsWhatARunKeepsUnlessToldOtherwise) {
  const ScratchFolder folder;
  const fs::path file = folder.Write("s.yaml", kStanding);
  ASSERT_EQ(RunOf(file, folder.path() / "run").exit_code, 0);
  EXPECT_EQ(SummaryOf(folder.path() / "run")["log"], "normal");
  ExpectMistake({"run", file, "--log", "some"}, "--log");
}

TEST(LogOptionTest, WithoutTicksNothingIsDrawnAndThatIsSaid) {
  const ScratchFolder folder;
  const fs::path file = folder.Write("s.yaml", kStanding);
  const fs::path out = folder.path() / "out";
  const ProcessResult run = Sidestep({"run", file, "--log", "none", "-q", "-o", out});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("no plots, no video: --log none"), std::string::npos) << run.out;
  EXPECT_TRUE(fs::exists(out / "report.html"));
  const std::string how = "recorded with --log none; run it again with --log normal\n";
  ExpectMistake({"plot", out}, how);
  ExpectMistake({"render", out, "-q"}, how);
  const ProcessResult report = Sidestep({"report", out});
  EXPECT_EQ(report.exit_code, 0);
  EXPECT_EQ(std::count(report.err.begin(), report.err.end(), '\n'), 1) << report.err;
}

TEST(LogOptionTest, DrawingWithoutTicksIsAMistakeWhereItIsAskedFor) {
  const ScratchFolder folder;
  const fs::path file = folder.Write("s.yaml", kStanding);
  const fs::path out = folder.path() / "out";
  ExpectMistake({"run", file, "--log", "none", "--plots", "always", "-o", out}, "--plots always");
  ExpectMistake({"check", file, "--log", "none", "--video", "-o", out}, "--video");
  EXPECT_FALSE(fs::exists(out));
  const ProcessResult check = Sidestep({"check", file, "--log", "none", "-q", "-o", out});
  EXPECT_EQ(check.exit_code, 0) << check.err;
}

TEST(ResolvedScenarioTest, RunsAgainAsItIsToTheSameStates) {
  const ScratchFolder folder;
  const fs::path first = folder.path() / "first";
  const fs::path second = folder.path() / "second";
  ASSERT_EQ(RunOf(folder.Write("s.yaml", kStanding), first).exit_code, 0);
  ASSERT_EQ(RunOf(first / "scenario.yaml", second).exit_code, 0);
  EXPECT_EQ(TextOf(first / "states.bin"), TextOf(second / "states.bin"));
  EXPECT_EQ(TextOf(first / "scenario.yaml"), TextOf(second / "scenario.yaml"));
}

// Starts a run of a minute, sends `signal` once it writes, and returns its exit code.
int ExitCodeAfter(int signal, const fs::path& file, const fs::path& out) {
  const std::vector<std::string> words{SIDESTEP_BINARY, "run",       file, "-o", out, "-q",
                                       "--no-video",    "--no-plots"};
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  pid_t pid = -1;
  if (posix_spawn(&pid, SIDESTEP_BINARY, nullptr, nullptr, argv.data(), environ) != 0) return -1;
  for (int i = 0; i < 600 && !fs::exists(out / "trajectory.csv"); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  kill(pid, signal);
  int status = 0;
  waitpid(pid, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

TEST(InterruptTest, AnInterruptedRunIsInvalidAndLeavesWholeFiles) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const ScratchFolder folder;
    const fs::path out = folder.path() / "out";
    // On servos it stands for hours; the hopper falls off its point after ten simulated seconds,
    // which on a quiet core are over before the signal comes.
    const std::string long_one = "sidestep: 1\nname: standing\nrobot: icub3\nduration_s: 9000\n";
    EXPECT_EQ(ExitCodeAfter(signal, folder.Write("s.yaml", long_one), out), 3);
    const nlohmann::json summary = SummaryOf(out);
    EXPECT_EQ(summary["verdict"], "INVALID");
    EXPECT_EQ(summary["reasons"][0]["class"], "INTERRUPTED") << summary["reasons"];
    const std::string trajectory = TextOf(out / "trajectory.csv");
    ASSERT_FALSE(trajectory.empty());
    EXPECT_EQ(trajectory.back(), '\n');
    for (const char* name : {"scenario.yaml", "states.bin", "footsteps.csv", "mpc.csv"}) {
      EXPECT_TRUE(fs::exists(out / name)) << name;
    }
  }
}

TEST(InterruptTest, WhatAKilledRunLeavesCanBeShown) {
  const ScratchFolder folder;
  const std::string out = folder.path() / "out";
  const std::string long_one = "sidestep: 1\nname: standing\nrobot: icub3\nduration_s: 9000\n";
  EXPECT_EQ(ExitCodeAfter(SIGKILL, folder.Write("s.yaml", long_one), out), 128 + SIGKILL);
  EXPECT_EQ(SummaryOf(out)["verdict"], "INVALID");
  EXPECT_EQ(SummaryOf(out)["reasons"][0]["class"], "INTERRUPTED");
  for (const char* command : {"plot", "report"}) {
    const ProcessResult shown = Sidestep({command, out});
    EXPECT_EQ(shown.exit_code, 0) << command << ": " << shown.err;
  }
  EXPECT_EQ(Sidestep({"render", out, "--frame", out + "/f.png", "--time", "0"}).exit_code, 0);
  const std::string page = TextOf(fs::path(out) / "report.html");
  EXPECT_NE(page.find("INTERRUPTED"), std::string::npos);
}

// A folder with a program that stands before the real one in PATH.
std::string PathWith(const ScratchFolder& folder, const std::string& name,
                     const std::string& text) {
  const fs::path program = folder.Write("bin/" + name, "#!/bin/sh\n" + text + "\n");
  fs::permissions(program, fs::perms::owner_all);
  return "PATH=" + program.parent_path().string() + ":" + std::getenv("PATH");
}

TEST(DrawingTest, AFaultOfDrawingWarnsAndTheVerdictStands) {
  const ScratchFolder folder;
  const std::string out = folder.path() / "out";
  const ProcessResult run = RunProcess(
      {"env", PathWith(folder, "gnuplot", "echo out of ink >&2; exit 3"), SIDESTEP_BINARY, "run",
       folder.Write("s.yaml", kStanding), "-o", out, "-q", "--no-video"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("standing: PASS"), std::string::npos) << run.out;
  EXPECT_NE(run.err.find("no plots: gnuplot failed with exit code 3: out of ink"),
            std::string::npos)
      << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_TRUE(fs::exists(fs::path(out) / "report.html")) << "with what there is";
}

TEST(DrawingTest, AnInterruptWhileDrawingKeepsTheVerdictAndLeavesNoProgram) {
  const ScratchFolder folder;
  const fs::path out = folder.path() / "out", pid = folder.path() / "pid";
  const std::string hangs = "echo $$ > " + pid.string() + "; exec sleep 3600";
  Process run({"env", PathWith(folder, "gnuplot", hangs), SIDESTEP_BINARY, "run",
               folder.Write("s.yaml", kStanding), "-o", out, "-q", "--no-video"});
  for (int i = 0; i < 600 && !fs::exists(pid); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  kill(run.pid(), SIGINT);
  const ProcessResult result = run.Finish();
  EXPECT_EQ(result.exit_code, 0) << "it passed: " << result.err;
  EXPECT_NE(result.out.find("standing: PASS"), std::string::npos) << result.out;
  EXPECT_EQ(kill(std::stoi(TextOf(pid)), 0), -1) << "gnuplot is still there";
  EXPECT_EQ(SummaryOf(out)["verdict"], "PASS");
}

TEST(CheckTest, TheWorstVerdictDecidesAndJunitTellsEach) {
  const ScratchFolder folder;
  folder.Write("suite/a.yaml", kStanding);
  const fs::path falling = folder.Write("suite/b.yaml", kFalling);
  const fs::path junit = folder.path() / "junit.xml";
  const std::string runs = folder.path() / "runs";
  const ProcessResult mixed = Sidestep(
      {"check", folder.path() / "suite", "--jobs", "2", "--junit", junit, "-o", runs, "-q"});
  EXPECT_EQ(mixed.exit_code, 1) << mixed.err << mixed.out;
  EXPECT_NE(mixed.out.find("1 PASS, 1 FAIL, 0 INVALID"), std::string::npos) << mixed.out;
  EXPECT_FALSE(fs::exists(runs + "/standing/plots")) << "it passed";
  EXPECT_TRUE(fs::exists(runs + "/falling/plots/com.svg")) << "to see why";
  const std::string xml = TextOf(junit);
  EXPECT_NE(xml.find("tests=\"2\" failures=\"1\" errors=\"0\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("<failure message=\"FALL"), std::string::npos) << xml;
  for (const char* option : {"--junit", "--json"}) {
    const ProcessResult own =
        Sidestep({"check", folder.path() / "suite", "-o", runs, "-q", "--force", option, falling});
    EXPECT_EQ(own.exit_code, 2) << option << " would replace a scenario";
    EXPECT_EQ(TextOf(falling), kFalling);
  }
  fs::remove(falling);
  EXPECT_EQ(Sidestep({"check", folder.path() / "suite", "-o", runs, "-q"}).exit_code, 2)
      << "its folders are not empty";
  EXPECT_EQ(Sidestep({"check", folder.path() / "suite", "-o", runs, "-q", "--force"}).exit_code, 0);
}

TEST(CheckTest, TakesOnlyWhatIsAskedForAndTellsItAsJson) {
  const ScratchFolder folder;
  folder.Write("suite/a.yaml", kStanding);
  folder.Write("suite/b.yaml", kFalling);
  const std::string suite = folder.path() / "suite", runs = folder.path() / "runs";
  const fs::path json = folder.path() / "all.json";
  EXPECT_EQ(
      Sidestep({"check", suite, "-o", runs, "-q", "--filter", "stand*", "--json", json}).exit_code,
      0);
  const auto all = nlohmann::json::parse(TextOf(json));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0]["name"], "standing");
  EXPECT_EQ(all[0]["robot"], "hopper");
  EXPECT_EQ(all[0]["verdict"], "PASS");
  EXPECT_EQ(Sidestep({"check", suite, "-o", runs, "-q", "--force", "--shard", "0/2"}).exit_code, 0);
  EXPECT_EQ(Sidestep({"check", suite, "-o", runs, "-q", "--force", "--shard", "1/2"}).exit_code, 1);
  EXPECT_EQ(Sidestep({"check", suite, "-o", runs, "-q", "--force", "--filter", "icub*"}).exit_code,
            2);
}

TEST(CheckTest, ARunThatTakesTooLongIsInvalid) {
  const ScratchFolder folder;
  folder.Write("s.yaml", "sidestep: 1\nname: standing\nrobot: icub3\nduration_s: 9000\n");
  const ProcessResult late = Sidestep(
      {"check", folder.path() / "s.yaml", "-o", folder.path() / "runs", "-q", "--timeout", "2"});
  EXPECT_EQ(late.exit_code, 3) << late.out;
  EXPECT_NE(late.out.find("took longer than the time limit"), std::string::npos) << late.out;
}

TEST(CheckTest, OneBadScenarioStopsTheWholeCheckBeforeAnyRun) {
  const ScratchFolder folder;
  folder.Write("suite/a.yaml", kStanding);
  folder.Write("suite/b.yaml", std::string(kStanding) + "wrold: {}\n");
  const fs::path runs = folder.path() / "runs";
  ExpectMistake({"check", folder.path() / "suite", "-o", runs});
  EXPECT_FALSE(fs::exists(runs));
}

TEST(SolveTest, SolvedIsZeroInfeasibleIsOneAndBothWriteTheirFile) {
  const ScratchFolder folder;
  const std::string data = std::string(SIDESTEP_SOURCE_DIR) + "/tests/data/reference/";
  const fs::path out = folder.path() / "out.json";
  EXPECT_EQ(
      Sidestep({"solve", data + "hopper_stance_first.json", "--repeat", "3", "-o", out}).exit_code,
      0);
  const auto solved = nlohmann::json::parse(TextOf(out));
  for (const auto& block : {solved, solved["solution"]}) {
    EXPECT_GT(block["iterations"].get<int>(), 0);
    EXPECT_LE(block["solve_time_ms"]["median"], block["solve_time_ms"]["p95"]);
    EXPECT_LE(block["solve_time_ms"]["p95"], block["solve_time_ms"]["max"]);
  }
  EXPECT_EQ(solved["solution"]["status"], "solved");
  EXPECT_EQ(Sidestep({"solve", out}).exit_code, 0) << "a solved file can be solved again";
  const ProcessResult infeasible =
      Sidestep({"solve", data + "infeasible_inverted_box.json", "-o", out});
  EXPECT_EQ(infeasible.exit_code, 1) << infeasible.err;
  EXPECT_NE(nlohmann::json::parse(TextOf(out))["solution"]["status"], "solved");
}

TEST(RobotsTest, TheHopperIsListedAndItsMjcfIsWritten) {
  const ScratchFolder folder;
  const ProcessResult list = Sidestep({"robots"});
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_NE(list.out.find("hopper\n"), std::string::npos) << list.out;
  const fs::path mjcf = folder.path() / "hopper.xml";
  EXPECT_EQ(Sidestep({"robots", "hopper", "--mjcf", mjcf}).exit_code, 0);
  EXPECT_NE(TextOf(mjcf).find("<mujoco"), std::string::npos);
}

}  // namespace
}  // namespace sidestep
