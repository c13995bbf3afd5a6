// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "sim/map/pictures.h"

namespace sidestep::map {
namespace {

constexpr double kGap = 22.0;
constexpr std::size_t kMostPolarColumns = 4;
constexpr std::size_t kMostPolars = 48;
constexpr std::size_t kMostDirections = 72;

/// Pictures below each other, and as wide as the widest.
class Sheet {
 public:
  void Below(const Drawing& picture) {
    all_.Place(picture, {kGap, y_});
    y_ += picture.height() + kGap;
  }
  /// In columns, row by row.
  void Table(const std::vector<Drawing>& pictures, std::size_t columns) {
    for (std::size_t i = 0; i < pictures.size(); i += columns) {
      double x = kGap, height = 0.0;
      for (std::size_t j = i; j < std::min(i + columns, pictures.size()); ++j) {
        all_.Place(pictures[j], {x, y_});
        x += pictures[j].width() + kGap;
        height = std::max(height, pictures[j].height());
      }
      y_ += height + kGap;
    }
  }
  Drawing Finish() const {
    Drawing sheet(all_.width() + kGap, y_);
    sheet.Place(all_, {0.0, 0.0});
    return sheet;
  }

 private:
  Drawing all_{0.0, 0.0};
  double y_{kGap};
};

std::string FiguresLine(const SweepMap& map, const ControllerFigures& figures) {
  std::string line = figures.controller + ": " + std::to_string(figures.recovered) + " of " +
                     std::to_string(figures.runs) + " runs recovered";
  if (map.has_limits) {
    line += "; limit min " + ShortFigure(figures.least) + ", mean " + ShortFigure(figures.mean) +
            " N s/kg";
    if (std::isfinite(map.omega_per_s)) {
      line += " (J\u03c9/mg " + ShortFigure(Dimensionless(map, figures.least)) + ", " +
              ShortFigure(Dimensionless(map, figures.mean)) + ")";
    }
    if (std::isfinite(figures.physical_share)) {
      line += "; " + ShortFigure(std::round(100.0 * figures.physical_share)) + " % of the pendulum";
    }
  }
  return line;
}

Drawing HeadPicture(const SweepMap& map) {
  constexpr double kLine = 20.0;
  const std::vector<ControllerFigures> all = FiguresOf(map);
  Drawing head(620.0, 30.0 + kLine * static_cast<double>(all.size()));
  head.Text({0.0, 10.0}, map.name + ": pushes survived", {18.0, Anchor::kStart, ink::kText, true});
  double y = 38.0;
  for (const ControllerFigures& figures : all) {
    head.Text({0.0, y}, FiguresLine(map, figures), {12.5, Anchor::kStart, ink::kText});
    y += kLine;
  }
  return head;
}

}  // namespace

// In one column, so that it fits a phone.
Drawing LegendPicture(const SweepMap& map) {
  constexpr double kLine = 21.0;
  constexpr double kWords = 36.0;  // where they begin
  Drawing legend(330.0, kLine * (map.has_limits ? 6.0 : 4.0));
  double y = 0.5 * kLine;
  const auto add = [&](const std::string& words) {
    legend.Text({kWords, y}, words, {12.5, Anchor::kStart, ink::kText});
    y += kLine;
  };
  DrawMark(Survival::kSurvived, {14.0, y}, 4.0, &legend);
  add("recovered");
  DrawMark(Survival::kLost, {14.0, y}, 4.0, &legend);
  add("lost");
  DrawMark(Survival::kInvalid, {14.0, y}, 4.0, &legend);
  add("INVALID: says nothing");
  if (map.has_limits) {
    legend.Line({{2.0, y}, {26.0, y}}, {ink::kNone, ink::kText, 5.0});
    for (const double x : {2.0, 26.0}) {
      legend.Line({{x, y - 7.0}, {x, y + 7.0}}, {ink::kNone, ink::kText, 1.6});
    }
    add("from the largest survived to the smallest lost");
    legend.Line({{5.0, y + 3.0}, {14.0, y - 3.0}, {23.0, y + 3.0}}, {ink::kNone, ink::kText, 1.8});
    add("nothing lost so far out");
  }
  legend.Line({{2.0, y}, {26.0, y}}, {ink::kNone, ink::kLimit, 2.0, true});
  add("a linear pendulum's limit (computed)");
  return legend;
}

bool IsPolar(const SweepMap& map) {
  return HasDirections(map) && map.directions.size() <= kMostDirections &&
         map.panels.size() * map.controllers.size() <= kMostPolars;
}

std::size_t PolarColumns(const SweepMap& map) {
  const std::size_t controllers = std::max<std::size_t>(1, map.controllers.size());
  return std::max(controllers, kMostPolarColumns / controllers * controllers);
}

Drawing SheetPicture(const SweepMap& map) {
  Sheet sheet;
  sheet.Below(HeadPicture(map));
  sheet.Below(LegendPicture(map));
  if (!IsPolar(map)) {
    sheet.Below(StripPicture(map));
    return sheet.Finish();
  }
  std::vector<Drawing> polars, heats;
  for (std::size_t panel = 0; panel < map.panels.size(); ++panel) {
    for (std::size_t i = 0; i < map.controllers.size(); ++i) {
      polars.push_back(PolarPicture(map, i, panel));
    }
  }
  for (std::size_t i = 0; i < map.controllers.size(); ++i) heats.push_back(HeatPicture(map, i));
  for (std::size_t i = 1; i < map.controllers.size(); ++i) {
    heats.push_back(DifferencePicture(map, i));
  }
  const std::size_t columns = PolarColumns(map);
  sheet.Table(polars, columns);
  const double width =
      static_cast<double>(std::min(columns, polars.size())) * (polars.front().width() + kGap);
  sheet.Table(heats, std::max<std::size_t>(
                         1, static_cast<std::size_t>(width / (heats.front().width() + kGap))));
  return sheet.Finish();
}

}  // namespace sidestep::map
