// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// frames: which frames a video has, which logged state each shows, and who draws which.

#include <cstddef>
#include <vector>

#include "sim/record/run_reader.h"

namespace sidestep::render {

/// Number of frames at `fps` that lasts as long as the log, to the nearest frame; at least one.
int FrameCount(const StateLog& log, int fps);

/// Index of the row nearest to `time_s` after the first row; clamped to the log's ends.
std::size_t RowAt(const StateLog& log, double time_s);

/// Time of frame `index` after the first row (s).
double FrameTime_s(int index, int fps);

/// Frames first <= index < end.
struct FrameSpan {
  int first{0};
  int end{0};
};

/// Splits `frames` into at most `jobs` spans in order, without gaps, that differ by at most one
/// frame in length. None is empty.
std::vector<FrameSpan> SplitFrames(int frames, int jobs);

}  // namespace sidestep::render
