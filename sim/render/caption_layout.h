// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// caption_layout: puts a frame's captions on the picture.

#include <mujoco/mujoco.h>

#include <vector>

#include "sim/render/caption.h"

namespace sidestep::render {

/// A caption as it fits, and its box.
struct PlacedCaption {
  Caption caption;
  mjrRect box;  ///< Pixels, from the frame's bottom left.
};

/// Where the captions stand, stack by stack. What is too wide for `viewport` is cut; lines of a
/// legend are as wide as the widest of them. Of `renderer` only its fonts' sizes are read.
std::vector<PlacedCaption> LayOutCaptions(const std::vector<Caption>& captions, mjrRect viewport,
                                          const mjrContext& renderer);

/// Draws the captions into `viewport` with the current OpenGL context.
void DrawCaptions(const std::vector<Caption>& captions, mjrRect viewport,
                  const mjrContext& renderer);

}  // namespace sidestep::render
