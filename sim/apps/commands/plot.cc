// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"
#include "sim/plot/plot_run.h"

namespace sidestep {

void AddPlotCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("plot", "Draw the plots of a run again");
  const auto run_dir = std::make_shared<std::filesystem::path>();
  const auto has_png = std::make_shared<bool>(false);
  command->add_option("RUN_DIR", *run_dir, "A run's folder")->required();
  command->add_flag("--png", *has_png, "Also as PNG");
  command->callback([run_dir, has_png, &exit_code] {
    RequireRunFolder(*run_dir);
    PlotRun(*run_dir, *has_png ? PlotFiles::kSvgAndPng : PlotFiles::kSvg);
    std::printf("%s\n", (*run_dir / "plots").c_str());
    exit_code = kExitPass;
  });
}

}  // namespace sidestep
