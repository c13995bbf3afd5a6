// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// start_pose: a posture to begin from, solved: knees bent, soles flat, CoM over their middle.

#include <array>
#include <string>

#include "models/import/body_plan.h"
#include "models/import/posture.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

struct StartPose {
  Posture posture;  ///< World: the middle between the soles at the origin, facing along x.
  double com_height_m{0.0};
  double step_width_m{0.0};      ///< Between the soles' middles.
  double leg_length_m{0.0};      ///< Hip to ankle (or to a foot that is a point), stretched.
  double stretch{0.0};           ///< The same at the start, over leg_length_m.
  double residual{0.0};          ///< Largest of all that was to be zero (m, rad).
  double least_margin_rad{0.0};  ///< Of the legs' joints to the ends of their ranges.
  std::string tightest_joint;    ///< Which has it.
  bool is_found{false};          ///< The residual is below 1e-6.
};

/// What the pose is made of.
struct StartPoseTask {
  std::array<int, 2> sole_frames{-1, -1};          ///< Links: left, right.
  std::array<double, 2> sole_heights_m{0.0, 0.0};  ///< Of these frames over the ground.
  double least_width_m{0.0};    ///< The soles' middles are no nearer to each other.
  double arm_spread_rad{0.15};  ///< How far the arms hang away from the body.
};

/// Fifteen equations for the legs' twelve joints and the root's place: both soles' poses (12), the
/// CoM's place over their middle (2), how far the legs are stretched (1); of six joints on points
/// nine, as there both places (6) stand for the poses. The root keeps the attitude that it has at
/// zero. Solved by damped Gauss-Newton within the joints' ranges, less a
/// margin, from a bent knee; where that fails, for other widths and other bends.
StartPose FindStartPose(const SourceRobot& robot, const BodyPlan& plan, const StartPoseTask& task);

}  // namespace sidestep::importer
