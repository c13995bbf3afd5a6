// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// fit_sole: the flat part of a foot that can stand on the ground, from points of its shapes.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace sidestep::importer {

/// A ball of a foot's surface: a corner or a mesh's vertex has no radius.
struct SurfacePoint {
  Eigen::Vector3d p_m{Eigen::Vector3d::Zero()};
  double radius_m{0.0};
};

/// A rectangle on the ground.
struct Sole {
  /// Of the rectangle's middle in the foot: x forward, z up.
  Eigen::Isometry3d X_FS{Eigen::Isometry3d::Identity()};
  double length_m{0.0};  ///< Along x.
  double width_m{0.0};   ///< Along y.
  double tilt_rad{0.0};  ///< Between z and the direction that was given as up.
};

/// The largest rectangle with sides along `forward` whose corners lie within the hull of the points
/// that touch a plane below the foot. The plane is across `up` if much of the foot lies flat on it;
/// else it is searched for up to 45 degrees from there.
/// @param points   In the foot's frame.
/// @param forward  In the foot's frame, of length 1; as `up`, at right angles to it.
/// @return         Length and width 0 where the points have no flat side below.
Sole FitSole(const std::vector<SurfacePoint>& points, const Eigen::Vector3d& forward,
             const Eigen::Vector3d& up);

}  // namespace sidestep::importer
