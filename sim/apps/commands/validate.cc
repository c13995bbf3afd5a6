// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "models/support/config_error.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/sweep_folder.h"
#include "sim/check/find_scenarios.h"
#include "sim/process/interrupt.h"
#include "sim/scenario/find_scenario.h"
#include "sim/scenario/push_option.h"
#include "sim/scenario/read_scenario.h"
#include "sim/sweep/sweep_plan.h"

namespace sidestep {
namespace {

struct ValidateArguments {
  std::vector<std::filesystem::path> paths;
  std::vector<std::string> overrides;
};

// Reads the sweep and the first cell of every ray.
void ReadWholeSweep(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  if (!overrides.empty() && overrides.front().starts_with(kPushOption)) {
    throw ConfigError(file.string() + ": error: is a sweep's file; --push goes with scenarios");
  }
  SweepArguments arguments;
  arguments.target = file;
  arguments.sweep.set = overrides;
  MakePlan(ReadTarget(arguments), [](double /*share*/) {});
}

int Validate(const ValidateArguments& arguments) {
  const EndsAtOnce reading(kExitInvalid);
  int exit_code = kExitPass;
  for (const auto& file : FindScenarios(arguments.paths, SweepFiles::kFound)) {
    try {
      if (IsSweepFile(file)) {
        ReadWholeSweep(file, arguments.overrides);
      } else {
        ReadScenario(file, arguments.overrides, PrintNote);
      }
      std::printf("ok: %s\n", file.c_str());
      std::fflush(stdout);
    } catch (const ConfigError& error) {
      std::fprintf(stderr, "%s\n", error.what());
      exit_code = kExitBadInput;
    }
  }
  return exit_code;
}

}  // namespace

void AddValidateCommand(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("validate", "Read scenarios and sweeps and say what is wrong");
  const auto arguments = std::make_shared<ValidateArguments>();
  command
      ->add_option("PATH", arguments->paths,
                   "Files of scenarios or sweeps, or names of scenarios that ship; folders are "
                   "searched for *.yaml")
      ->required();
  AddOverrideOptions(*command, arguments->overrides);
  command->callback([arguments, &exit_code] { exit_code = Validate(*arguments); });
}

}  // namespace sidestep
