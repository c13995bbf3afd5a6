// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "sim/map/pictures.h"
#include "sim/palette/palette.h"

namespace sidestep::map {
namespace {

// The colour that lies at `share` of the way between two of the palette's.
std::string Between(const char* from, const char* to, double share) {
  const std::array<float, 3> start = palette::Channels(from), end = palette::Channels(to);
  std::string hex = "#";
  for (std::size_t i = 0; i < start.size(); ++i) {
    const double first = start[i], last = end[i], channel = first + share * (last - first);
    char byte[3];
    std::snprintf(byte, sizeof byte, "%02X",
                  static_cast<unsigned>(std::lround(255.0 * channel)) & 0xFFU);
    hex += byte;
  }
  return hex;
}

}  // namespace

std::string CellAnchor(std::size_t number) { return "cell-" + std::to_string(number); }

std::string ShortFigure(double value) {
  if (std::isnan(value)) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string LimitWords(const SweepMap& map, const MapCell& cell) {
  const CellLimit limit = LimitOf(cell);
  if (std::isnan(limit.share)) return "INVALID";
  if (!map.has_limits) return ShortFigure(100.0 * limit.share) + " % recovered";
  if (std::isinf(limit.lost)) return "not lost up to " + ShortFigure(limit.survived) + " N s/kg";
  return "survived " + ShortFigure(limit.survived) + ", lost at " + ShortFigure(limit.lost) +
         " N s/kg";
}

std::string PlaceWords(const SweepMap& map, const MapCell& cell) {
  std::string words = map.panels[cell.panel];
  if (!cell.direction.empty()) {
    words += words.empty() ? "" : ", ";
    words += cell.direction_rad
                 ? ShortFigure(*cell.direction_rad * 180.0 / std::numbers::pi) + " deg"
                 : cell.direction;
  }
  return words;
}

double TickFor(double most) {
  constexpr double kMostTicks = 5.0;
  if (!(most > 0.0) || !std::isfinite(most)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(most)) - 1.0);
  double tick = decade;
  for (const double step : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    tick = step * decade;
    if (most / tick <= kMostTicks) break;
  }
  return tick;
}

double Scale_Nspkg(const SweepMap& map) {
  constexpr double kFarthest = 2.0;
  double tested = 0.0, physical = 0.0;
  for (const MapCell& cell : map.cells) {
    for (const MapPoint& point : cell.points) tested = std::max(tested, point.impulse_Nspkg);
    if (std::isfinite(cell.physical_Nspkg)) physical = std::max(physical, cell.physical_Nspkg);
  }
  if (tested <= 0.0) return 1.0;
  return std::max(tested, std::min(physical, kFarthest * tested));
}

void DrawMark(Survival survival, Point at, double radius, Drawing* drawing) {
  const double x = at.x, y = at.y, r = radius;
  switch (survival) {
    case Survival::kSurvived:
      drawing->Circle(at, r, {ink::kRecovered, ink::kNone});
      return;
    case Survival::kLost:
      drawing->Line({{x - r, y - r}, {x + r, y + r}}, {ink::kNone, ink::kLost, 2.0});
      drawing->Line({{x - r, y + r}, {x + r, y - r}}, {ink::kNone, ink::kLost, 2.0});
      return;
    case Survival::kInvalid:
    case Survival::kUnknown:
      drawing->Polygon({{x, y - 1.3 * r}, {x + 1.2 * r, y + r}, {x - 1.2 * r, y + r}},
                       {ink::kNone, ink::kInvalid, 1.4});
  }
}

std::string SequentialColor(double share) {
  if (std::isnan(share)) return ink::kGrid;
  return Between(palette::kScaleNone, palette::kScaleMost, std::clamp(share, 0.0, 1.0));
}

std::string DivergingColor(double share) {
  if (std::isnan(share)) return ink::kGrid;
  return Between(palette::kScaleNone, share < 0.0 ? palette::kScaleOpposite : palette::kScaleMost,
                 std::clamp(std::abs(share), 0.0, 1.0));
}

std::string ReadableOn(const std::string& color) {
  if (color.size() != 7 || color[0] != '#') return ink::kText;
  const auto channel = [&](std::size_t at) {
    return static_cast<double>(std::stoi(color.substr(at, 2), nullptr, 16)) / 255.0;
  };
  // Relative luminance of sRGB with its gamma taken as 2.2 (WCAG 2); where both contrasts are even.
  constexpr double kEven = 0.18;
  const double luminance = 0.2126 * std::pow(channel(1), 2.2) + 0.7152 * std::pow(channel(3), 2.2) +
                           0.0722 * std::pow(channel(5), 2.2);
  return luminance > kEven ? palette::kGround.dark : palette::kCard.light;
}

}  // namespace sidestep::map
