// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/render_run.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <thread>

#include "models/support/config_error.h"
#include "sim/apps/commands/commands.h"
#include "sim/apps/commands/exit_code.h"
#include "sim/apps/commands/out_folder.h"
#include "sim/apps/commands/progress.h"
#include "sim/render/side_by_side.h"

namespace sidestep {
namespace {

namespace fs = std::filesystem;

// Where --camera may stand: how it moves and from where it looks.
struct Camera {
  VideoCamera kind;
  CameraView view;
};
const std::map<std::string, Camera>& Cameras() {
  static const std::map<std::string, Camera> kCameras{
      {"follow", {VideoCamera::kFollow, CameraView::kQuarter}},
      {"fixed", {VideoCamera::kFixed, CameraView::kQuarter}},
      {"side", {VideoCamera::kFollow, CameraView::kSide}},
      {"front", {VideoCamera::kFollow, CameraView::kFront}},
      {"above", {VideoCamera::kFollow, CameraView::kAbove}}};
  return kCameras;
}

struct RenderArguments {
  std::vector<fs::path> run_dirs;
  fs::path frame;  ///< Empty: a film.
  fs::path out;    ///< Empty: in the run's folder.
  double time_s{0.0};
  std::optional<double> from_s, to_s;
  double speed{1.0};
  std::string camera;  ///< Empty: the scenario's.
  std::string size;    ///< Likewise.
  std::string quality{"normal"};
  int jobs{1};
  bool is_gif{false};
  bool is_side_by_side{false};
  bool is_forced{false};
  bool is_quiet{false};
};

RenderQuality QualityOf(const std::string& name) {
  if (name == "draft") return RenderQuality::kDraft;
  return name == "fine" ? RenderQuality::kFine : RenderQuality::kNormal;
}

// "1920x1080".
PixelSize SizeOf(const std::string& text) {
  PixelSize size{0, 0};
  int end = 0;
  const bool is_size =
      std::sscanf(text.c_str(), "%4dx%4d%n", &size.width_px, &size.height_px, &end) == 2 &&
      static_cast<std::size_t>(end) == text.size();
  const auto fits = [](int side_px) {
    return side_px >= 64 && side_px <= 4096 && side_px % 2 == 0;
  };
  if (is_size && fits(size.width_px) && fits(size.height_px)) return size;
  throw ConfigError("sidestep: error: --size " + text +
                    ": expected WIDTHxHEIGHT in pixels, both even and from 64 to 4096: 1920x1080");
}

RenderOptions OptionsOf(const RenderArguments& arguments, const fs::path& run_dir) {
  RenderOptions options = RenderOptionsOf(run_dir);
  options.quality = QualityOf(arguments.quality);
  options.jobs = arguments.jobs;
  options.from_s = arguments.from_s;
  options.to_s = arguments.to_s;
  options.speed = arguments.speed;
  if (!arguments.camera.empty()) {
    options.camera = Cameras().at(arguments.camera).kind;
    options.view = Cameras().at(arguments.camera).view;
  }
  if (!arguments.size.empty()) {
    options.width_px = SizeOf(arguments.size).width_px;
    options.height_px = SizeOf(arguments.size).height_px;
  }
  return options;
}

// The file that the film goes to: the run's own video only if it is whole and as the scenario
// wants it.
fs::path FilmFile(const RenderArguments& arguments) {
  const std::string extension = arguments.is_gif ? ".gif" : ".mp4";
  if (!arguments.out.empty()) {
    const std::string asked = arguments.out.extension();
    if (asked != extension) {
      throw ConfigError("sidestep: error: -o " + arguments.out.string() + ": expected a name in " +
                        extension + (arguments.is_gif ? "" : ", or --gif"));
    }
    CheckOutFile(arguments.out, arguments.is_forced);
    return arguments.out;
  }
  const bool is_own = !arguments.from_s && !arguments.to_s && arguments.speed == 1.0 &&
                      arguments.camera.empty() && arguments.size.empty() && !arguments.is_gif;
  const char* name = arguments.is_side_by_side ? "side_by_side" : is_own ? "video" : "clip";
  return arguments.run_dirs.front() / (name + extension);
}

void CheckRuns(const RenderArguments& arguments) {
  const std::size_t wanted = arguments.is_side_by_side ? 2 : 1;
  if (arguments.run_dirs.size() != wanted) {
    throw ConfigError(
        std::string("sidestep: error: render takes ") +
        (wanted == 2 ? "two runs with --side-by-side" : "one run, or two with --side-by-side"));
  }
  for (const fs::path& run_dir : arguments.run_dirs) RequireRunFolder(run_dir);
}

int Render(RenderArguments arguments) {
  CheckRuns(arguments);
  for (fs::path& run_dir : arguments.run_dirs) run_dir = run_dir.lexically_normal();
  const fs::path& run_dir = arguments.run_dirs.front();
  RenderOptions options = OptionsOf(arguments, run_dir);
  if (!arguments.frame.empty()) {
    WriteFramePngs(run_dir, {{arguments.time_s, arguments.frame}}, options);
    std::printf("%s\n", arguments.frame.c_str());
    return kExitPass;
  }
  const fs::path film = FilmFile(arguments);
  {
    Progress progress("video", arguments.is_quiet);
    options.on_progress = [&](double share) { progress.Update(share, ""); };
    if (arguments.is_side_by_side) {
      RenderSideBySide({run_dir, arguments.run_dirs.back()}, options, film);
    } else {
      RenderClip(run_dir, options, film);
    }
  }
  std::printf("%s\n", film.c_str());
  return kExitPass;
}

void AddClipOptions(CLI::App& command, RenderArguments& arguments) {
  std::vector<std::string> cameras;
  for (const auto& [name, camera] : Cameras()) cameras.push_back(name);
  CLI::Option* frame =
      command.add_option("--frame", arguments.frame, "Write one frame as PNG instead")
          ->type_name("FILE");
  command.add_option("--time", arguments.time_s, "Time of that frame (s)")
      ->check(TimeInRun())
      ->needs(frame)
      ->type_name("S");
  for (CLI::Option* option :
       {command.add_option("--from", arguments.from_s, "Begin the film at this time (s)")
            ->check(TimeInRun())
            ->type_name("S"),
        command.add_option("--to", arguments.to_s, "End it at this time (s)")
            ->check(TimeInRun())
            ->type_name("S"),
        command.add_option("--speed", arguments.speed, "Seconds of the run in one of the film")
            ->check(Within(0.01, 100.0))
            ->type_name("X"),
        command.add_flag("--gif", arguments.is_gif, "A GIF instead of an MP4"),
        command.add_flag("--side-by-side", arguments.is_side_by_side,
                         "Two runs beside each other, at the same time")}) {
    option->excludes(frame);
  }
  command.add_option("--camera", arguments.camera, "above, fixed, follow, front or side")
      ->check(CLI::IsMember(cameras))
      ->type_name("NAME");
  command.add_option("--size", arguments.size, "Pixels of a picture: 1920x1080")->type_name("WxH");
}

}  // namespace

void AddRenderCommand(CLI::App& app, int& exit_code) {
  CLI::App* command = app.add_subcommand("render", "Draw the video of a run, or a part of it");
  const auto arguments = std::make_shared<RenderArguments>();
  arguments->jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  command->add_option("RUN_DIR", arguments->run_dirs, "A run's folder")->required()->expected(1, 2);
  command
      ->add_option("-o,--out", arguments->out,
                   "The film [RUN_DIR/video.mp4; a part or another view: clip.mp4]")
      ->type_name("FILE");
  command->add_option("--quality", arguments->quality, "draft, normal or fine")
      ->check(CLI::IsMember({"draft", "normal", "fine"}))
      ->capture_default_str();
  AddClipOptions(*command, *arguments);
  command->add_option("-j,--jobs", arguments->jobs, "Processes that draw")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  command->add_flag("--force", arguments->is_forced, "Replace the file of -o if it is there");
  command->add_flag("-q,--quiet", arguments->is_quiet, "No progress");
  command->callback([arguments, &exit_code] { exit_code = Render(*arguments); });
}

}  // namespace sidestep
