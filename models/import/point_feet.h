// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// point_feet: feet of legs that can only put a point where they like: each touches with a ball.

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "models/import/feet.h"

namespace sidestep::importer {

/// What touches the ground of a foot that is a point.
struct Ball {
  Eigen::Vector3d p_m{Eigen::Vector3d::Zero()};  ///< Its middle, in the foot's frame.
  double radius_m{0.0};
};

/// The ball at the lower end of a foot: where a sphere or a capsule is the lowest of the points,
/// that one; else the ball that touches the lowest point and is as wide as the foot at the height
/// of the ball's middle.
/// @param points  In the foot's frame; at least one.
/// @param up      In the foot's frame, of length 1, up where all joints are at zero.
Ball FitBall(const std::vector<SurfacePoint>& points, const Eigen::Vector3d& up);

/// Left first. Gives each foot a frame at the middle of its ball and, where meshes or corners
/// touched before, the ball and a capsule up to the last joint instead. Throws ConfigError, naming
/// `file`, if a foot has no shape that can be read, or a flat sole, which three joints can't keep
/// level.
std::array<Foot, 2> MakePointFeet(const BodyPlan& plan, const std::string& file, MeshFiles* meshes,
                                  SourceRobot* robot, Notes* notes);

}  // namespace sidestep::importer
