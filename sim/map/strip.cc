// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "sim/map/pictures.h"

namespace sidestep::map {
namespace {

constexpr double kLineHeight = 24.0;
constexpr double kWidth = 420.0;  // of the scale
constexpr double kStripTop = 30.0;
constexpr double kNameLetter = 7.2;  // a letter's width at 12 px, rather too much
constexpr std::size_t kMostLetters = 60;
constexpr double kStripMark = 4.0;

std::string NameOf(const SweepMap& map, const MapCell& cell) {
  const std::string place = PlaceWords(map, cell);
  std::string name = map.controllers[cell.controller] + (place.empty() ? "" : ": ") + place;
  if (name.size() > kMostLetters) name = name.substr(0, kMostLetters);
  return name;
}

void DrawScale(double scale, double margin, double bottom, Drawing* drawing) {
  const double tick = TickFor(scale);
  for (double at = 0.0; at <= 1.0001 * scale; at += tick) {
    const double x = margin + kWidth * at / scale;
    drawing->Line({{x, kStripTop - 8.0}, {x, bottom}}, {ink::kNone, ink::kGrid, 1.0});
    drawing->Text({x, 12.0}, ShortFigure(at) + (at == 0.0 ? " N s/kg" : ""),
                  {11.5, at == 0.0 ? Anchor::kStart : Anchor::kMiddle, ink::kSoft});
  }
}

// From the largest that survived to the smallest that was lost; open to the right if nothing was.
void DrawStripBracket(const CellLimit& limit, double from, double to, double y, Drawing* drawing) {
  if (std::isnan(limit.share)) return;
  if (std::isfinite(limit.lost)) {
    drawing->Line({{from, y}, {to, y}}, {ink::kNone, ink::kText, 5.0});
    return;
  }
  drawing->Line({{from + 5.0, y - 5.0}, {from + 11.0, y}, {from + 5.0, y + 5.0}},
                {ink::kNone, ink::kText, 1.8});
}

void DrawCell(const SweepMap& map, const MapCell& cell, double scale, double margin, double y,
              Drawing* drawing) {
  const auto x = [&](double impulse) { return margin + kWidth * std::min(1.0, impulse / scale); };
  if (std::isfinite(cell.physical_Nspkg)) {
    const double at = x(cell.physical_Nspkg);
    drawing->Line({{at, y - 9.0}, {at, y + 9.0}}, {ink::kNone, ink::kLimit, 2.0, true});
  }
  const CellLimit limit = LimitOf(cell);
  if (map.has_limits) DrawStripBracket(limit, x(limit.survived), x(limit.lost), y, drawing);
  for (const MapPoint& point : cell.points) {
    DrawMark(point.survival(), {x(point.impulse_Nspkg), y}, kStripMark, drawing);
  }
}

}  // namespace

Drawing StripPicture(const SweepMap& map) {
  const std::size_t shown = std::min(kMostStrips, map.cells.size());
  double letters = 0.0;
  for (std::size_t i = 0; i < shown; ++i) {
    letters = std::max(letters, static_cast<double>(NameOf(map, map.cells[i]).size()));
  }
  const double margin = kNameLetter * letters + 16.0;
  const double bottom = kStripTop + kLineHeight * static_cast<double>(shown);
  Drawing drawing(margin + kWidth + 40.0, bottom + 24.0);
  const double scale = Scale_Nspkg(map);
  DrawScale(scale, margin, bottom, &drawing);
  for (std::size_t i = 0; i < shown; ++i) {
    const MapCell& cell = map.cells[i];
    const double y = kStripTop + kLineHeight * (static_cast<double>(i) + 0.5);
    drawing.SetLink(CellAnchor(i), LimitWords(map, cell));
    drawing.Text({margin - 10.0, y}, NameOf(map, cell), {12.0, Anchor::kEnd, ink::kText});
    DrawCell(map, cell, scale, margin, y, &drawing);
  }
  drawing.SetLink("", "");
  if (shown < map.cells.size()) {
    drawing.Text({margin, bottom + 12.0},
                 "and " + std::to_string(map.cells.size() - shown) + " more in rays.csv",
                 {12.0, Anchor::kStart, ink::kSoft});
  }
  return drawing;
}

}  // namespace sidestep::map
