// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// render_run: a run's folder in, video.mp4 out. No display, no GPU.

#include <filesystem>
#include <vector>

#include "sim/render/render_options.h"

namespace sidestep {

/// Size, rate and camera as the run's own scenario asks, quality normal, one job.
/// @throws ConfigError if run_dir/scenario.yaml can't be read.
RenderOptions RenderOptionsOf(const std::filesystem::path& run_dir);

/// Replays run_dir/states.bin and writes run_dir/video.mp4, replacing an older one only when the
/// new one is complete. The number of frames is the log's duration times fps, rounded.
/// Reads scenario.yaml, states.bin, footsteps.csv and summary.json.
/// @throws ConfigError if a file is missing or broken, or ffmpeg fails (with its words).
void RenderRun(const std::filesystem::path& run_dir, const RenderOptions& options);

/// The same into a file of its own, MP4 or GIF, of a part of the run if options say so. One in the
/// run's folder goes on its list of files.
void RenderClip(const std::filesystem::path& run_dir, const RenderOptions& options,
                const std::filesystem::path& film);

/// Writes single frames as PNG, each at `time_s` of the run's time; before its start or after its
/// end, its first or last one. @throws as RenderRun.
void WriteFramePngs(const std::filesystem::path& run_dir, std::vector<TimedPicture> pictures,
                    const RenderOptions& options);

}  // namespace sidestep
