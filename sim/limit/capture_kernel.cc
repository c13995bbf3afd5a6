// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/capture_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace sidestep::limit {
namespace {

// A DCM so far off (m) is lost, whatever a robot does.
constexpr double kLost_m = 3.0;
// For ever has come when one more step ahead moves no end by more; each step multiplies what there
// is to move by e^(-omega (swing + support)) or less.
constexpr double kSettled_m = 1e-7;
constexpr int kMostSteps = 10000;
// Reach and speed times time are compared with places of a grid.
constexpr double kRounding_m = 1e-9;

double LargestMove(const Kernel& from, const Kernel& to) {
  double move_m = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i].is_empty()) continue;  // what was lost stays lost
    if (to[i].is_empty()) return std::numeric_limits<double>::infinity();
    move_m = std::max({move_m, std::abs(to[i].lo - from[i].lo), std::abs(to[i].hi - from[i].hi)});
  }
  return move_m;
}

}  // namespace

Kernel BeforeStep(const StepAxis& axis, double omega_per_s, const StepTimes& times,
                  const Kernel& after) {
  const Interval sole = Around(0.0, axis.half_sole_m);
  const double swing_growth = std::exp(omega_per_s * times.swing_s);
  const double support_growth = std::exp(omega_per_s * times.support_s);
  const double reach_m = axis.speed_mps * times.swing_s + kRounding_m;
  Kernel before(axis.origins_m.size());
  for (const double foothold_m : axis.footholds_m) {
    const Interval& held = after[axis.OriginAfter(foothold_m)];
    if (held.is_empty()) continue;
    const Interval both = Joined(sole, Around(foothold_m, axis.half_sole_m));
    const Interval at_landing = Before(axis.SeenFromBefore(held, foothold_m), both, support_growth);
    const Interval at_lift_off = Before(at_landing, sole, swing_growth);
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (std::abs(foothold_m - axis.origins_m[i]) > reach_m) continue;
      before[i] = Joined(before[i], at_lift_off);
    }
  }
  return before;
}

Kernel HeldForEver(const StepAxis& axis, double omega_per_s, const StepTimes& times) {
  Kernel kernel(axis.origins_m.size(), Around(0.0, kLost_m));
  for (int i = 0; i < kMostSteps; ++i) {
    Kernel earlier = BeforeStep(axis, omega_per_s, times, kernel);
    const double move_m = LargestMove(kernel, earlier);
    kernel = std::move(earlier);
    if (move_m < kSettled_m) break;
  }
  return kernel;
}

std::vector<Kernel> KernelsOf(const StepAxis& axis, double omega_per_s,
                              const std::vector<double>& swings_s, double support_s) {
  std::vector<Kernel> kernels;
  const auto before = [&](double swing_s, const Kernel& after) {
    return BeforeStep(axis, omega_per_s, {swing_s, support_s}, after);
  };
  for (const double ever_s : swings_s) {
    const Kernel held = HeldForEver(axis, omega_per_s, {ever_s, support_s});
    for (const double third_s : swings_s) {
      const Kernel from_third = before(third_s, held);
      for (const double second_s : swings_s) kernels.push_back(before(second_s, from_third));
    }
  }
  return kernels;
}

}  // namespace sidestep::limit
