// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/frames.h"

#include <algorithm>
#include <cmath>

#include "models/support/require.h"

namespace sidestep::render {

int FrameCount(const StateLog& log, int fps) {
  SIDESTEP_REQUIRE(fps > 0, fps);
  return std::max(1, static_cast<int>(std::lround(log.duration_s() * fps)));
}

std::size_t RowAt(const StateLog& log, double time_s) {
  SIDESTEP_REQUIRE(!log.rows.empty(), log.rows.size());
  const double last = static_cast<double>(log.rows.size() - 1);
  return static_cast<std::size_t>(std::clamp(std::round(time_s / log.dt_s), 0.0, last));
}

double FrameTime_s(int index, int fps) { return static_cast<double>(index) / fps; }

std::vector<FrameSpan> SplitFrames(int frames, int jobs) {
  SIDESTEP_REQUIRE(frames > 0, frames);
  const int parts = std::clamp(jobs, 1, frames);
  std::vector<FrameSpan> spans;
  int first = 0;
  for (int part = 0; part < parts; ++part) {
    const int length = frames / parts + (part < frames % parts ? 1 : 0);
    spans.push_back({first, first + length});
    first += length;
  }
  return spans;
}

}  // namespace sidestep::render
