// SPDX-License-Identifier: BSD-3-Clause
#include <fnmatch.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <thread>

#include "models/support/config_error.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"
#include "sim/apps/commands/progress.h"
#include "sim/check/find_scenarios.h"
#include "sim/check/junit.h"
#include "sim/check/outcome.h"
#include "sim/check/run_checks.h"
#include "sim/process/interrupt.h"
#include "sim/scenario/read_scenario.h"
#include "sim/sweep/shard_name.h"

namespace sidestep {
namespace {

// The command's own place: each check replaces the last one's runs there.
constexpr const char* kDefaultOutDir = "renders/check";

struct CheckArguments {
  std::vector<std::filesystem::path> paths;
  std::filesystem::path junit;
  std::filesystem::path json;
  std::string filter{"*"};  ///< Of names, as a shell's pattern.
  std::string shard{"0/1"};
  double time_limit_s{std::numeric_limits<double>::infinity()};
  std::filesystem::path out_dir{kDefaultOutDir};
  bool has_out_dir{false};
  bool is_forced{false};
  bool has_video{false};
  std::string plots{"failed"};  ///< always, failed, never.
  bool has_asked_plots{false};  ///< On the command line, rather than by default.
  LogDetail log{LogDetail::kNormal};
  bool is_quiet{false};
  int jobs{1};
  std::vector<std::string> overrides;
};

bool MayReplace(const CheckArguments& arguments) {
  return arguments.is_forced || !arguments.has_out_dir;
}

// Reads every scenario before any runs. Prints what is wrong; false if anything is.
bool PlanItems(const CheckArguments& arguments, std::vector<CheckItem>* items) {
  bool is_good = true;
  std::map<std::string, std::filesystem::path> file_of_name;
  for (const auto& file : FindScenarios(arguments.paths)) {
    try {
      const Scenario scenario = ReadScenario(file, arguments.overrides, PrintNote);
      const std::string& name = scenario.name;
      if (fnmatch(arguments.filter.c_str(), name.c_str(), 0) != 0) continue;
      const auto [first, is_new] = file_of_name.emplace(name, file);
      if (!is_new) {
        throw ConfigError(file.string() + ": error: " + first->second.string() +
                          " has the same name, '" + name + "'");
      }
      items->push_back({name, file, arguments.out_dir / name, scenario.robot_name});
      CheckOutFolder(items->back().run_dir, MayReplace(arguments));
    } catch (const ConfigError& error) {
      std::fprintf(stderr, "%s\n", error.what());
      is_good = false;
    }
  }
  return is_good;
}

// Every N-th, beginning with number I.
std::vector<CheckItem> ShareOf(const std::vector<CheckItem>& items, const std::string& shard) {
  const ShardName share = ParseShard(shard, [](const char* name) { return std::getenv(name); });
  std::vector<CheckItem> own;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (static_cast<int>(i % static_cast<std::size_t>(share.shards)) == share.shard) {
      own.push_back(items[i]);
    }
  }
  return own;
}

CheckPlan PlanOf(const CheckArguments& arguments, std::vector<CheckItem> items) {
  CheckPlan plan;
  plan.items = std::move(items);
  plan.program = ThisProgram();
  plan.jobs = arguments.jobs;
  plan.time_limit_s = arguments.time_limit_s;
  plan.clear = [may_replace = MayReplace(arguments)](const std::filesystem::path& run_dir) {
    // A run that dies must not leave an older one's files.
    [[maybe_unused]] const OutFolderLock lock = PrepareOutFolder(run_dir, may_replace);
  };
  const bool has_ticks = arguments.log != LogDetail::kNone;
  plan.arguments = {"--jobs",  "1",
                    "--log",   std::string(EnumName(arguments.log)),
                    "--plots", has_ticks ? arguments.plots : "never"};
  if (!arguments.has_video) plan.arguments.push_back("--no-video");
  const std::vector<std::string> overrides = OverrideWords(arguments.overrides);
  plan.arguments.insert(plan.arguments.end(), overrides.begin(), overrides.end());
  return plan;
}

void WriteJunit(const CheckArguments& arguments, const std::vector<Outcome>& outcomes,
                double wall_s) {
  if (!arguments.junit.empty()) {
    WriteTextFile(arguments.junit, JunitXml(outcomes, wall_s, ThisPlace()));
  }
  if (!arguments.json.empty()) WriteTextFile(arguments.json, OutcomesJson(outcomes));
}

// What the report says if this process is killed: nothing passed.
std::vector<Outcome> NotYetRun(const std::vector<CheckItem>& items) {
  std::vector<Outcome> outcomes;
  for (const CheckItem& item : items) {
    Outcome& outcome = outcomes.emplace_back();
    outcome.name = item.name;
    outcome.file = item.file;
    outcome.robot = item.robot;
    outcome.run_dir = item.run_dir;
    outcome.reasons = {"ERROR: the check ended before this run did"};
  }
  return outcomes;
}

// A report goes to a file that nobody reads here.
void CheckReportFiles(const CheckArguments& arguments, const std::vector<CheckItem>& items) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const auto is_same = [&](const fs::path& a, const fs::path& b) {
    if (a.empty() || b.empty()) return false;
    return fs::equivalent(a, b, ignored) ||
           fs::absolute(a).lexically_normal() == fs::absolute(b).lexically_normal();
  };
  for (const fs::path& report : {arguments.junit, arguments.json}) {
    for (const CheckItem& item : items) {
      if (!is_same(report, item.file)) continue;
      throw ConfigError(report.string() + ": error: is a scenario to check, and can't be a report");
    }
  }
  if (is_same(arguments.junit, arguments.json)) {
    throw ConfigError(arguments.json.string() + ": error: is the JUnit report's file too");
  }
}

