// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/render_recording.h"

#include <poll.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "models/support/config_error.h"
#include "sim/process/interrupt.h"
#include "sim/render/frame_source.h"
#include "sim/render/frames.h"
#include "sim/render/scene_renderer.h"
#include "sim/render/scratch_dir.h"
#include "sim/render/segment_process.h"
#include "sim/render/video_file.h"

namespace sidestep::render {
namespace {

constexpr int kPollPeriod_ms = 100;  // how late an interrupt may be seen

void CheckOptions(const RenderOptions& options) {
  const bool is_even = options.width_px % 2 == 0 && options.height_px % 2 == 0;
  if (options.width_px < 2 || options.height_px < 2 || !is_even || options.fps < 1) {
    throw ConfigError("a video needs an even width and height and at least 1 frame a second, got " +
                      std::to_string(options.width_px) + " x " + std::to_string(options.height_px) +
                      " at " + std::to_string(options.fps));
  }
}

void DrawSpan(const Recording& recording, mjModel* model, const RenderOptions& options,
              const Clip& clip, const FrameSpan& span, const std::filesystem::path& part,
              const std::function<void()>& report_frame) {
  SceneRenderer renderer(model, options);
  VideoWriter video(part, options.width_px, options.height_px, options.fps);
  for (int frame = span.first; frame < span.end; ++frame) {
    const FrameContent content =
        ContentAt(recording, options, FrameTime_s(clip, frame, options.fps));
    video.Add(renderer.Draw(recording.log.rows[content.row].qpos, content));
    report_frame();
  }
  video.Finish();
}

using SegmentProcesses = std::vector<std::unique_ptr<SegmentProcess>>;

// Waits for all. Throws the first error, or Interrupted.
void AwaitAll(const SegmentProcesses& processes, int frames,
              const std::function<void(double)>& on_progress) {
  std::vector<pollfd> waiting;
  for (const auto& process : processes) {
    waiting.push_back({process->report_descriptor(), POLLIN, 0});
  }
  for (std::size_t running = processes.size(); running > 0;) {
    poll(waiting.data(), waiting.size(), kPollPeriod_ms);
    if (InterruptRequested()) throw Interrupted();
    int done = 0;
    for (std::size_t i = 0; i < processes.size(); ++i) {
      if (waiting[i].fd >= 0 && waiting[i].revents != 0 && !processes[i]->ReadReports()) {
        if (!processes[i]->error().empty()) throw ConfigError(processes[i]->error());
        waiting[i].fd = -1;  // poll() skips it from now on
        --running;
      }
      done += processes[i]->steps_done();
    }
    if (on_progress) on_progress(static_cast<double>(done) / frames);
  }
}

// As AwaitAll(), and ends all at once when one fails: one after the other they would go on drawing.
void Await(const SegmentProcesses& processes, int frames,
           const std::function<void(double)>& on_progress) {
  try {
    AwaitAll(processes, frames, on_progress);
  } catch (...) {
    for (const auto& process : processes) process->Kill();
    throw;
  }
}

}  // namespace

void RenderVideo(const Recording& recording, mjModel* model, const RenderOptions& options,
                 const std::filesystem::path& film) {
  CheckOptions(options);
  const Clip clip = ClipOf(recording.log, options.from_s, options.to_s, options.speed);
  const int frames = FrameCount(clip, options.fps);
  const ScratchDir scratch(film);
  std::vector<std::filesystem::path> parts;
  SegmentProcesses processes;
  for (const FrameSpan& span : SplitFrames(frames, options.jobs)) {
    const std::filesystem::path part =
        scratch.path() / ("part" + std::to_string(parts.size()) + ".mkv");
    parts.push_back(part);
    processes.push_back(std::make_unique<SegmentProcess>([&](const auto& report_frame) {
      DrawSpan(recording, model, options, clip, span, part, report_frame);
    }));
  }
  Await(processes, frames, options.on_progress);
  JoinVideos(parts, scratch.path(), scratch.path() / "video.mp4");
  const bool is_gif = film.extension() == ".gif";
  if (is_gif) WriteGif(scratch.path() / "video.mp4", options.fps, scratch.path() / "video.gif");
  scratch.MoveOut(is_gif ? "video.gif" : "video.mp4", film);
}

void RenderFrames(const Recording& recording, mjModel* model, const RenderOptions& options,
                  const std::vector<TimedPicture>& pictures) {
  CheckOptions(options);
  SegmentProcesses processes;
  processes.push_back(std::make_unique<SegmentProcess>([&](const auto& report_frame) {
    SceneRenderer renderer(model, options);
    for (const TimedPicture& picture : pictures) {
      const FrameContent content = ContentAt(recording, options, picture.time_s);
      WritePng(renderer.Draw(recording.log.rows[content.row].qpos, content), options.width_px,
               options.height_px, picture.png);
      report_frame();
    }
  }));
  Await(processes, static_cast<int>(pictures.size()), options.on_progress);
}

}  // namespace sidestep::render
