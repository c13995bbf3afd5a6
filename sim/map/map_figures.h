// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// map_figures: what a map comes to in a few numbers.

#include <cstddef>
#include <string>
#include <vector>

#include "sim/map/sweep_map.h"

namespace sidestep::map {

/// One controller's, over its cells that say something. Limits are their lower ends, what survived;
/// NaN where there is nothing to tell.
struct ControllerFigures {
  std::string controller;
  int cells{0};
  int runs{0};
  int recovered{0};
  int lost{0};
  int invalid{0};
  double least{kUnknown};  ///< ValueOf(): N s/kg, or a share.
  double mean{kUnknown};
  double most{kUnknown};
  const MapCell* worst{nullptr};  ///< The first that has the least.
  /// Mean over the panels of the area that the limits enclose in the polar plane, ((N s/kg)^2):
  /// each direction stands for its sector, half way to both neighbours. NaN unless the directions
  /// of every panel go around.
  double area{kUnknown};
  /// Mean of limit over the pendulum's, of the cells that have both.
  double physical_share{kUnknown};
};

/// In the order of SweepMap::controllers. `worst` points into `map`.
std::vector<ControllerFigures> FiguresOf(const SweepMap& map);

/// J / m as J omega / (m g), in which small and tall robots compare; NaN without omega.
double Dimensionless(const SweepMap& map, double impulse_Nspkg);

/// Whether these directions (rad) go around: four or more with no gap beyond a third of a turn.
bool GoAround(std::vector<double> directions_rad);

/// Area of sectors in the polar plane: sum of r^2 / 2 times the width of each; of {angle, r} in any
/// order. NaN unless they go around.
double SectorArea(std::vector<std::pair<double, double>> rays);

/// How two cells of one place compare.
enum class Contest {
  kFirst,   ///< The first survived all that the second was lost at.
  kSecond,  ///< The other way round.
  kOpen,    ///< Their brackets overlap: nothing tells.
  kNothing  ///< One of them says nothing.
};
Contest Compare(const SweepMap& map, const MapCell& first, const MapCell& second);

}  // namespace sidestep::map
