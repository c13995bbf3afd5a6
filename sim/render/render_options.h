// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// render_options: how a run is drawn.

#include <filesystem>
#include <functional>
#include <optional>

#include "sim/scenario/scenario.h"

namespace sidestep {

/// How much work a frame may cost: CPU milliseconds for 640 x 480 pixels, a two-legged robot with
/// pushes, footholds and captions, in Mesa's llvmpipe on one of two cores with the other one busy.
enum class RenderQuality {
  kDraft,   ///< No shadows, coarser shapes: 22 ms.
  kNormal,  ///< A round shadow below the robot, no multisampling: 25 ms.
  kFine     ///< Shadow map of 2048, 4 samples a pixel: 160 ms.
};

/// Where the camera stands.
enum class CameraView {
  kQuarter,  ///< In front, to the robot's right, a little above.
  kSide,     ///< To its right.
  kFront,
  kAbove
};

/// What `sidestep render` may set. Frame size and rate as in the scenario's `video`.
struct RenderOptions {
  int width_px{640};   ///< Even, as H.264 asks.
  int height_px{480};  ///< Even.
  int fps{30};
  VideoCamera camera{VideoCamera::kFollow};
  RenderQuality quality{RenderQuality::kNormal};
  CameraView view{CameraView::kQuarter};
  std::optional<double> from_s{};  ///< The film's part of the run's time; empty: from its start,
  std::optional<double> to_s{};    ///< to its end.
  double speed{1.0};               ///< Seconds of the run in a second of the film.
  bool has_captions{true};         ///< Words in the picture; frames lower than 240 never have any.
  int jobs{1};                     ///< Processes that draw a share of the frames each.

  /// Called with the share of frames drawn so far, in 0..1; may be empty.
  std::function<void(double share)> on_progress;
};

/// A single frame: when, and the file that it goes to.
struct TimedPicture {
  double time_s{0.0};
  std::filesystem::path png;
};

}  // namespace sidestep
