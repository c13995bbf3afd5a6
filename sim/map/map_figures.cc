// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/map_figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/support/gravity.h"

namespace sidestep::map {
namespace {

constexpr double kTurn_rad = 2.0 * std::numbers::pi;

/// A mean that grows; NaN of nothing.
struct Mean {
  double sum{0.0};
  int count{0};

  void Add(double value) {
    if (!std::isfinite(value)) return;
    sum += value;
    ++count;
  }
  double value() const { return count > 0 ? sum / count : kUnknown; }
};

double WithinTurn(double angle_rad) {
  const double rest = std::fmod(angle_rad, kTurn_rad);
  return rest < 0.0 ? rest + kTurn_rad : rest;
}

// Of rising angles within a turn: from each to the next, the last to the first.
std::vector<double> GapsOf(const std::vector<double>& angles_rad) {
  std::vector<double> gaps;
  for (std::size_t i = 0; i < angles_rad.size(); ++i) {
    const bool is_last = i + 1 == angles_rad.size();
    gaps.push_back((is_last ? angles_rad.front() + kTurn_rad : angles_rad[i + 1]) - angles_rad[i]);
  }
  return gaps;
}

void AddCell(const SweepMap& map, const MapCell& cell, ControllerFigures* figures, Mean* mean,
             Mean* physical) {
  for (const MapPoint& point : cell.points) {
    figures->recovered += point.recovered;
    figures->lost += point.lost;
    figures->invalid += point.invalid;
  }
  const double value = ValueOf(map, cell);
  if (!std::isfinite(value)) return;
  ++figures->cells;
  mean->Add(value);
  if (!(value >= figures->least)) {
    figures->least = value;
    figures->worst = &cell;
  }
  figures->most = std::isfinite(figures->most) ? std::max(figures->most, value) : value;
  if (map.has_limits && cell.physical_Nspkg > 0.0) physical->Add(value / cell.physical_Nspkg);
}

double AreaOf(const SweepMap& map, std::size_t controller) {
  if (!map.has_limits) return kUnknown;
  Mean mean;
  for (std::size_t panel = 0; panel < map.panels.size(); ++panel) {
    std::vector<std::pair<double, double>> rays;
    for (const MapCell& cell : map.cells) {
      if (cell.controller != controller || cell.panel != panel || !cell.direction_rad) continue;
      rays.emplace_back(*cell.direction_rad, ValueOf(map, cell));
    }
    const double area = SectorArea(rays);
    if (std::isnan(area)) return kUnknown;
    mean.Add(area);
  }
  return mean.value();
}

}  // namespace

std::vector<ControllerFigures> FiguresOf(const SweepMap& map) {
  std::vector<ControllerFigures> all;
  for (std::size_t controller = 0; controller < map.controllers.size(); ++controller) {
    ControllerFigures figures;
    figures.controller = map.controllers[controller];
    Mean mean, physical;
    for (const MapCell& cell : map.cells) {
      if (cell.controller == controller) AddCell(map, cell, &figures, &mean, &physical);
    }
    figures.runs = figures.recovered + figures.lost + figures.invalid;
    figures.mean = mean.value();
    figures.physical_share = physical.value();
    figures.area = AreaOf(map, controller);
    all.push_back(figures);
  }
  return all;
}

double Dimensionless(const SweepMap& map, double impulse_Nspkg) {
  return impulse_Nspkg * map.omega_per_s / kGravity_mps2;
}

bool GoAround(std::vector<double> directions_rad) {
  constexpr std::size_t kFewest = 4;
  constexpr double kWidest_rad = kTurn_rad / 3.0;
  for (double& angle_rad : directions_rad) angle_rad = WithinTurn(angle_rad);
  std::sort(directions_rad.begin(), directions_rad.end());
  if (directions_rad.size() < kFewest) return false;
  const std::vector<double> gaps = GapsOf(directions_rad);
  return *std::max_element(gaps.begin(), gaps.end()) <= kWidest_rad;
}

double SectorArea(std::vector<std::pair<double, double>> rays) {
  for (auto& [angle_rad, radius] : rays) angle_rad = WithinTurn(angle_rad);
  std::sort(rays.begin(), rays.end());
  std::vector<double> angles_rad;
  for (const auto& ray : rays) angles_rad.push_back(ray.first);
  if (!GoAround(angles_rad)) return kUnknown;
  const std::vector<double> gaps = GapsOf(angles_rad);
  double area = 0.0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double before = gaps[(i + gaps.size() - 1) % gaps.size()];
    area += 0.25 * rays[i].second * rays[i].second * (before + gaps[i]);
  }
  return area;
}

Contest Compare(const SweepMap& map, const MapCell& first, const MapCell& second) {
  const CellLimit a = LimitOf(first);
  const CellLimit b = LimitOf(second);
  if (std::isnan(a.share) || std::isnan(b.share)) return Contest::kNothing;
  if (!map.has_limits) {
    if (a.share == b.share) return Contest::kOpen;
    return a.share > b.share ? Contest::kFirst : Contest::kSecond;
  }
  if (a.survived >= b.lost) return Contest::kFirst;
  if (b.survived >= a.lost) return Contest::kSecond;
  return Contest::kOpen;
}

}  // namespace sidestep::map
