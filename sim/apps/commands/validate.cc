// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "models/support/config_error.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/check/find_scenarios.h"
#include "sim/scenario/read_scenario.h"

namespace sidestep {
namespace {

struct ValidateArguments {
  std::vector<std::filesystem::path> paths;
  std::vector<std::string> overrides;
};

int Validate(const ValidateArguments& arguments) {
  int exit_code = kExitPass;
  for (const auto& file : FindScenarios(arguments.paths)) {
    try {
      ReadScenario(file, arguments.overrides, PrintNote);
      std::printf("ok: %s\n", file.c_str());
    } catch (const ConfigError& error) {
      std::fprintf(stderr, "%s\n", error.what());
      exit_code = kExitBadInput;
    }
  }
  return exit_code;
}

}  // namespace

void AddValidateCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("validate", "Read scenarios and say what is wrong");
  const auto arguments = std::make_shared<ValidateArguments>();
  command
      ->add_option("PATH", arguments->paths,
                   "Scenario files or names of shipped ones; folders are searched for *.yaml")
      ->required();
  AddSetOption(*command, arguments->overrides);
  command->callback([arguments, &exit_code] { exit_code = Validate(*arguments); });
}

}  // namespace sidestep
