// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// frame_source: everything that one frame shows.

#include <cstddef>
#include <vector>

#include "sim/render/camera_path.h"
#include "sim/render/caption.h"
#include "sim/render/decoration.h"
#include "sim/render/recording.h"
#include "sim/render/render_options.h"

namespace sidestep::render {

/// Posture apart, the frame needs nothing of the recording but this.
struct FrameContent {
  std::size_t row{0};  ///< Of the recording's log; its qpos is the robot's posture.
  CameraPose camera;   ///< m and degrees, as MuJoCo has them.
  std::vector<Decoration> decorations;  ///< Drawn over the scene, in W.
  std::vector<Caption> captions;
};

/// The content of the frame `time_s` after the log's first row. Pure: any process may ask for any
/// frame in any order.
FrameContent ContentAt(const Recording& recording, const RenderOptions& options, double time_s);

}  // namespace sidestep::render
