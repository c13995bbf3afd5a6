// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/scenario/scenario_list.h"

namespace sidestep {

void AddScenariosCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand(
      "scenarios", "List the scenarios that ship; run, check and the others take their names");
  const auto is_json = std::make_shared<bool>(false);
  command->add_flag("--json", *is_json, "As JSON");
  command->callback([is_json, &exit_code] {
    std::fputs((*is_json ? ScenariosJson() : ScenariosText()).c_str(), stdout);
    exit_code = kExitPass;
  });
}

}  // namespace sidestep
