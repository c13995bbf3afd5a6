// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/map/pictures.h"

namespace sidestep::map {
namespace {

constexpr double kSide = 320.0;
constexpr double kTitle = 40.0;  // height of the lines above
constexpr double kRadius = 122.0;
constexpr double kMark = 3.4;
constexpr double kCap = 7.5;  // half the stroke that ends a bracket

/// Where things are in the picture.
struct Dial {
  double scale_Nspkg{1.0};
  Point centre{0.5 * kSide, kTitle + 0.5 * kSide};

  /// Ahead is up, left is left.
  Point At(double direction_rad, double impulse_Nspkg) const {
    const double r = kRadius * std::min(1.0, impulse_Nspkg / scale_Nspkg);
    return {centre.x - r * std::sin(direction_rad), centre.y - r * std::cos(direction_rad)};
  }
  /// So many pixels to the left of a direction's ray.
  static Point Beside(const Point& at, double direction_rad, double pixels) {
    return {at.x - pixels * std::cos(direction_rad), at.y + pixels * std::sin(direction_rad)};
  }
};

std::vector<const MapCell*> CellsOf(const SweepMap& map, std::size_t controller,
                                    std::size_t panel) {
  std::vector<const MapCell*> cells;
  for (const MapCell& cell : map.cells) {
    const bool is_here = cell.controller == controller && cell.panel == panel;
    if (is_here && cell.direction_rad) cells.push_back(&cell);
  }
  std::stable_sort(cells.begin(), cells.end(), [](const MapCell* a, const MapCell* b) {
    return *a->direction_rad < *b->direction_rad;
  });
  return cells;
}

// The pendulum's limit: around, a field with its edge; else a stroke across each direction.
void DrawPhysical(const Dial& dial, const std::vector<const MapCell*>& cells, Drawing* drawing) {
  std::vector<double> directions_rad;
  std::vector<Point> edge;
  for (const MapCell* cell : cells) {
    if (!std::isfinite(cell->physical_Nspkg)) continue;
    directions_rad.push_back(*cell->direction_rad);
    edge.push_back(dial.At(*cell->direction_rad, cell->physical_Nspkg));
  }
  const Paint line{ink::kNone, ink::kLimit, 1.6, true};
  if (GoAround(directions_rad)) {
    drawing->Polygon(edge, {ink::kLimitArea, ink::kLimit, 1.4, true});
    return;
  }
  constexpr double kHalf = 9.0;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const double dx = kHalf * std::cos(directions_rad[i]), dy = kHalf * std::sin(directions_rad[i]);
    drawing->Line({{edge[i].x - dx, edge[i].y + dy}, {edge[i].x + dx, edge[i].y - dy}}, line);
  }
}

void DrawRings(const Dial& dial, Drawing* drawing) {
  const double tick = TickFor(dial.scale_Nspkg);
  for (double ring = tick; ring <= 1.0001 * dial.scale_Nspkg; ring += tick) {
    drawing->Circle(dial.centre, kRadius * ring / dial.scale_Nspkg, {ink::kNone, ink::kGrid, 1.0});
  }
  const TextStyle side{11.5, Anchor::kMiddle, ink::kSoft};
  drawing->Text({dial.centre.x, dial.centre.y - kRadius - 12.0}, "ahead", side);
  drawing->Text({dial.centre.x, dial.centre.y + kRadius + 12.0}, "back", side);
  drawing->Text({4.0, dial.centre.y - kRadius + 4.0}, "left", {11.5, Anchor::kStart, ink::kSoft});
  drawing->Text({kSide - 4.0, dial.centre.y - kRadius + 4.0}, "right",
                {11.5, Anchor::kEnd, ink::kSoft});
}

// On top of all, between two directions of the usual 8 or 16.
void DrawRingFigures(const Dial& dial, Drawing* drawing) {
  constexpr double kBetween_rad = -0.2;
  const double tick = TickFor(dial.scale_Nspkg);
  for (double ring = tick; ring <= 1.0001 * dial.scale_Nspkg; ring += tick) {
    drawing->Text(dial.At(kBetween_rad, ring), ShortFigure(ring),
                  {10.5, Anchor::kMiddle, ink::kSoft});
  }
}

// From the largest that survived to the smallest that was lost; open outwards if nothing was.
void DrawBracket(const Dial& dial, const MapCell& cell, Drawing* drawing) {
  const CellLimit limit = LimitOf(cell);
  if (std::isnan(limit.share)) return;
  const double direction_rad = *cell.direction_rad;
  const Point from = dial.At(direction_rad, limit.survived);
  if (std::isfinite(limit.lost)) {
    const Point to = dial.At(direction_rad, limit.lost);
    drawing->Line({from, to}, {ink::kNone, ink::kText, 5.0});
    // Strokes at both ends, seen even if the bar is shorter than the marks.
    for (const double end : {limit.survived, limit.lost}) {
      if (end <= 0.0) continue;
      const Point at = dial.At(direction_rad, end);
      drawing->Line({dial.Beside(at, direction_rad, -kCap), dial.Beside(at, direction_rad, kCap)},
                    {ink::kNone, ink::kText, 1.6});
    }
    return;
  }
  constexpr double kBeyond = 0.07;  // of the scale
  constexpr double kSpread_rad = 0.09;
  const double beyond = limit.survived + kBeyond * dial.scale_Nspkg;
  const double r = beyond / dial.scale_Nspkg * kRadius;
  const Point tip{dial.centre.x - r * std::sin(direction_rad),
                  dial.centre.y - r * std::cos(direction_rad)};
  drawing->Line({dial.At(direction_rad - kSpread_rad, limit.survived), tip,
                 dial.At(direction_rad + kSpread_rad, limit.survived)},
                {ink::kNone, ink::kText, 1.8});
}

}  // namespace

Drawing PolarPicture(const SweepMap& map, std::size_t controller, std::size_t panel) {
  Drawing drawing(kSide, kTitle + kSide);
  Dial dial;
  dial.scale_Nspkg = Scale_Nspkg(map);
  const std::vector<const MapCell*> cells = CellsOf(map, controller, panel);
  drawing.Text({0.5 * kSide, 11.0}, map.controllers[controller],
               {14.0, Anchor::kMiddle, ink::kText, true});
  drawing.Text({0.5 * kSide, 29.0}, map.panels[panel], {12.0, Anchor::kMiddle, ink::kSoft});
  DrawPhysical(dial, cells, &drawing);
  DrawRings(dial, &drawing);
  for (const MapCell* cell : cells) {
    const auto number = static_cast<std::size_t>(cell - map.cells.data());
    drawing.SetLink(CellAnchor(number), PlaceWords(map, *cell) + ": " + LimitWords(map, *cell));
    drawing.Line({dial.centre, dial.At(*cell->direction_rad, dial.scale_Nspkg)},
                 {ink::kNone, ink::kGrid, 1.0});
    if (map.has_limits) DrawBracket(dial, *cell, &drawing);
    for (const MapPoint& point : cell->points) {
      DrawMark(point.survival(), dial.At(*cell->direction_rad, point.impulse_Nspkg), kMark,
               &drawing);
    }
  }
  drawing.SetLink("", "");
  DrawRingFigures(dial, &drawing);
  return drawing;
}

}  // namespace sidestep::map
