// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// compare_maps: two maps of one sweep, cell by cell: which cells were won, which lost.

#include <cstddef>
#include <string>
#include <vector>

#include "sim/map/map_figures.h"
#include "sim/map/sweep_map.h"

namespace sidestep::map {

/// A cell that both maps have.
struct CellContest {
  std::string controller;
  std::string place;
  CellLimit first;
  CellLimit second;
  Contest contest{Contest::kNothing};
};

struct MapComparison {
  std::vector<CellContest> cells;  ///< In the first map's order.
  int won{0};                      ///< By the second: it survived all that the first lost at.
  int lost{0};
  int open{0};
  int unknown{0};
  std::size_t only_first{0};  ///< Cells that the other map has not.
  std::size_t only_second{0};
  std::vector<ControllerFigures> first;  ///< `worst` is not told.
  std::vector<ControllerFigures> second;
};

/// Compares cells of the same controller, panel and direction. If each map has one controller,
/// these are compared whatever they are called.
MapComparison CompareMaps(const SweepMap& first, const SweepMap& second);

/// A figure of both maps.
struct Quantity {
  std::string name;
  double first{0.0};
  double second{0.0};
};

/// `won`, `lost`, `undecided` and `alone` (cells of one map only), of which the first map has 0;
/// and `CONTROLLER.min`, `.mean`, `.area` of every controller that both have.
std::vector<Quantity> QuantitiesOf(const MapComparison& comparison);

/// For a terminal: figures per controller, every cell that was won or lost, the counts.
std::string ComparisonText(const MapComparison& comparison);

}  // namespace sidestep::map
