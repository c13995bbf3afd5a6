// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/hopping_pendulum.h"

#include <algorithm>
#include <cmath>

#include "models/support/require.h"

namespace sidestep::limit {
namespace {

// No robot with legs survives more; a bisection begins there.
constexpr double kNeverCaught_mps = 100.0;
constexpr int kHalvings = 40;  // 100 m/s to 1e-10
// A speed that is caught falls with every hop, in the end as c^-1; one that falls no more is lost.
constexpr int kMostHops = 1000;
constexpr double kReachRounding_m = 1e-9;

/// A hopper that has just left the ground: its speed, and its foot ahead of its CoM.
struct LiftOff {
  double v_mps{0.0};
  double foot_m{0.0};
};

class Hopper {
 public:
  explicit Hopper(const LimitParams& params)
      : params_(params),
        omega_per_s_(params.omega_per_s *
                     std::sqrt((params.stance_s + params.flight_s) / params.stance_s)) {}

  /// After `time_s` of stance that begins with the foot `ahead_m` of the CoM.
  LiftOff AfterStance(double v_mps, double ahead_m, double time_s) const {
    const double c = std::cosh(omega_per_s_ * time_s);
    const double s = std::sinh(omega_per_s_ * time_s);
    return {v_mps * c - ahead_m * omega_per_s_ * s, ahead_m * c - v_mps * s / omega_per_s_};
  }

  /// Whether the foot ends a stance within its reach.
  bool IsWithinReach(const LiftOff& state) const {
    return std::abs(state.foot_m) <= params_.reach_m + kReachRounding_m;
  }

  /// Whether `v_mps` (>= 0) can be caught if the foot, at `foot_m` now, has `left_s` of flight.
  bool Catches(double v_mps, double foot_m, double left_s) const {
    LiftOff state{v_mps, foot_m};
    for (int i = 0; i < kMostHops; ++i) {
      const double ahead_m =
          std::min(params_.reach_m, state.foot_m + params_.swing_speed_mps * left_s);
      const LiftOff next = AfterStance(state.v_mps, ahead_m, params_.stance_s);
      if (next.v_mps <= 0.0) return true;  // so a foot less far ahead stops it
      if (!IsWithinReach(next)) return false;
      state = next;
      left_s = params_.flight_s;
    }
    return false;
  }

  /// Whether a step of velocity of `v_mps` is survived at `time_s`, when it was hopping in place.
  bool Survives(double v_mps, double time_s) const {
    if (time_s > params_.stance_s) {
      return Catches(v_mps, 0.0, params_.stance_s + params_.flight_s - time_s);
    }
    const LiftOff state = AfterStance(v_mps, 0.0, params_.stance_s - time_s);
    return IsWithinReach(state) && Catches(state.v_mps, state.foot_m, params_.flight_s);
  }

 private:
  LimitParams params_;
  double omega_per_s_;
};

}  // namespace

double HopLimit(const LimitParams& params, double time_s) {
  SIDESTEP_REQUIRE(0.0 <= time_s && time_s <= params.stance_s + params.flight_s, time_s);
  const Hopper hopper(params);
  double survived_mps = 0.0;
  double lost_mps = kNeverCaught_mps;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_mps = 0.5 * (survived_mps + lost_mps);
    (hopper.Survives(middle_mps, time_s) ? survived_mps : lost_mps) = middle_mps;
  }
  return survived_mps;
}

}  // namespace sidestep::limit
