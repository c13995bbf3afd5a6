// SPDX-License-Identifier: BSD-3-Clause
// `plot` as the shell sees it: what it writes, what it refuses, and what it costs.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <filesystem>
#include <string>
#include <vector>

#include "sim/process/process.h"
#include "tests/support/run_files.h"
#include "tests/support/sidestep_program.h"
#include "tests/support/temp_folder.h"

namespace sidestep::plot_command_test {
namespace {

namespace fs = std::filesystem;

// User and system time of ended children and theirs.
double ChildrensCpu_s() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// A run of the shipped iCub under its pushes; made once.
struct PushedIcub {
  TempFolder folder;
  fs::path run{folder.path() / "run"};
  double cpu_s{0.0};

  PushedIcub() {
    const double before_s = ChildrensCpu_s();
    const ProcessResult result =
        Sidestep({"run", "icub_walk_right_arm_push", "-o", run, "--no-plots", "--no-video", "-q"});
    cpu_s = ChildrensCpu_s() - before_s;
    EXPECT_EQ(result.exit_code, 0) << result.err;
  }
};
const PushedIcub& Icub() {
  static const PushedIcub kIcub;
  return kIcub;
}

TEST(PlotCommandTest, AllPlotsCostLessThanTheRun) {
  const PushedIcub& icub = Icub();
  const double before_s = ChildrensCpu_s();
  EXPECT_EQ(Sidestep({"plot", icub.run}).exit_code, 0);
  const double plots_s = ChildrensCpu_s() - before_s;
  EXPECT_LT(plots_s, 0.6 * icub.cpu_s) << "a quarter of it when this was written";
  EXPECT_GT(plots_s, 0.0);
}

TEST(PlotCommandTest, AForcedRunTakesAllPlotsOfTheOneBeforeAway) {
  const TempFolder folder;
  const fs::path out = folder.path() / "run";
  const fs::path file =
      folder.Write("s.yaml",
                   "sidestep: 1\nname: pushed\nrobot: hopper\nduration_s: 0.4\n"
                   "pushes: [{body: trunk, force_N: [0, 1, 0], start_s: 0.1, duration_s: 0.1}]\n");
  const std::vector<std::string> run{"run", file, "-o", out, "--no-plots", "--no-video", "-q"};
  ASSERT_NE(Sidestep(run).exit_code, 2);
  const ProcessResult plotted = Sidestep({"plot", out, "--around", "0.1", "--only", "com,gait",
                                          "--size", "88mm", "--format", "pdf,svg"});
  EXPECT_EQ(plotted.exit_code, 0) << plotted.err;
  for (const char* name : {"com_push1_88mm.pdf", "gait_push1_88mm.svg", "curves_push1.bin"}) {
    EXPECT_TRUE(fs::exists(out / "plots" / name)) << name;
  }
  EXPECT_NE(plotted.out.find("com_push1_88mm.pdf\n"), std::string::npos) << plotted.out;
  std::vector<std::string> again = run;
  again.push_back("--force");
  EXPECT_NE(Sidestep(again).exit_code, 2);
  EXPECT_FALSE(fs::exists(out / "plots"));
}

TEST(PlotCommandTest, MistakesAreTwoAndOneLineThatTellsWhatWasExpected) {
  const fs::path& run = Icub().run;
  const std::vector<std::pair<std::vector<std::string>, std::string>> mistakes{
      {{"--only", "topview"}, "did you mean 'top_view'"},
      {{"--only", "com,bananas"}, "; there are: top_view"},
      {{"--size", "88"}, "expected a size such as 88mm"},
      {{"--size", "0mm"}, "expected a size such as 88mm"},
      {{"--format", "jpeg"}, "svg"},
      {{"--around", "-2"}, "from 0.05 to 1000"},
      {{"--around", "two"}, "--around"},
      {{"--png", "--format", "pdf"}, "excludes"}};
  for (const auto& [arguments, expected] : mistakes) {
    std::vector<std::string> words{"plot", run};
    words.insert(words.end(), arguments.begin(), arguments.end());
    ExpectMistake(words, expected);
  }
}

}  // namespace
}  // namespace sidestep::plot_command_test
