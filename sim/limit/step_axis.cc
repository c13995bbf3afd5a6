// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/step_axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "models/support/require.h"

namespace sidestep::limit {
namespace {

constexpr double kAnySpeed_mps = std::numeric_limits<double>::infinity();
// How far beyond the standing foot's middle a crossing foot gets: where hips end in humanoids.
constexpr double kDeepestCrossing_m = 0.1;
constexpr double kSamePlace_m = 1e-9;

// From `from_m` on by `step_m`, and `to_m`.
std::vector<double> Grid(double from_m, double to_m, double step_m) {
  std::vector<double> grid;
  for (int i = 0; from_m + i * step_m < to_m - kSamePlace_m; ++i) {
    grid.push_back(from_m + i * step_m);
  }
  grid.push_back(to_m);
  return grid;
}

// The same to both sides of 0.
std::vector<double> GridAboutZero(double reach_m, double step_m) {
  const std::vector<double> ahead = Grid(0.0, reach_m, step_m);
  std::vector<double> grid(ahead.rbegin(), ahead.rend());
  grid.pop_back();
  for (double& place : grid) place = -place;
  grid.insert(grid.end(), ahead.begin(), ahead.end());
  return grid;
}

std::vector<double> Negated(std::vector<double> values) {
  for (double& value : values) value = -value;
  return values;
}

}  // namespace

std::size_t StepAxis::OriginAfter(double landing_m) const {
  const double origin_m = turns_round ? landing_m : -landing_m;
  const auto nearest = std::min_element(
      origins_m.begin(), origins_m.end(),
      [&](double a, double b) { return std::abs(a - origin_m) < std::abs(b - origin_m); });
  SIDESTEP_REQUIRE(nearest != origins_m.end(), landing_m);
  return static_cast<std::size_t>(nearest - origins_m.begin());
}

StepAxis ForwardAxis(const LimitParams& params, StepFreedom freedom) {
  StepAxis axis;
  axis.half_sole_m = params.sole_half_length_m;
  axis.speed_mps = freedom == StepFreedom::kNone ? kAnySpeed_mps : params.swing_speed_mps;
  axis.footholds_m = freedom == StepFreedom::kNone ? std::vector<double>{params.step_length_m}
                                                   : GridAboutZero(params.reach_m, params.grid_m);
  axis.landings_m = axis.footholds_m;
  axis.origins_m = Negated(axis.footholds_m);
  return axis;
}

StepAxis SidewaysAxis(const LimitParams& params, StepFreedom freedom) {
  StepAxis axis;
  axis.half_sole_m = params.sole_half_width_m;
  axis.turns_round = true;
  axis.speed_mps = freedom == StepFreedom::kNone ? kAnySpeed_mps : params.swing_speed_mps;
  axis.footholds_m = freedom == StepFreedom::kNone
                         ? std::vector<double>{params.step_width_m}
                         : Grid(params.nearest_m, params.farthest_m, params.grid_m);
  axis.landings_m = axis.footholds_m;
  if (freedom != StepFreedom::kNone && params.crossing_m > 0.0) {
    std::vector<double> crossings = Grid(-kDeepestCrossing_m, params.nearest_m, params.grid_m);
    crossings.pop_back();  // the nearest foothold is there already
    axis.landings_m.insert(axis.landings_m.begin(), crossings.begin(), crossings.end());
  }
  axis.origins_m = axis.landings_m;
  return axis;
}

StepAxis NoAxis() {
  StepAxis axis;
  axis.footholds_m = axis.landings_m = axis.origins_m = {0.0};
  axis.turns_round = true;
  axis.speed_mps = kAnySpeed_mps;
  return axis;
}

}  // namespace sidestep::limit
