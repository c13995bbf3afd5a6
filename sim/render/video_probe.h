// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// video_probe: what a video file says of itself, by ffprobe as a process.

#include <filesystem>
#include <string>

namespace sidestep::render {

struct VideoInfo {
  int width_px{0};
  int height_px{0};
  std::string rate;  ///< Frames a second as ffmpeg writes it: "30/1".
  double fps{0.0};   ///< The same as a number.
  double duration_s{0.0};
};

/// Reads a file's first video stream.
/// @throws ConfigError if ffprobe can't be started, can't read the file (with its words), or finds
///         no video of a size, rate and duration in it.
VideoInfo ProbeVideo(const std::filesystem::path& file);

}  // namespace sidestep::render
