// SPDX-License-Identifier: BSD-3-Clause
// `keys`, `metrics` and `schema`: what a scenario may say.

#include <cstdio>
#include <memory>

#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/scenario/key_text.h"
#include "sim/scenario/renamed_keys.h"
#include "sim/scenario/scenario_schema.h"

namespace sidestep {
namespace {

struct TableArguments {
  std::string prefix;
  bool is_markdown{false};
};

// The prefix as keys are called today; tells if that is another name.
std::string PresentName(const std::string& prefix) {
  const auto source = std::make_shared<ConfigSource>(ConfigSource{"keys " + prefix, false});
  return RenamedPath(prefix, {source},
                     [](const std::string& note) { std::fprintf(stderr, "%s\n", note.c_str()); });
}

}  // namespace

void AddKeysCommand(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("keys", "List the keys of a scenario: unit, range, default, meaning");
  const auto arguments = std::make_shared<TableArguments>();
  command->add_option("PREFIX", arguments->prefix,
                      "Only these: control.mpc, pushes, world.friction");
  command->add_flag("--markdown", arguments->is_markdown, "As Markdown");
  command->footer("A robot's own `control:` block may replace the defaults of `control`.");
  command->callback([arguments, &exit_code] {
    const std::string prefix = PresentName(arguments->prefix);
    const std::string text = arguments->is_markdown ? KeysMarkdown(prefix) : KeysText(prefix);
    std::fputs(text.c_str(), stdout);
    exit_code = kExitPass;
  });
}

void AddMetricsCommand(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("metrics", "List the metrics of summary.json: unit, meaning");
  const auto arguments = std::make_shared<TableArguments>();
  command->add_flag("--markdown", arguments->is_markdown, "As Markdown");
  command->callback([arguments, &exit_code] {
    std::fputs((arguments->is_markdown ? MetricsMarkdown() : MetricsText()).c_str(), stdout);
    exit_code = kExitPass;
  });
}

void AddSchemaCommand(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("schema", "Print the JSON Schema of a scenario, for editors");
  command->callback([&exit_code] {
    std::fputs(ScenarioSchema().c_str(), stdout);
    exit_code = kExitPass;
  });
}

}  // namespace sidestep
