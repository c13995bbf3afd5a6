// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// joint_ranges: where a joint may be.

#include <algorithm>
#include <numbers>

#include "models/import/source_robot.h"

namespace sidestep::importer {

inline constexpr double kRangeMargin = 0.05;     ///< Kept free at each end: share of the range ...
inline constexpr double kMostMargin_rad = 0.05;  ///< ... but no more than this.

/// Ends of the range; of a joint without one, half a turn either way.
inline double LowerEnd(const SourceJoint& joint) {
  return joint.has_range() ? std::max(joint.lower, -std::numbers::pi) : -std::numbers::pi;
}
inline double UpperEnd(const SourceJoint& joint) {
  return joint.has_range() ? std::min(joint.upper, std::numbers::pi) : std::numbers::pi;
}

inline double MarginOf(const SourceJoint& joint) {
  return std::min(kMostMargin_rad, kRangeMargin * (UpperEnd(joint) - LowerEnd(joint)));
}

/// `q`, or the nearest place in the range less its margin.
inline double Within(const SourceJoint& joint, double q) {
  return std::clamp(q, LowerEnd(joint) + MarginOf(joint), UpperEnd(joint) - MarginOf(joint));
}

}  // namespace sidestep::importer
