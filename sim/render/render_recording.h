// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// render_recording: draws a recording to a video or a picture, given its world's model.

#include <mujoco/mujoco.h>

#include <filesystem>
#include <vector>

#include "sim/render/recording.h"
#include "sim/render/render_options.h"

namespace sidestep::render {

/// Draws all frames in options.jobs processes and writes `film`, a GIF if it is called so, else an
/// MP4. The file appears whole or not at all; an older one stays until then. Parts live in a folder
/// beside it that is removed in any case.
/// @throws ConfigError if a size is odd or a part fails, with ffmpeg's or Mesa's words.
void RenderVideo(const Recording& recording, mjModel* model, const RenderOptions& options,
                 const std::filesystem::path& film);

/// Draws one frame for each picture, `time_s` after the log's first row, as PNG. They, too, are
/// drawn in a process of their own, so that this one never holds an OpenGL context when it forks.
/// @throws ConfigError as RenderVideo.
void RenderFrames(const Recording& recording, mjModel* model, const RenderOptions& options,
                  const std::vector<TimedPicture>& pictures);

}  // namespace sidestep::render
