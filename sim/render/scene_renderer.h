// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// scene_renderer: turns a posture and a frame's content into pixels. The only user of mjr and mjv.

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "models/mjcf/mjcf.h"
#include "sim/render/frame_source.h"
#include "sim/render/offscreen_context.h"
#include "sim/render/render_options.h"

namespace sidestep::render {

/// Owns a GL context, MuJoCo's scene and a frame's pixels. One per process.
class SceneRenderer {
 public:
  /// Sets the model's rendering qualities (its physics stays as it is) and uploads it.
  /// @throws ConfigError without an OpenGL context, or if the frame does not fit Mesa's limits.
  SceneRenderer(mjModel* model, const RenderOptions& options);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// Draws one frame. Returns its pixels: 3 bytes (red, green, blue) each, rows from the bottom
  /// up. Valid until the next call.
  /// Captions are left out of frames less than 240 pixels high, and marks of a scene that is full.
  /// @param qpos  Of the model's nq; another size is a ContractViolation.
  const std::vector<std::uint8_t>& Draw(const Eigen::VectorXd& qpos, const FrameContent& content);

 private:
  void AddDecoration(const Decoration& decoration);

  mjModel* model_;  ///< Not owned; must outlive the renderer.
  RenderQuality quality_;
  bool has_captions_;
  OffscreenContext gl_;  ///< Before all that needs a context.
  MjDataPtr data_;       ///< Holds the posture that is drawn, no simulation.
  mjvScene scene_;       ///< Owned, freed by the destructor, as renderer_ is.
  mjvOption shown_;
  mjrContext renderer_;
  mjrRect viewport_;                  ///< The whole frame.
  std::vector<std::uint8_t> pixels_;  ///< 3 x width x height bytes.
};

}  // namespace sidestep::render
