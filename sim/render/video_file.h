// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// video_file: pixels to files, by ffmpeg as a process.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/process/process.h"

namespace sidestep::render {

/// A path as an operand of ffmpeg's that no option parser or protocol prefix can mistake.
std::string FileOperand(const std::filesystem::path& file);

/// An H.264 stream being written, one frame at a time.
class VideoWriter {
 public:
  /// Starts ffmpeg. @throws ConfigError if it can't be started.
  VideoWriter(const std::filesystem::path& file, int width_px, int height_px, int fps);

  /// Adds a frame of width x height x 3 bytes, rows from the bottom up.
  /// @throws ConfigError with ffmpeg's words if it has given up.
  void Add(const std::vector<std::uint8_t>& pixels);

  /// Completes the file. @throws ConfigError with ffmpeg's words if it failed.
  void Finish();

 private:
  Process ffmpeg_;
};

/// Joins streams that VideoWriter wrote, without coding them again, into an MP4 whose index comes
/// first. `scratch_dir` takes the list of parts. @throws ConfigError with ffmpeg's words.
void JoinVideos(const std::vector<std::filesystem::path>& parts,
                const std::filesystem::path& scratch_dir, const std::filesystem::path& mp4);

/// Turns a video into a GIF that is shown again and again, in colours of its own, at `fps` or, as
/// a GIF's time is in hundredths of a second, at 25 a second if that is less.
/// @throws ConfigError with ffmpeg's words.
void WriteGif(const std::filesystem::path& video, int fps, const std::filesystem::path& gif);

/// Writes one picture as PNG; pixels as in VideoWriter::Add. @throws ConfigError on failure.
void WritePng(const std::vector<std::uint8_t>& pixels, int width_px, int height_px,
              const std::filesystem::path& file);

}  // namespace sidestep::render
