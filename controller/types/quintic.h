// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// quintic: the polynomial of degree five through two states of position, velocity, acceleration.
// Shared by the CoM reference and the swing feet.

namespace sidestep {

/// A scalar and its first two derivatives in time, in whatever unit the caller has (m in all of
/// this program).
struct QuinticState {
  double position{0.0};
  double velocity{0.0};
  double acceleration{0.0};
};

/// One scalar quintic on [0, duration_s].
///   p(t) = c0 + c1 t + ... + c5 t^5
///
/// Without limits: between states it may overshoot either of them. A value; never allocates.
class Quintic {
 public:
  /// Joins `from` at 0 to `to` at duration_s (> 0); six conditions, six coefficients.
  Quintic(const QuinticState& from, const QuinticState& to, double duration_s)
      : c0_(from.position), c1_(from.velocity), c2_(0.5 * from.acceleration) {
    const double T = duration_s;
    const double dp = (to.position - from.position - T * (c1_ + T * c2_)) / (T * T * T);
    const double dv = (to.velocity - from.velocity - T * from.acceleration) / (T * T);
    const double da = (to.acceleration - from.acceleration) / T;
    c3_ = 10.0 * dp - 4.0 * dv + 0.5 * da;
    c4_ = (-15.0 * dp + 7.0 * dv - da) / T;
    c5_ = (6.0 * dp - 3.0 * dv + 0.5 * da) / (T * T);
  }

  /// Value and derivatives at t (s). Outside [0, duration_s] the polynomial just goes on, and grows
  /// like t^5.
  QuinticState At(double t) const {
    return {c0_ + t * (c1_ + t * (c2_ + t * (c3_ + t * (c4_ + t * c5_)))),
            c1_ + t * (2.0 * c2_ + t * (3.0 * c3_ + t * (4.0 * c4_ + t * 5.0 * c5_))),
            2.0 * c2_ + t * (6.0 * c3_ + t * (12.0 * c4_ + t * 20.0 * c5_))};
  }

 private:
  double c0_, c1_, c2_, c3_, c4_, c5_;  // in SI, by powers of t
};

}  // namespace sidestep
