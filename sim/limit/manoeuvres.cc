// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/manoeuvres.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sidestep::limit {
namespace {

// How much longer than the shortest one a swing may last: the DCM grows fast, so later steps gain
// little, and those that are left out are near to one of these.
constexpr std::array<double, 4> kExtraTimes_s{0.0, 0.05, 0.1, 0.2};
// Of the line from the standing foot to the other one.
constexpr std::array<double, 5> kShares{0.0, 0.25, 0.5, 0.75, 1.0};
constexpr double kPlaceRounding = 1e-9;

std::vector<double> FromOn(double least_s) {
  std::vector<double> times_s;
  for (const double extra_s : kExtraTimes_s) times_s.push_back(least_s + extra_s);
  return times_s;
}

std::size_t NearestTo(double value, const std::vector<double>& values) {
  const auto nearest = std::min_element(values.begin(), values.end(), [&](double a, double b) {
    return std::abs(a - value) < std::abs(b - value);
  });
  return static_cast<std::size_t>(nearest - values.begin());
}

}  // namespace

Manoeuvres::Manoeuvres(const LimitParams& params, bool is_planar, StepFreedom freedom)
    : params_(params),
      is_planar_(is_planar),
      freedom_(freedom),
      x_(ForwardAxis(params, freedom)),
      y_(is_planar ? NoAxis() : SidewaysAxis(params, freedom)),
      support_s_(freedom == StepFreedom::kFree ? params.least_support_s : params.double_support_s) {
  const std::vector<double> swings_s = freedom == StepFreedom::kFree
                                           ? FromOn(params.least_swing_s)
                                           : std::vector<double>{params.swing_s};
  x_kernels_ = KernelsOf(x_, params.omega_per_s, swings_s, support_s_);
  y_kernels_ = is_planar ? std::vector<Kernel>(x_kernels_.size(), Kernel{kWholeLine})
                         : KernelsOf(y_, params.omega_per_s, swings_s, support_s_);
}

void Manoeuvres::VisitAll(const PendulumState& state, const Visit& visit) const {
  if (state.is_in_swing) {
    VisitSwing(state, visit);
  } else {
    VisitSupport(state, visit);
  }
}

void Manoeuvres::VisitSwing(const PendulumState& state, const Visit& visit) const {
  for (const double time_s : LandingTimes(state)) {
    VisitStep({time_s, time_s <= state.left_s + kPlaceRounding, state.other_foot_m}, visit);
  }
}

void Manoeuvres::VisitSupport(const PendulumState& state, const Visit& visit) const {
  const Eigen::Vector2d& other_m = state.other_foot_m;
  for (const double share : kShares) {  // no step at all
    visit({{SoleAlong(x_, share * other_m.x())},
           {is_planar_ ? kWholeLine : SoleAlong(y_, share * other_m.y())},
           nullptr});
  }
  const bool is_free = freedom_ == StepFreedom::kFree;
  const double left_s = is_free ? std::max(0.0, support_s_ - state.since_s) : state.left_s;
  // About the other foot, where this one is next: ahead and back change, left and right do not.
  const Eigen::Vector2d this_seen_m(-other_m.x(), other_m.y());
  for (const double time_s : LandingTimes(state)) {
    VisitStep({time_s, true, this_seen_m}, [&](const CaptureSets& sets) {
      CaptureSets seen = sets;
      for (Interval& x : seen.x) x = x_.SeenFromBefore(x, other_m.x());
      for (Interval& y : seen.y) y = y_.SeenFromBefore(y, other_m.y());
      VisitShares(state, left_s, seen, visit);
    });
    if (!is_free) continue;
    VisitStep({time_s, true, other_m},
              [&](const CaptureSets& sets) { VisitShares(state, left_s, sets, visit); });
  }
}

