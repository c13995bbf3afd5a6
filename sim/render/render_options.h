// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// render_options: how a run is drawn.

#include <filesystem>
#include <functional>

#include "sim/scenario/scenario.h"

namespace sidestep {

/// How much work a frame may cost: CPU milliseconds for 640 x 480 pixels, a two-legged robot with
/// pushes, footholds and captions, in Mesa's llvmpipe on one of two cores with the other one busy.
enum class RenderQuality {
  kDraft,   ///< No shadows, no multisampling: 30 ms.
  kNormal,  ///< Shadow map of 1024, no multisampling: 60 ms.
  kFine     ///< Shadow map of 2048, 4 samples a pixel: 200 ms.
};

/// What `sidestep render` may set. Frame size and rate as in the scenario's `video`.
struct RenderOptions {
  int width_px{640};   ///< Even, as H.264 asks.
  int height_px{480};  ///< Even.
  int fps{30};
  VideoCamera camera{VideoCamera::kFollow};
  RenderQuality quality{RenderQuality::kNormal};
  bool has_captions{true};  ///< Words in the picture; frames lower than 240 never have any.
  int jobs{1};              ///< Processes that draw a share of the frames each.

  /// Called with the share of frames drawn so far, in 0..1; may be empty.
  std::function<void(double share)> on_progress;
};

/// A single frame: when, and the file that it goes to.
struct TimedPicture {
  double time_s{0.0};
  std::filesystem::path png;
};

}  // namespace sidestep