// A log without ticks has nothing to draw.
void CheckWhatIsDrawn(const CheckArguments& arguments) {
  if (arguments.log != LogDetail::kNone) return;
  if (!arguments.has_video && !arguments.has_asked_plots) return;
  throw ConfigError("check: error: --log none keeps no ticks, " +
                    (arguments.has_video ? "--video" : "--plots " + arguments.plots) +
                    " can't draw them; leave one of the two out");
}

int Check(const CheckArguments& arguments) {
  CheckWhatIsDrawn(arguments);
  std::vector<CheckItem> items;
  {
    const EndsAtOnce reading(kExitInvalid);
    if (!PlanItems(arguments, &items)) return kExitBadInput;
  }
  if (items.empty()) {
    throw ConfigError("check: error: no scenario is called '" + arguments.filter + "'");
  }
  CheckReportFiles(arguments, items);
  const CheckPlan plan = PlanOf(arguments, ShareOf(items, arguments.shard));
  WriteJunit(arguments, NotYetRun(plan.items), 0.0);  // fails now rather than after the runs

  const auto start = std::chrono::steady_clock::now();
  std::vector<Outcome> outcomes;
  {
    Progress progress("check", arguments.is_quiet);
    const auto total = static_cast<double>(plan.items.size());
    outcomes = RunChecks(plan, InterruptRequested, [&](const Outcome& outcome, std::size_t done) {
      const std::string count = std::to_string(done) + "/" + std::to_string(plan.items.size());
      progress.Say("[" + count + "] " + std::string(EnumName(outcome.verdict)) + " " +
                   outcome.name);
      progress.Update(static_cast<double>(done) / total, count + " done");
    });
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  std::printf("%sruns: %s\n", OutcomeTable(outcomes, wall.count()).c_str(),
              arguments.out_dir.c_str());
  WriteJunit(arguments, outcomes, wall.count());
  return ExitCodeOf(outcomes);
}

}  // namespace

void AddCheckCommand(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("check", "Run scenarios, several at once, and tell which pass");
  const auto arguments = std::make_shared<CheckArguments>();
  arguments->jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  command
      ->add_option("PATH", arguments->paths,
                   "Scenario files or names of shipped ones; folders are searched for *.yaml")
      ->required();
  command->add_option("-j,--jobs", arguments->jobs, "Runs at once")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_option("--junit", arguments->junit, "Write a JUnit report for CI")
      ->type_name("FILE");
  command->add_option("--json", arguments->json, "Write all outcomes as JSON")->type_name("FILE");
  command
      ->add_option("--filter", arguments->filter,
                   "Only scenarios whose name fits this shell pattern: 'icub_*'")
      ->capture_default_str();
  command->add_option("--shard", arguments->shard, "Every N-th scenario, beginning with number I")
      ->type_name("I/N")
      ->capture_default_str();
  command
      ->add_option("--timeout", arguments->time_limit_s,
                   "A run that takes longer is ended and INVALID")
      ->check(AboveZero())
      ->type_name("S");
  CLI::Option* out =
      command->add_option("-o,--out", arguments->out_dir, "Folder that gets a folder a run")
          ->type_name("DIR")
          ->capture_default_str();
  command->add_flag("--force", arguments->is_forced, "Replace runs that lie in the --out folder");
  command->add_flag("--video", arguments->has_video, "Also draw the videos");
  AddPlotsOption(*command, "Runs to plot: always, failed, never", arguments->plots);
  const CLI::Option* plots = command->get_option("--plots");
  AddLogOption(*command, arguments->log);
  command->add_flag("-q,--quiet", arguments->is_quiet, "No progress");
  AddOverrideOptions(*command, arguments->overrides);
  command->callback([arguments, out, plots, &exit_code] {
    arguments->has_out_dir = out->count() > 0;
    arguments->has_asked_plots = plots->count() > 0 && arguments->plots != "never";
    exit_code = Check(*arguments);
  });
}

}  // namespace sidestep
