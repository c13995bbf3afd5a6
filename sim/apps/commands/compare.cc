// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "models/support/config_error.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/compare/compare_page.h"
#include "sim/compare/compare_runs.h"
#include "sim/compare/fail_on.h"
#include "sim/map/compare_maps.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

struct CompareArguments {
  fs::path first;
  fs::path second;
  fs::path folder;  ///< Empty: no plots.
  std::vector<std::string> fail_on;
};

// Prints the conditions that fail and gives the exit code.
int Judge(const std::vector<FailOn>& conditions, const std::vector<MetricPair>& values) {
  int exit_code = kExitPass;
  for (const FailOn& condition : conditions) {
    const MetricPair* found = nullptr;
    for (const MetricPair& value : values) {
      if (value.name == condition.name) found = &value;
    }
    if (found == nullptr) {
      throw ConfigError("--fail-on " + condition.text + ": error: there is no " + condition.name +
                        " to compare");
    }
    if (!Fails(condition, found->first, found->second)) continue;
    std::printf("FAIL %s: %g -> %g\n", condition.text.c_str(), found->first, found->second);
    exit_code = kExitFail;
  }
  return exit_code;
}

std::vector<MetricPair> ValuesOf(const map::MapComparison& comparison) {
  std::vector<MetricPair> values;
  for (const map::Quantity& one : map::QuantitiesOf(comparison)) {
    values.push_back({one.name, one.first, one.second});
  }
  return values;
}

int Compare(const CompareArguments& arguments) {
  std::vector<FailOn> conditions;
  for (const std::string& text : arguments.fail_on) conditions.push_back(ParseFailOn(text));
  const auto both_have = [&](const char* file) {
    return fs::exists(arguments.first / file) && fs::exists(arguments.second / file);
  };
  if (both_have("cells.csv")) {
    if (!arguments.folder.empty()) throw ConfigError("compare --out: error: is for two runs");
    const map::MapComparison comparison =
        map::CompareMaps(map::ReadMap(arguments.first), map::ReadMap(arguments.second));
    std::fputs(map::ComparisonText(comparison).c_str(), stdout);
    return Judge(conditions, ValuesOf(comparison));
  }
  if (both_have("summary.json")) {
    const RunComparison comparison = CompareRuns(arguments.first, arguments.second);
    std::fputs(RunComparisonText(comparison).c_str(), stdout);
    if (!arguments.folder.empty()) {
      WriteComparison(comparison, arguments.first, arguments.second, arguments.folder);
      std::printf("  page    %s\n", (arguments.folder / "compare.html").c_str());
    }
    return Judge(conditions, comparison.metrics);
  }
  throw ConfigError("compare: error: needs two runs (summary.json) or two maps (cells.csv)");
}

}  // namespace

void AddCompareCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("compare", "Tell two runs or two maps apart, in numbers");
  const auto arguments = std::make_shared<CompareArguments>();
  command->add_option("A", arguments->first, "Folder of a run or a sweep")->required();
  command->add_option("B", arguments->second, "Another of the same kind")->required();
  command
      ->add_option("-o,--out", arguments->folder,
                   "Folder that gets overlaid plots of two runs and a page with them")
      ->type_name("DIR");
  command
      ->add_option(
          "--fail-on", arguments->fail_on,
          "Exit with 1 if it holds: a metric's value (drift_m>0.2), its change from A to B "
          "(drift_m>+10%); of maps won, lost, undecided, CONTROLLER.min, .mean, .area")
      ->type_name("NAME>VALUE")
      ->take_all()
      ->allow_extra_args(false);
  command->callback([arguments, &exit_code] { exit_code = Compare(*arguments); });
}

}  // namespace sidestep
