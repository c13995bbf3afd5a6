// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// feet: finds the soles, and gives them frames and, where a mesh did so before, shapes to stand on.

#include <Eigen/Core>
#include <array>
#include <string>

#include "models/import/body_plan.h"
#include "models/import/fit_sole.h"
#include "models/import/mesh_files.h"
#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// A flat sole or, of a leg that can't keep one flat, a ball that touches at a point.
struct Foot {
  Sole sole;                  ///< Of a ball its middle, with length and width 0.
  double ball_radius_m{0.0};  ///< 0: a sole.
  int frame{-1};              ///< Link without mass, at or near the sole's (or ball's) middle.
  int force_torque{-1};       ///< Link without mass, at the ankle: all of the foot is beyond it.
  std::string found_in;       ///< What the sole was fitted to.
  bool is_guessed{false};     ///< From the inertia: there was no shape to fit it to.
  Eigen::Matrix3Xd
      vertices_m;  ///< In the frame: corners a little inside the sole; a ball's middle.
};

/// Fits the soles, left first, adds their frames to the robot and replaces meshes that collide.
/// Of a plan that stands on points: as point_feet.h says. Throws ConfigError, naming `file`, if a
/// foot has no flat side of 3 cm by 2 cm or more.
std::array<Foot, 2> MakeFeet(const BodyPlan& plan, const std::string& file, MeshFiles* meshes,
                             SourceRobot* robot, Notes* notes);

}  // namespace sidestep::importer
