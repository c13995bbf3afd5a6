// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// camera_path: where the camera looks.
//
// The follow camera looks at the CoM's horizontal position averaged over a window centred on now,
// at a fixed height: it glides with the robot, shows its sway, and needs no state, so that any
// process can draw any frame.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "sim/render/render_options.h"
#include "sim/scenario/scenario.h"

namespace sidestep::render {

/// A camera that orbits a point, as MuJoCo's free camera.
struct CameraPose {
  Eigen::Vector3d look_at_W{Eigen::Vector3d::Zero()};
  double distance_m{2.0};
  double azimuth_deg{0.0};    ///< Viewing direction about z, from x.
  double elevation_deg{0.0};  ///< Negative looks down.
};

/// The camera at row `row`.
/// @param p_WC    CoM of every row (m).
/// @param dt_s    Time between rows.
/// @param aspect  Width by height; a narrow frame steps back.
CameraPose CameraAt(VideoCamera kind, const std::vector<Eigen::Vector3d>& p_WC, double dt_s,
                    std::size_t row, double com_height_m, double aspect,
                    CameraView view = CameraView::kQuarter);

}  // namespace sidestep::render
