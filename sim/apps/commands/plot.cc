// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <memory>

#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"
#include "sim/plot/plot_run.h"

namespace sidestep {
namespace {

struct PlotArguments {
  std::filesystem::path run_dir;
  PlotOptions options;
  std::string size;
  double around_s{0.0};
};

}  // namespace

void AddPlotCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("plot", "Draw the plots of a run again");
  const auto arguments = std::make_shared<PlotArguments>();
  PlotOptions& options = arguments->options;
  command->add_option("RUN_DIR", arguments->run_dir, "A run's folder")->required();
  command->add_option("--only", options.only, "These plots: com,top_view")
      ->delimiter(',')
      ->type_name("NAME,...");
  const CLI::Option* around =
      command
          ->add_option("--around", arguments->around_s,
                       "The time around each push instead, so long (s) before and after it")
          ->check(Within(0.05, 1000.0))
          ->type_name("S");
  command
      ->add_option("--size", arguments->size,
                   std::string("As large as a paper or a page wants: ") + plot::kSizeWords)
      ->type_name("SIZE");
  CLI::Option* formats = command->add_option("--format", options.formats, "svg, png or pdf")
                             ->delimiter(',')
                             ->check(CLI::IsMember({"svg", "png", "pdf"}))
                             ->type_name("FORMAT,...")
                             ->capture_default_str();
  command
      ->add_flag_callback(
          "--png",
          [&options] {
            options.formats = {"svg", "png"};
          },
          "As --format svg,png")
      ->excludes(formats);
  command->callback([arguments, around, &exit_code] {
    PlotOptions& asked = arguments->options;
    RequireRunFolder(arguments->run_dir);
    if (!arguments->size.empty()) asked.canvas = plot::ReadCanvas(arguments->size);
    if (around->count() > 0) asked.around_s = arguments->around_s;
    const std::vector<std::filesystem::path> pictures = PlotRun(arguments->run_dir, asked);
    const bool is_whole = asked.only.empty() && !asked.around_s && asked.canvas.suffix.empty();
    if (is_whole) {
      std::printf("%s\n", (arguments->run_dir / "plots").c_str());
    } else {
      for (const std::filesystem::path& picture : pictures) std::printf("%s\n", picture.c_str());
    }
    exit_code = kExitPass;
  });
}

}  // namespace sidestep
