// SPDX-License-Identifier: BSD-3-Clause
#include "controller/dcm/pendulum.h"

#include <algorithm>
#include <cmath>

#include "models/support/require.h"

namespace sidestep::dcm {

Eigen::Vector2d NominalOffset(const Eigen::Vector2d& advance_m, const Eigen::Vector2d& across_m,
                              double growth) {
  return advance_m / (growth - 1.0) + across_m / (growth + 1.0);
}

Interval ViableForward(const Interval& length_m, double growth) {
  return {length_m.least / (growth - 1.0), length_m.most / (growth - 1.0)};
}

// b'' = b over two steps, the first of one bound's width, the second of the other's.
Interval ViableSideways(const Interval& width_m, double growth) {
  const double scale = growth * growth - 1.0;
  return {(width_m.least * growth - width_m.most) / scale,
          (width_m.most * growth - width_m.least) / scale};
}

double SwitchDelay_s(double time_s, double omega_per_s) {
  const double a = omega_per_s * time_s;
  constexpr double kNone = 1e-9;  // below it the quotient is 1 but for rounding
  if (a < kNone) return 0.5 * time_s;
  return time_s - std::log(std::expm1(a) / a) / omega_per_s;
}

void VrpPath::Add(double time_s, const Eigen::Vector2d& p_m) {
  SIDESTEP_REQUIRE(size_ < kMost, size_);
  if (size_ > 0) time_s = std::max(time_s, end_s());
  knots_[size_++] = {time_s, p_m};
}

Eigen::Vector2d VrpPath::At(double time_s) const {
  if (time_s <= knots_[0].time_s) return knots_[0].p_m;
  for (std::size_t i = 1; i < size_; ++i) {
    const Knot &from = knots_[i - 1], &to = knots_[i];
    if (time_s >= to.time_s) continue;
    return from.p_m + (time_s - from.time_s) / (to.time_s - from.time_s) * (to.p_m - from.p_m);
  }
  return knots_[size_ - 1].p_m;
}

// Along p = p_0 + r t one solution is p + r / w; what is apart from it grows as e^(wt).
Eigen::Vector2d VrpPath::DcmAt(double time_s, const Eigen::Vector2d& end_m,
                               double omega_per_s) const {
  Eigen::Vector2d dcm_m = end_m;
  for (std::size_t i = size_ - 1; i > 0 && time_s < knots_[i].time_s; --i) {
    const Knot &from = knots_[i - 1], &to = knots_[i];
    const double span_s = to.time_s - from.time_s;
    if (span_s <= 0.0) continue;
    const double back_s = to.time_s - std::max(time_s, from.time_s);
    const Eigen::Vector2d ahead_m = (to.p_m - from.p_m) / (span_s * omega_per_s);
    const Eigen::Vector2d at_m = to.p_m - back_s / span_s * (to.p_m - from.p_m);
    dcm_m = at_m + ahead_m + std::exp(-omega_per_s * back_s) * (dcm_m - to.p_m - ahead_m);
  }
  if (time_s >= knots_[0].time_s) return dcm_m;
  const double back_s = knots_[0].time_s - time_s;
  return knots_[0].p_m + std::exp(-omega_per_s * back_s) * (dcm_m - knots_[0].p_m);
}

}  // namespace sidestep::dcm
