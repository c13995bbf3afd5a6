// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// interval: sets of DCMs (or of push strengths) on a line, and the pendulum run backwards on them.

#include <algorithm>
#include <limits>

namespace sidestep::limit {

/// lo <= value <= hi; empty by default.
struct Interval {
  double lo{std::numeric_limits<double>::infinity()};
  double hi{-std::numeric_limits<double>::infinity()};

  bool is_empty() const { return hi < lo; }
  bool contains(double value) const { return lo <= value && value <= hi; }
};

inline constexpr Interval kWholeLine{-std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::infinity()};

/// `interval` moved by `by`.
inline Interval Moved(const Interval& interval, double by) {
  return {interval.lo + by, interval.hi + by};
}

/// `interval` in a frame whose origin lies at `origin` and whose axis points the other way.
inline Interval Mirrored(const Interval& interval, double origin) {
  return {origin - interval.hi, origin - interval.lo};
}

/// What is within `half_width` of `middle`.
inline Interval Around(double middle, double half_width) {
  return {middle - half_width, middle + half_width};
}

/// The smallest interval that holds both.
inline Interval Joined(const Interval& a, const Interval& b) {
  if (a.is_empty() || b.is_empty()) return a.is_empty() ? b : a;
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

/// Where a DCM (m) is from which centres of pressure within `cop` can lead it into `target` in a
/// time t. It runs away from the centre of pressure p, xi(t) = p + (xi(0) - p) growth, with
/// growth = e^(omega t) >= 1.
inline Interval Before(const Interval& target, const Interval& cop, double growth) {
  if (target.is_empty()) return {};
  return {(target.lo + cop.lo * (growth - 1.0)) / growth,
          (target.hi + cop.hi * (growth - 1.0)) / growth};
}

}  // namespace sidestep::limit
