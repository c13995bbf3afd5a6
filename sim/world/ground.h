// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// ground: what a world's ground is made of where it is not level everywhere.
//
// In : WorldParams::ground, patches of other height than the rest, which is z = 0.
// Out: a plane at the lowest height of all, and slabs on it for whatever lies higher.
// Flow: scenario -> [ground] -> world_model (geoms), verdict (heights over the ground).

#include <Eigen/Core>
#include <vector>

#include "sim/scenario/world_params.h"

namespace sidestep {

/// A rectangle of the ground of one height, all in m, in W.
struct GroundSlab {
  double from_x_m;
  double to_x_m;
  double from_y_m;
  double to_y_m;
  double height_m;
};

/// Height of the ground at a place (m): 0 outside all patches; at an edge the
/// highest side's.
double GroundHeight_m(const std::vector<GroundPatch>& ground, const Eigen::Vector2d& place_W);

/// The lowest height anywhere (m): at most 0, where the plane lies.
double LowestGround_m(const std::vector<GroundPatch>& ground);

/// What lies above the lowest height, out to kGroundReach_m. No two slabs overlap, and those of one
/// height meet as seldom as strips across x that are joined where they match allow: a foot that
/// stands on a seam touches both. Empty for level ground. Precondition: patches do not overlap.
std::vector<GroundSlab> GroundSlabs(const std::vector<GroundPatch>& ground);

}  // namespace sidestep
