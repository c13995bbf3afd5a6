// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/offscreen_context.h"

#include <GL/osmesa.h>

#include <cstdlib>

#include "models/support/config_error.h"

namespace sidestep::render {
namespace {

constexpr int kDepthBits = 24;
constexpr int kStencilBits = 8;
constexpr int kWindow_px = 16;  // never drawn to

}  // namespace

OffscreenContext::OffscreenContext() : window_(kWindow_px * kWindow_px * 4) {
  // Frames are shared out between processes; threads inside Mesa would only compete with them.
  setenv("LP_NUM_THREADS", "0", /*overwrite=*/0);
  context_ = OSMesaCreateContextExt(OSMESA_RGBA, kDepthBits, kStencilBits, 0, nullptr);
  if (context_ == nullptr || OSMesaMakeCurrent(context_, window_.data(), GL_UNSIGNED_BYTE,
                                               kWindow_px, kWindow_px) != GL_TRUE) {
    if (context_ != nullptr) OSMesaDestroyContext(context_);
    throw ConfigError("can't create an off-screen OpenGL context (is libosmesa6 installed?)");
  }
}

OffscreenContext::~OffscreenContext() { OSMesaDestroyContext(context_); }

}  // namespace sidestep::render
