// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// render_options: how a run is drawn.

#include <functional>

#include "sim/scenario/scenario.h"

namespace sidestep {

/// How much work a frame may cost. Milliseconds for a 640 x 480 frame of the hopper in Mesa's
/// llvmpipe on one core of the 2-core machine this was tuned on.
enum class RenderQuality {
  kDraft,   ///< No shadows, no multisampling: 22 ms.
  kNormal,  ///< Shadow map of 1024, no multisampling: 36 ms.
  kFine     ///< Shadow map of 2048, 4 samples a pixel: 107 ms.
};

/// What `sidestep render` may set. Frame size and rate as in the scenario's `video`.
struct RenderOptions {
  int width_px{640};   ///< Even, as H.264 asks.
  int height_px{480};  ///< Even; frames of less than 240 carry no captions.
  int fps{30};
  VideoCamera camera{VideoCamera::kFollow};
  RenderQuality quality{RenderQuality::kNormal};
  int jobs{1};  ///< Processes that draw a share of the frames each.

  /// Called with the share of frames drawn so far, in 0..1; may be empty.
  std::function<void(double share)> on_progress;
};

}  // namespace sidestep
