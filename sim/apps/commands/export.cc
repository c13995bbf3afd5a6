// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"
#include "sim/export/export_run.h"

namespace sidestep {
namespace {

struct ExportArguments {
  std::filesystem::path run_dir;
  std::filesystem::path file;
  bool is_forced{false};
};

int Export(const ExportArguments& arguments) {
  RequireRunFolder(arguments.run_dir);
  CheckOutFile(arguments.file, arguments.is_forced);
  ExportRun(arguments.run_dir, arguments.file);
  std::printf("%s\n", arguments.file.c_str());
  return kExitPass;
}

}  // namespace

void AddExportCommand(CLI::App& app, int& exit_code) {
  CLI::App* command =
      app.add_subcommand("export", "Write a run's trajectory for MATLAB, PlotJuggler and others");
  const auto arguments = std::make_shared<ExportArguments>();
  command->add_option("RUN_DIR", arguments->run_dir, "A run's folder")->required();
  command
      ->add_option("-o,--out", arguments->file,
                   "FILE.mat (MATLAB 7.3, as iCub's viewers read it) or FILE.csv (names grouped by "
                   "/, for PlotJuggler)")
      ->required()
      ->type_name("FILE");
  command->add_flag("--force", arguments->is_forced, "Replace the file if it is there");
  command->callback([arguments, &exit_code] { exit_code = Export(*arguments); });
}

}  // namespace sidestep
