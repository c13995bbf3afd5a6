// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// frames: which frames a video has, which logged state each shows, and who draws which.

#include <cstddef>
#include <optional>
#include <vector>

#include "sim/record/run_reader.h"

namespace sidestep::render {

/// The part of a run that a film shows, and how fast.
struct Clip {
  double from_s{0.0};      ///< After the log's first row.
  double duration_s{0.0};  ///< Of the run's time.
  double speed{1.0};       ///< Seconds of the run in a second of the film.
};

/// The part of a log from one of its times to another, or to its ends.
/// @throws ConfigError in a line, if there is no such part.
Clip ClipOf(const StateLog& log, std::optional<double> from_s, std::optional<double> to_s,
            double speed);

/// Number of frames at `fps` that lasts as long as the clip, to the nearest frame; at least one.
int FrameCount(const Clip& clip, int fps);

/// Index of the row nearest to `time_s` after the first row; clamped to the log's ends.
std::size_t RowAt(const StateLog& log, double time_s);

/// Time of frame `index` after the log's first row (s).
double FrameTime_s(const Clip& clip, int index, int fps);

/// Frames first <= index < end.
struct FrameSpan {
  int first{0};
  int end{0};
};

/// Splits `frames` into at most `jobs` spans in order, without gaps, that differ by at most one
/// frame in length. None is empty.
std::vector<FrameSpan> SplitFrames(int frames, int jobs);

}  // namespace sidestep::render
