// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/render_run.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <thread>

#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"
#include "sim/apps/commands/progress.h"

namespace sidestep {
namespace {

struct RenderArguments {
  std::filesystem::path run_dir;
  std::filesystem::path frame;  ///< Empty: the whole video.
  double time_s{0.0};
  std::string quality{"normal"};
  int jobs{1};
  bool is_quiet{false};
};

RenderQuality QualityOf(const std::string& name) {
  if (name == "draft") return RenderQuality::kDraft;
  return name == "fine" ? RenderQuality::kFine : RenderQuality::kNormal;
}

int Render(const RenderArguments& arguments) {
  RequireRunFolder(arguments.run_dir);
  RenderOptions options = RenderOptionsOf(arguments.run_dir);
  options.quality = QualityOf(arguments.quality);
  options.jobs = arguments.jobs;
  if (!arguments.frame.empty()) {
    WriteFramePngs(arguments.run_dir, {{arguments.time_s, arguments.frame}}, options);
    std::printf("%s\n", arguments.frame.c_str());
    return kExitPass;
  }
  {
    Progress progress("video", arguments.is_quiet);
    options.on_progress = [&](double share) { progress.Update(share, ""); };
    RenderRun(arguments.run_dir, options);
  }
  std::printf("%s\n", (arguments.run_dir / "video.mp4").c_str());
  return kExitPass;
}

}  // namespace

void AddRenderCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("render", "Draw the video of a run again");
  const auto arguments = std::make_shared<RenderArguments>();
  arguments->jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  command->add_option("RUN_DIR", arguments->run_dir, "A run's folder")->required();
  command->add_option("--quality", arguments->quality, "draft, normal or fine")
      ->check(CLI::IsMember({"draft", "normal", "fine"}))
      ->capture_default_str();
  command->add_option("--frame", arguments->frame, "Write one frame as PNG instead")
      ->type_name("FILE");
  command->add_option("--time", arguments->time_s, "Time of that frame (s)")
      ->check(TimeInRun())
      ->type_name("S");
  command->add_option("-j,--jobs", arguments->jobs, "Processes that draw")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_flag("-q,--quiet", arguments->is_quiet, "No progress");
  command->callback([arguments, &exit_code] { exit_code = Render(*arguments); });
}

}  // namespace sidestep
