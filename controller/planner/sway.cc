// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/sway.h"

#include <algorithm>
#include <cmath>

#include "controller/planner/capture_point.h"

namespace sidestep {
namespace {

constexpr double kLeastSupport_s = 1e-3;  // for less the closed forms lose digits, and change none

}  // namespace

Sway SwayOf(const ComSway& asked, const GaitParams& gait, double height_m) {
  if (asked.mode == SwayMode::kShare) return {asked.share};
  const double rate_per_s = 1.0 / PendulumTimeConstant_s(height_m);
  const double support_s = std::max(gait.double_support_s, kLeastSupport_s);
  const double half_support = 0.5 * rate_per_s * support_s;
  const double half_swing = 0.5 * rate_per_s * gait.swing_s;
  const double most = std::cosh(half_support + half_swing);
  Sway sway;
  sway.share = 1.0 - std::sinh(half_support) / half_support / most;
  if (asked.share > 0.0 && sway.share > asked.share) return {asked.share};
  const double crossing_per_s = 2.0 / support_s * (1.0 - std::cosh(half_swing) / most);
  sway.haste = crossing_per_s * (gait.swing_s + support_s) / (2.0 * sway.share);
  sway.turn_back_per_s2 = rate_per_s * rate_per_s * (1.0 - sway.share);
  return sway;
}

}  // namespace sidestep
