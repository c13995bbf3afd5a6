// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/walking_pendulum.h"

#include <cmath>

#include "models/support/require.h"

namespace sidestep::limit {
namespace {

// Share of its way that a move of least jerk has behind it after a share of its time.
double LeastJerkShare(double share) {
  return share * share * share * (10.0 - 15.0 * share + 6.0 * share * share);
}

// From one foot's centre of pressure to the other's.
Eigen::Vector2d StrideOfCop(const LimitParams& params) {
  return {params.step_length_m, params.step_width_m - 2.0 * params.cop_inset_m};
}

}  // namespace

// With E, D the growths e^(omega t) of swing and double support, b the offset at lift-off, s the
// stride of the centre of pressure: after both, s + s / (omega t_D) + (b E - s / (omega t_D)) D. It
// must be s + b along x, and s - b along y, which has turned round.
Eigen::Vector2d LiftOffOffset(const LimitParams& params) {
  const double growth = std::exp(params.omega_per_s * (params.swing_s + params.double_support_s));
  const double support = params.omega_per_s * params.double_support_s;
  const double shift = support > 0.0 ? std::expm1(support) / support : 1.0;
  return StrideOfCop(params).array() * shift / Eigen::Array2d(growth - 1.0, growth + 1.0);
}

// Counted back from the end of swing and of double support: what errors there are fade that way.
PendulumState WalkAt(const LimitParams& params, double time_s) {
  const double step_s = params.swing_s + params.double_support_s;
  SIDESTEP_REQUIRE(0.0 <= time_s && time_s < step_s, time_s);
  const double omega = params.omega_per_s;
  const Eigen::Vector2d cop_m(0.0, params.cop_inset_m);
  const Eigen::Vector2d offset_m = LiftOffOffset(params);
  PendulumState state;
  state.is_in_swing = time_s <= params.swing_s;
  if (state.is_in_swing) {
    state.left_s = params.swing_s - time_s;
    state.dcm_m = cop_m + offset_m * std::exp(omega * time_s);
    const double share = LeastJerkShare(time_s / params.swing_s);
    state.other_foot_m = {params.step_length_m * (2.0 * share - 1.0), params.step_width_m};
    return state;
  }
  state.since_s = time_s - params.swing_s;
  state.left_s = step_s - time_s;
  state.other_foot_m = {params.step_length_m, params.step_width_m};
  const Eigen::Vector2d stride_m = StrideOfCop(params);
  const Eigen::Vector2d lead_m = stride_m / (omega * params.double_support_s);
  const Eigen::Vector2d at_end_m = stride_m + Eigen::Vector2d(offset_m.x(), -offset_m.y());
  state.dcm_m = cop_m + stride_m * (state.since_s / params.double_support_s) + lead_m +
                (at_end_m - stride_m - lead_m) * std::exp(-omega * state.left_s);
  return state;
}

PendulumState StandOf(const LimitParams& params) {
  PendulumState state;
  state.other_foot_m = {0.0, params.step_width_m};
  state.dcm_m = 0.5 * state.other_foot_m;
  state.since_s = params.least_support_s;
  return state;
}

}  // namespace sidestep::limit
