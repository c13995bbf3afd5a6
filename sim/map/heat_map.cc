// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "sim/map/pictures.h"
#include "sim/sweep/axis.h"

namespace sidestep::map {
namespace {

constexpr double kCellWidth = 60.0;
constexpr double kCellHeight = 38.0;
constexpr double kTop = 46.0;    // title, directions
constexpr double kLetter = 7.2;  // a letter's width at 12 px, rather too much
constexpr double kNarrowest = 70.0;
constexpr double kRounding = 1e-9;  // N s/kg: of strengths that were halved to on both sides

/// What stands in a cell.
struct Field {
  std::string color;
  std::string figure;
  std::string below;
  bool is_bold{false};
};

using FieldOf = std::function<Field(const MapCell& first)>;

double MarginOf(const SweepMap& map) {
  double letters = 0.0;
  for (const std::string& panel : map.panels) {
    letters = std::max(letters, static_cast<double>(panel.size()));
  }
  return std::max(kNarrowest, kLetter * letters + 12.0);
}

std::string DirectionLabel(const std::string& direction) {
  const std::optional<double> angle_rad = ParseNumber(direction);
  if (!angle_rad) return direction;
  return ShortFigure(std::round(1800.0 * *angle_rad / std::numbers::pi) / 10.0) + "\u00b0";
}

void DrawField(const Field& field, const Point& corner, Drawing* drawing) {
  drawing->Rectangle(corner, kCellWidth - 2.0, kCellHeight - 2.0, {field.color, ink::kGrid, 1.0});
  const std::string color = ReadableOn(field.color);
  const bool has_below = !field.below.empty();
  const Point middle{corner.x + 0.5 * kCellWidth - 1.0, corner.y + 0.5 * kCellHeight - 1.0};
  drawing->Text({middle.x, middle.y - (has_below ? 7.0 : 0.0)}, field.figure,
                {13.0, Anchor::kMiddle, color, field.is_bold});
  if (has_below) {
    drawing->Text({middle.x, middle.y + 8.0}, field.below, {10.5, Anchor::kMiddle, color});
  }
}

// A table of panels by directions of the cells of `controller`.
Drawing Grid(const SweepMap& map, std::size_t controller, const std::string& title,
             const FieldOf& field_of) {
  const double margin = MarginOf(map);
  const auto columns = static_cast<double>(map.directions.size());
  const auto rows = static_cast<double>(map.panels.size());
  Drawing drawing(margin + kCellWidth * columns + 4.0, kTop + kCellHeight * rows + 6.0);
  drawing.Text({0.0, 11.0}, title, {14.0, Anchor::kStart, ink::kText, true});
  for (std::size_t i = 0; i < map.directions.size(); ++i) {
    drawing.Text({margin + kCellWidth * (static_cast<double>(i) + 0.5), 34.0},
                 DirectionLabel(map.directions[i]), {11.5, Anchor::kMiddle, ink::kSoft});
  }
  for (std::size_t i = 0; i < map.panels.size(); ++i) {
    drawing.Text({margin - 8.0, kTop + kCellHeight * (static_cast<double>(i) + 0.5)},
                 map.panels[i].empty() ? "all" : map.panels[i], {12.0, Anchor::kEnd, ink::kText});
  }
  for (const MapCell& cell : map.cells) {
    if (cell.controller != controller) continue;
    const auto column = std::find(map.directions.begin(), map.directions.end(), cell.direction) -
                        map.directions.begin();
    const Point corner{margin + kCellWidth * static_cast<double>(column),
                       kTop + kCellHeight * static_cast<double>(cell.panel)};
    const Field field = field_of(cell);
    drawing.SetLink(CellAnchor(static_cast<std::size_t>(&cell - map.cells.data())),
                    PlaceWords(map, cell) + ": " + LimitWords(map, cell));
    DrawField(field, corner, &drawing);
  }
  drawing.SetLink("", "");
  return drawing;
}

// `>` before what was not lost at all.
std::string FigureOf(const SweepMap& map, const MapCell& cell) {
  const CellLimit limit = LimitOf(cell);
  if (std::isnan(limit.share)) return "INVALID";
  if (!map.has_limits) return ShortFigure(100.0 * limit.share) + " %";
  return (std::isinf(limit.lost) ? ">" : "") + ShortFigure(limit.survived);
}

std::string Signed(double value) { return (value > 0.0 ? "+" : "") + ShortFigure(value); }

}  // namespace

Drawing HeatPicture(const SweepMap& map, std::size_t controller) {
  double most = 0.0;
  for (const MapCell& cell : map.cells) {
    const double value = ValueOf(map, cell);
    if (std::isfinite(value)) most = std::max(most, value);
  }
  const std::string what = map.has_limits
                               ? ": survived (N s/kg), and its share of the pendulum's limit"
                               : ": recovered runs";
  return Grid(map, controller, map.controllers[controller] + what, [&](const MapCell& cell) {
    const double value = ValueOf(map, cell);
    Field field{SequentialColor(most > 0.0 ? value / most : value), FigureOf(map, cell), "", false};
    const double share = value / cell.physical_Nspkg;
    if (map.has_limits && cell.physical_Nspkg > 0.0 && std::isfinite(share)) {
      field.below = ShortFigure(std::round(100.0 * share)) + " %";
    }
    return field;
  });
}

Drawing DifferencePicture(const SweepMap& map, std::size_t other) {
  double most = 0.0;
  const auto difference = [&](const MapCell& first) {
    const MapCell* second = FindCell(map, other, first.panel, first.direction);
    if (second == nullptr) return kUnknown;
    const double gap = ValueOf(map, first) - ValueOf(map, *second);
    return std::abs(gap) < kRounding ? 0.0 : gap;
  };
  for (const MapCell& cell : map.cells) {
    const double value = cell.controller == 0 ? difference(cell) : kUnknown;
    if (std::isfinite(value)) most = std::max(most, std::abs(value));
  }
  const std::string title = map.controllers[0] + " less " + map.controllers[other] +
                            (map.has_limits ? " (N s/kg)" : " (share)");
  return Grid(map, 0, title, [&](const MapCell& first) {
    const double value = difference(first);
    Field field{DivergingColor(most > 0.0 ? value / most : value), "-", "", false};
    const MapCell* second = FindCell(map, other, first.panel, first.direction);
    const Contest contest = second ? Compare(map, first, *second) : Contest::kNothing;
    if (contest == Contest::kNothing) return field;
    field.is_bold = contest != Contest::kOpen;
    field.figure = field.is_bold ? Signed(value) : "(" + Signed(value) + ")";
    return field;
  });
}

}  // namespace sidestep::map
