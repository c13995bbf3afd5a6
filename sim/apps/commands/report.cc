// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"
#include "sim/report/write_report.h"

namespace sidestep {
namespace {

struct ReportArguments {
  std::vector<std::filesystem::path> run_dirs;
  std::filesystem::path out;  ///< Empty: report.html in the only run's folder.
};

int Report(const ReportArguments& arguments) {
  for (const auto& run_dir : arguments.run_dirs) {
    RequireRunFolder(run_dir);
    if (!RecordsNoTicks(run_dir)) continue;
    PrintNote("note: " + run_dir.string() +
              ": recorded with --log none: no plots and no film; run it again with --log normal");
  }
  const bool is_single = arguments.run_dirs.size() == 1;
  std::filesystem::path out = arguments.out;
  if (out.empty()) out = is_single ? arguments.run_dirs[0] / "report.html" : "report.html";
  WriteReport(arguments.run_dirs, out);
  std::printf("%s\n", out.c_str());
  return kExitPass;
}

}  // namespace

void AddReportCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("report", "Write one page about one or more runs");
  const auto arguments = std::make_shared<ReportArguments>();
  command->add_option("RUN_DIR", arguments->run_dirs, "Runs' folders")->required();
  command->add_option("-o,--out", arguments->out, "Page [report.html, in the folder of one run]")
      ->type_name("FILE");
  command->callback([arguments, &exit_code] { exit_code = Report(*arguments); });
}

}  // namespace sidestep
