// SPDX-License-Identifier: BSD-3-Clause
// states.bin of a run, and the frames that are drawn of it.

#include "sim/render/camera_path.h"
#include "sim/render/caption.h"
#include "sim/render/decoration.h"
#include "sim/render/foothold_marks.h"
#include "sim/render/frames.h"
#include "tests/fuzz/fuzz_folder.h"
#include "tests/fuzz/fuzz_reader.h"

namespace sidestep::fuzz {
namespace {

constexpr int kFps = 25;
constexpr int kMostFrames = 20;

// Where the CoM could be, without a model: the numbers are as wild as the input's.
std::vector<Eigen::Vector3d> PlacesOf(const StateLog& log) {
  std::vector<Eigen::Vector3d> p_W;
  for (const StateRow& row : log.rows) p_W.push_back(row.push_point_W);
  return p_W;
}

void DrawAt(const StateLog& log, const render::Clip& clip, const std::vector<Eigen::Vector3d>& p_WC,
            int frame) {
  const std::size_t at = render::RowAt(log, render::FrameTime_s(clip, frame, kFps));
  const StateRow& row = log.rows.at(at);
  const render::DrawScale scale = render::ScaleFor(log, 0.5);
  for (const VideoCamera camera : EnumValues<VideoCamera>()) {
    render::CameraAt(camera, p_WC, log.dt_s, at, 0.5, 1.5);
  }
  std::vector<Footstep> steps;
  std::vector<render::Sole> soles;
  for (const std::string& foot : log.feet) {
    steps.push_back({foot, 0, 0.0, 1.0, row.push_point_W, row.push_point_W, {}, 0.0, {}, {}, 0.0});
    soles.push_back({foot, {-0.1, -0.05}, {0.1, 0.05}, 0.0});
  }
  render::FootholdMarks(row, log.feet, steps, soles, 2.0, scale);
  render::ContactForceArrows(row, scale);
  render::PushArrow(row, scale);
  render::ComTrace(p_WC, scale);
  render::CaptionsAt(row, log.rows.back().time_s, {});
}

}  // namespace
}  // namespace sidestep::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sidestep;
  fuzz::WriteInput("states.bin", data, size);
  StateLog log;
  if (!fuzz::IsRead([&] { log = ReadStates(fuzz::InputFolder().path()); })) return 0;
  const render::Clip clip = render::ClipOf(log, std::nullopt, std::nullopt, 1.0);
  const int frames = render::FrameCount(clip, fuzz::kFps);
  fuzz::Require(frames > 0 && !render::SplitFrames(frames, 2).empty(), "no frame");
  const std::vector<Eigen::Vector3d> p_WC = fuzz::PlacesOf(log);
  for (int i = 0; i < fuzz::kMostFrames && i < frames; ++i) fuzz::DrawAt(log, clip, p_WC, i);
  return 0;
}
