// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/render_run.h"

#include "sim/record/run_files.h"
#include "sim/render/recording.h"
#include "sim/render/render_recording.h"
#include "sim/scenario/read_scenario.h"
#include "sim/world/world_model.h"

namespace sidestep {
namespace {

struct LoadedRun {
  MjModelPtr model;
  render::Recording recording;
};

LoadedRun Load(const std::filesystem::path& run_dir) {
  const Scenario scenario = ReadScenario(run_dir / "scenario.yaml", {});
  LoadedRun run;
  run.model = CompileDrawnWorld(scenario);
  run.recording = render::LoadRecording(run_dir, *run.model, scenario.robot.feet);
  return run;
}

}  // namespace

RenderOptions RenderOptionsOf(const std::filesystem::path& run_dir) {
  const VideoParams video = ReadScenario(run_dir / "scenario.yaml", {}).video;
  RenderOptions options;
  options.width_px = video.size.width_px;
  options.height_px = video.size.height_px;
  options.fps = video.fps;
  options.camera = video.camera;
  return options;
}

void RenderRun(const std::filesystem::path& run_dir, const RenderOptions& options) {
  RenderClip(run_dir, options, run_dir / "video.mp4");
}

void RenderClip(const std::filesystem::path& run_dir, const RenderOptions& options,
                const std::filesystem::path& film) {
  const LoadedRun run = Load(run_dir);
  ListIfInRun(run_dir, film);
  render::RenderVideo(run.recording, run.model.get(), options, film);
}

void WriteFramePngs(const std::filesystem::path& run_dir, std::vector<TimedPicture> pictures,
                    const RenderOptions& options) {
  const LoadedRun run = Load(run_dir);
  const double first_s = run.recording.log.rows.front().time_s;
  for (TimedPicture& picture : pictures) picture.time_s -= first_s;
  render::RenderFrames(run.recording, run.model.get(), options, pictures);
}

}  // namespace sidestep