void Manoeuvres::VisitShares(const PendulumState& state, double left_s, const CaptureSets& sets,
                             const Visit& visit) const {
  if (left_s <= 0.0) {
    visit(sets);
    return;
  }
  const double growth = Growth(left_s);
  for (const double share : kShares) {
    CaptureSets now = sets;
    const Interval x_cop = SoleAlong(x_, share * state.other_foot_m.x());
    const Interval y_cop = SoleAlong(y_, share * state.other_foot_m.y());
    for (Interval& x : now.x) x = Before(x, x_cop, growth);
    for (Interval& y : now.y) y = Before(y, y_cop, growth);
    visit(now);
  }
}

void Manoeuvres::VisitStep(const Step& step, const Visit& visit) const {
  const std::vector<char> may_land = LandingsOf(step);
  if (std::count(may_land.begin(), may_land.end(), 1) == 0) return;
  const double growth = Growth(step.until_landing_s);
  for (std::size_t kernel = 0; kernel <= x_kernels_.size(); ++kernel) {
    for (const double share : kShares) {
      CaptureSets sets = AtLanding(kernel, share);
      for (Interval& x : sets.x) x = Before(x, SoleAlong(x_, 0.0), growth);
      for (Interval& y : sets.y) y = Before(y, SoleAlong(y_, 0.0), growth);
      sets.may_land = &may_land;
      visit(sets);
    }
  }
}

CaptureSets Manoeuvres::AtLanding(std::size_t kernel, double share) const {
  const double growth = Growth(support_s_);
  const auto along = [&](const StepAxis& axis, const std::vector<Kernel>& kernels) {
    std::vector<Interval> held;
    for (const double landing_m : axis.landings_m) {
      const Interval cop = SoleAlong(axis, share * landing_m);
      if (kernel == kernels.size()) {
        held.push_back(cop);
        continue;
      }
      const Interval& next = kernels[kernel][axis.OriginAfter(landing_m)];
      const Interval seen = next.is_empty() ? next : axis.SeenFromBefore(next, landing_m);
      held.push_back(Before(seen, cop, growth));
    }
    return held;
  };
  CaptureSets sets{along(x_, x_kernels_), along(y_, y_kernels_), nullptr};
  if (is_planar_) sets.y = {kWholeLine};
  return sets;
}

std::vector<char> Manoeuvres::LandingsOf(const Step& step) const {
  std::vector<char> may_land;
  const double reach_m = x_.speed_mps * step.until_landing_s + kPlaceRounding;
  for (const double x_m : x_.landings_m) {
    for (const double y_m : y_.landings_m) {
      const double sideways_m = is_planar_ ? 0.0 : y_m - step.swinging_foot_m.y();
      const bool is_near = std::hypot(x_m - step.swinging_foot_m.x(), sideways_m) <= reach_m ||
                           freedom_ == StepFreedom::kNone;
      const bool crosses =
          !is_planar_ && freedom_ != StepFreedom::kNone && y_m < params_.nearest_m - kPlaceRounding;
      const bool is_clear = !crosses || std::abs(x_m) >= params_.crossing_m - kPlaceRounding;
      may_land.push_back(is_near && is_clear ? 1 : 0);
    }
  }
  if (step.lands_anyway && std::count(may_land.begin(), may_land.end(), 1) == 0) {
    const std::size_t i = NearestTo(params_.step_length_m, x_.landings_m);
    const std::size_t j = NearestTo(is_planar_ ? 0.0 : params_.step_width_m, y_.landings_m);
    may_land[i * y_.landings_m.size() + j] = 1;
  }
  return may_land;
}

std::vector<double> Manoeuvres::LandingTimes(const PendulumState& state) const {
  if (freedom_ != StepFreedom::kFree) return {state.is_in_swing ? state.left_s : params_.swing_s};
  if (!state.is_in_swing) return FromOn(params_.least_swing_s);
  return FromOn(std::min(params_.least_rest_s, state.left_s));
}

double Manoeuvres::Growth(double time_s) const { return std::exp(params_.omega_per_s * time_s); }

Interval Manoeuvres::SoleAlong(const StepAxis& axis, double foot_m) const {
  return Around(foot_m, axis.half_sole_m);
}

}  // namespace sidestep::limit
