// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// pictures: the parts of a map's picture. Pure functions; polar.cc, heat_map.cc, strip.cc,
// map_scale.cc and map_sheet.cc hold them.
//
// What came of a tested strength is told by its mark's shape first, by its colour second: a disc
// recovered, a cross was lost, a triangle is INVALID. Brackets are bars, and no line joins them.

#include <string>

#include "sim/map/drawing.h"
#include "sim/map/map_figures.h"
#include "sim/map/sweep_map.h"

namespace sidestep::map {

/// The anchor in the page of a cell, by its number in the map.
std::string CellAnchor(std::size_t number);

/// `0.425`, `-` if it is not known, `>0.8` of nothing.
std::string ShortFigure(double value);
/// A cell's limit in words: `[0.4, 0.5)`, `not lost up to 0.8`.
std::string LimitWords(const SweepMap& map, const MapCell& cell);

/// A cell's place in words: panel and direction.
std::string PlaceWords(const SweepMap& map, const MapCell& cell);

/// A round distance of rings or ticks, such that up to five of them reach `most`.
double TickFor(double most);

/// The greatest impulse that a picture of the map shows (N s/kg, above 0): all that was tested, and
/// of the pendulum's limits what lies within twice that.
double Scale_Nspkg(const SweepMap& map);

/// A mark of what came of a strength.
void DrawMark(Survival survival, Point at, double radius, Drawing* drawing);

/// Colours of a number from 0 to 1, and of one from -1 to 1; and which of black and white reads on
/// them.
std::string SequentialColor(double share);
std::string DivergingColor(double share);
std::string ReadableOn(const std::string& color);

/// One panel of one controller: impulse over direction, ahead upwards.
Drawing PolarPicture(const SweepMap& map, std::size_t controller, std::size_t panel);

/// Panel by direction, the figure in each cell, and what share of the pendulum's limit it is.
Drawing HeatPicture(const SweepMap& map, std::size_t controller);

/// The first controller's limits less those of the `other`-th; in brackets where the brackets
/// overlap.
Drawing DifferencePicture(const SweepMap& map, std::size_t other);

/// A line a cell with its tested strengths, of maps without directions; at most so many.
inline constexpr std::size_t kMostStrips = 60;
Drawing StripPicture(const SweepMap& map);

/// What the marks mean.
Drawing LegendPicture(const SweepMap& map);

/// Whether polar and heat maps are for this map; else a strip is.
bool IsPolar(const SweepMap& map);

/// How many polar maps stand side by side: all controllers, up to four maps.
std::size_t PolarColumns(const SweepMap& map);

/// All of it on one sheet.
Drawing SheetPicture(const SweepMap& map);

}  // namespace sidestep::map
