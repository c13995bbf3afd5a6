// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/frames.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "models/support/config_error.h"
#include "models/support/require.h"

namespace sidestep::render {

Clip ClipOf(const StateLog& log, std::optional<double> from_s, std::optional<double> to_s,
            double speed) {
  SIDESTEP_REQUIRE(!log.rows.empty(), log.rows.size());
  SIDESTEP_REQUIRE(speed > 0.0, speed);
  const double start_s = log.rows.front().time_s, end_s = start_s + log.duration_s();
  const double from = std::max(start_s, from_s.value_or(start_s));
  const double to = std::min(end_s, to_s.value_or(end_s));
  const bool is_a_moment = from == to && !from_s && !to_s;  // a run of one row is one frame
  if (from < to || is_a_moment) return {from - start_s, to - from, speed};
  std::ostringstream text;
  text << "sidestep: error: nothing from " << from_s.value_or(start_s) << " s to "
       << to_s.value_or(end_s) << " s: the run is from " << start_s << " s to " << end_s << " s";
  throw ConfigError(text.str());
}

int FrameCount(const Clip& clip, int fps) {
  SIDESTEP_REQUIRE(fps > 0, fps);
  return std::max(1, static_cast<int>(std::lround(clip.duration_s / clip.speed * fps)));
}

std::size_t RowAt(const StateLog& log, double time_s) {
  SIDESTEP_REQUIRE(!log.rows.empty(), log.rows.size());
  const double last = static_cast<double>(log.rows.size() - 1);
  return static_cast<std::size_t>(std::clamp(std::round(time_s / log.dt_s), 0.0, last));
}

double FrameTime_s(const Clip& clip, int index, int fps) {
  return clip.from_s + clip.speed * static_cast<double>(index) / fps;
}

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
