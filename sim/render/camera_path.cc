// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/camera_path.h"

#include <algorithm>

#include "models/support/require.h"

namespace sidestep::render {
namespace {

// Chosen by eye. From the front and the robot's right: it comes towards the viewer, and both a
// sideways and a forward push show their length.
struct Direction {
  double azimuth_deg;
  double elevation_deg;
};
constexpr Direction kQuarterView{145.0, -17.0};
constexpr Direction kSideView{90.0, -8.0};    // looks along y: forward is to the right
constexpr Direction kFrontView{180.0, -8.0};  // it comes towards the viewer
constexpr Direction kAboveView{90.0, -89.0};  // as the plot from above: forward to the right
constexpr double kDistancePerComHeight = 4.1;
constexpr double kLookAtPerComHeight = 1.05;
constexpr double kSmoothing_s = 0.6;  // half the averaging window
constexpr double kTypicalAspect = 4.0 / 3.0;
constexpr double kFixedMargin = 1.1;  // metres of path to metres of distance

Direction DirectionOf(CameraView view) {
  switch (view) {
    case CameraView::kSide:
      return kSideView;
    case CameraView::kFront:
      return kFrontView;
    case CameraView::kAbove:
      return kAboveView;
    case CameraView::kQuarter:
      break;
  }
  return kQuarterView;
}

}  // namespace

CameraPose CameraAt(VideoCamera kind, const std::vector<Eigen::Vector3d>& p_WC, double dt_s,
                    std::size_t row, double com_height_m, double aspect, CameraView view) {
  SIDESTEP_REQUIRE(row < p_WC.size(), row);
  CameraPose camera;
  const Direction direction = DirectionOf(view);
  camera.azimuth_deg = direction.azimuth_deg;
  camera.elevation_deg = direction.elevation_deg;
  camera.distance_m = kDistancePerComHeight * com_height_m * std::max(1.0, kTypicalAspect / aspect);
  if (kind == VideoCamera::kFixed) {
    Eigen::Vector3d lower = p_WC.front();
    Eigen::Vector3d upper = p_WC.front();
    for (const Eigen::Vector3d& p : p_WC) {
      lower = lower.cwiseMin(p);
      upper = upper.cwiseMax(p);
    }
    camera.look_at_W = 0.5 * (lower + upper);
    camera.distance_m += kFixedMargin * (upper - lower).head<2>().norm();
  } else {
    const auto reach = static_cast<std::size_t>(kSmoothing_s / dt_s);
    // Shrinks alike on both sides near the log's ends, so that the average is of now.
    const std::size_t half = std::min({reach, row, p_WC.size() - 1 - row});
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = row - half; i <= row + half; ++i) sum += p_WC[i];
    camera.look_at_W = sum / static_cast<double>(2 * half + 1);
  }
  camera.look_at_W.z() = kLookAtPerComHeight * com_height_m;
  return camera;
}

}  // namespace sidestep::render
