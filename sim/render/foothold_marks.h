// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// foothold_marks: nominal footholds as grey outlines, adjusted ones as coloured plates on the
// floor.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "sim/record/run_reader.h"
#include "sim/render/decoration.h"

namespace sidestep::render {

/// A foot's sole, for its marks.
struct Sole {
  std::string foot;
  Eigen::Vector2d lower_m{Eigen::Vector2d::Zero()};  ///< Corners of its rectangle, in F; equal
  Eigen::Vector2d upper_m{Eigen::Vector2d::Zero()};  ///< for a point foot.
  double height_m{0.0};                              ///< F above the ground in stance.
};

/// Marks to draw at row.time_s: of every contact that ended in the last `memory_s` or still
/// lasts, and of each foot's current or next one. Past contacts fade. A foothold that was moved
/// gets a line from its nominal place. Soles have the yaw of their contact among the footsteps, or
/// lie along x where there is none.
///
/// @param feet   Names of the feet in the order of row.feet.
/// @param soles  One per foot, in any order; a foot without one is drawn as a point.
std::vector<Decoration> FootholdMarks(const StateRow& row, const std::vector<std::string>& feet,
                                      const std::vector<Footstep>& footsteps,
                                      const std::vector<Sole>& soles, double memory_s,
                                      const DrawScale& scale);

}  // namespace sidestep::render
