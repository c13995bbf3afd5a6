// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// offscreen_context: an OpenGL context without a display, window or GPU.

#include <cstdint>
#include <vector>

struct osmesa_context;  // OSMesaContext is a pointer to it.

namespace sidestep::render {

/// Creates an OSMesa context and makes it current in this thread until destruction. Create it
/// after fork(), never before: Mesa's state does not survive it.
class OffscreenContext {
 public:
  /// @throws ConfigError if Mesa can't provide a context with a depth buffer of 24 bits.
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  osmesa_context* context_{nullptr};
  std::vector<std::uint8_t> window_;  ///< Mesa wants a window's memory; frames go to a buffer.
};

}  // namespace sidestep::render
