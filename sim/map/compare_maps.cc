// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/compare_maps.h"

#include <cmath>
#include <map>
#include <tuple>

#include "sim/map/pictures.h"

namespace sidestep::map {
namespace {

// Controller, panel and direction; of maps with one controller each its name is no matter.
using PlaceName = std::tuple<std::string, std::string, std::string>;

PlaceName NameOfPlace(const SweepMap& map, const MapCell& cell, bool is_single) {
  return {is_single ? "" : map.controllers[cell.controller], map.panel_keys[cell.panel],
          cell.direction};
}

std::vector<ControllerFigures> FiguresWithoutCells(const SweepMap& map) {
  std::vector<ControllerFigures> all = FiguresOf(map);
  for (ControllerFigures& one : all) one.worst = nullptr;
  return all;
}

void Count(Contest contest, MapComparison* comparison) {
  switch (contest) {
    case Contest::kFirst:
      ++comparison->lost;
      return;
    case Contest::kSecond:
      ++comparison->won;
      return;
    case Contest::kOpen:
      ++comparison->open;
      return;
    case Contest::kNothing:
      ++comparison->unknown;
  }
}

std::string BracketText(const CellLimit& limit) {
  if (std::isnan(limit.share)) return "INVALID";
  return "[" + ShortFigure(limit.survived) + ", " + ShortFigure(limit.lost) + ") " +
         ShortFigure(100.0 * limit.share) + " %";
}

std::string NumbersLine(const char* name, const ControllerFigures& figures) {
  return std::string(name) + " " + figures.controller + ": " + std::to_string(figures.recovered) +
         " of " + std::to_string(figures.runs) + " runs recovered, min " +
         ShortFigure(figures.least) + ", mean " + ShortFigure(figures.mean) + ", area " +
         ShortFigure(figures.area) + "\n";
}

}  // namespace

MapComparison CompareMaps(const SweepMap& first, const SweepMap& second) {
  MapComparison comparison;
  comparison.first = FiguresWithoutCells(first);
  comparison.second = FiguresWithoutCells(second);
  SweepMap with_limits;  // what Compare() asks of a map
  with_limits.has_limits = first.has_limits && second.has_limits;
  const bool is_single = first.controllers.size() == 1 && second.controllers.size() == 1;
  std::map<PlaceName, const MapCell*> counterparts;
  for (const MapCell& cell : second.cells) {
    counterparts.emplace(NameOfPlace(second, cell, is_single), &cell);
  }
  for (const MapCell& cell : first.cells) {
    const auto found = counterparts.find(NameOfPlace(first, cell, is_single));
    if (found == counterparts.end()) {
      ++comparison.only_first;
      continue;
    }
    const MapCell* other = found->second;
    const Contest contest = Compare(with_limits, cell, *other);
    comparison.cells.push_back({first.controllers[cell.controller], PlaceWords(first, cell),
                                LimitOf(cell), LimitOf(*other), contest});
    Count(contest, &comparison);
  }
  comparison.only_second = second.cells.size() - comparison.cells.size();
  return comparison;
}

std::vector<Quantity> QuantitiesOf(const MapComparison& comparison) {
  const auto alone = static_cast<double>(comparison.only_first + comparison.only_second);
  std::vector<Quantity> all{{"won", 0.0, static_cast<double>(comparison.won)},
                            {"lost", 0.0, static_cast<double>(comparison.lost)},
                            {"undecided", 0.0, static_cast<double>(comparison.open)},
                            {"alone", 0.0, alone}};
  const bool is_single = comparison.first.size() == 1 && comparison.second.size() == 1;
  for (const ControllerFigures& a : comparison.first) {
    for (const ControllerFigures& b : comparison.second) {
      if (!is_single && a.controller != b.controller) continue;
      all.push_back({a.controller + ".min", a.least, b.least});
      all.push_back({a.controller + ".mean", a.mean, b.mean});
      all.push_back({a.controller + ".area", a.area, b.area});
    }
  }
  return all;
}

std::string ComparisonText(const MapComparison& comparison) {
  std::string text;
  for (const ControllerFigures& one : comparison.first) text += NumbersLine("A", one);
  for (const ControllerFigures& one : comparison.second) text += NumbersLine("B", one);
  for (const CellContest& cell : comparison.cells) {
    if (cell.contest != Contest::kFirst && cell.contest != Contest::kSecond) continue;
    text += std::string(cell.contest == Contest::kSecond ? "  won   " : "  lost  ") +
            cell.controller + (cell.place.empty() ? "" : ", " + cell.place) + ": " +
            BracketText(cell.first) + " -> " + BracketText(cell.second) + "\n";
  }
  text += "B against A: " + std::to_string(comparison.won) + " cells won, " +
          std::to_string(comparison.lost) + " lost, " + std::to_string(comparison.open) +
          " undecided";
  if (comparison.unknown > 0) text += ", " + std::to_string(comparison.unknown) + " INVALID";
  const std::size_t alone = comparison.only_first + comparison.only_second;
  if (alone > 0) text += "; " + std::to_string(alone) + " cells are in one map only";
  return text + "\n";
}

}  // namespace sidestep::map
