// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// film: two runs side by side, as a film of their videos and as a strip of pictures.

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace sidestep {

/// A run and what to call it.
struct FilmedRun {
  std::filesystem::path run_dir;
  std::string label;              ///< Empty: the scenario's name.
  std::filesystem::path video{};  ///< Empty: the run's video.mp4.
  double from_s{0.0};             ///< The run's time at the video's start.
  double speed{1.0};              ///< Seconds of the run in a second of the video.
};

/// Joins both runs' video.mp4, left and right, on one time axis: t = 0 is each run's start, the
/// rate that of the faster video. The run that is over first shows its last frame until the other
/// one is over, too. Over each half stand its label and, once it is decided, its outcome
/// (render/outcome.h). The smaller picture grows to the height of the larger one.
///
/// `mp4` appears whole or not at all; an older one stays until then.
/// @throws ConfigError if a run has no video or no summary.json, or ffmpeg fails (with its words).
void WriteFilm(const std::array<FilmedRun, 2>& runs, const std::filesystem::path& mp4);

/// Draws both runs at the same times, as PNG: a row a run with its label and outcome, a column a
/// time (s; at least one). Drawn again from what the runs logged, without the videos' captions.
/// @throws ConfigError as RenderRun; `png` appears whole or not at all.
void WriteStrip(const std::array<FilmedRun, 2>& runs, const std::vector<double>& times_s,
                const std::filesystem::path& png);

}  // namespace sidestep
