// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// caption_layout: puts a frame's captions on the picture.

#include <mujoco/mujoco.h>

#include <vector>

#include "sim/render/caption.h"

namespace sidestep::render {

/// Draws the captions into `viewport` with the current OpenGL context.
void DrawCaptions(const std::vector<Caption>& captions, mjrRect viewport,
                  const mjrContext& renderer);

}  // namespace sidestep::render
