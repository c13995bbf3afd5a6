// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/frame_source.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/render/frames.h"

namespace sidestep::render {
namespace {

constexpr double kTrace_s = 1.0;  // how far back the CoM's trace goes
constexpr double kTraceSpacing_s = 0.08;
constexpr double kFootholdMemory_s = 2.0;

std::vector<Eigen::Vector3d> TracePoints(const Recording& recording, std::size_t row) {
  const double dt_s = recording.log.dt_s;
  const auto spacing = static_cast<std::size_t>(std::max(1.0, std::round(kTraceSpacing_s / dt_s)));
  const auto reach = static_cast<std::size_t>(kTrace_s / dt_s);
  std::vector<Eigen::Vector3d> points{recording.p_WC[row]};
  // On multiples of the spacing, so that the older points stand still from frame to frame.
  const std::size_t oldest = row > reach ? row - reach : 0;
  for (std::size_t i = row / spacing * spacing; i + spacing > oldest; i -= spacing) {
    if (i < row) points.push_back(recording.p_WC[i]);
    if (i < spacing) break;
  }
  std::reverse(points.begin(), points.end());
  return points;
}

}  // namespace

FrameContent ContentAt(const Recording& recording, const RenderOptions& options, double time_s) {
  const StateLog& log = recording.log;
  FrameContent content;
  content.row = RowAt(log, time_s);
  const StateRow& row = log.rows[content.row];
  content.camera =
      CameraAt(options.camera, recording.p_WC, log.dt_s, content.row, recording.scale.com_height_m,
               static_cast<double>(options.width_px) / options.height_px, options.view);

  const auto append = [&](std::vector<Decoration> more) {
    std::move(more.begin(), more.end(), std::back_inserter(content.decorations));
  };
  if (options.quality == RenderQuality::kNormal) {
    append(GroundShadow(row, recording.p_WC[content.row], recording.scale));
  }
  append(FootholdMarks(row, log.feet, recording.footsteps, recording.soles, kFootholdMemory_s,
                       recording.scale));
  append(ContactForceArrows(row, recording.scale));
  append(ComTrace(TracePoints(recording, content.row), recording.scale));
  append(PushArrow(row, recording.scale));
  const double end_s = log.rows.front().time_s + log.duration_s();
  content.captions = CaptionsAt(row, end_s, recording.summary, options.speed);
  for (Caption& line : LegendAt(row, end_s, recording.summary, log.feet)) {
    content.captions.push_back(std::move(line));
  }
  return content;
}

}  // namespace sidestep::render
