// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// path_line: the line that the nominal CoM draws on the ground, looked at without its clock.

#include <Eigen/Core>
#include <vector>

#include "controller/types/tick.h"
#include "sim/scenario/nominal_motion.h"

namespace sidestep {

class PathLine {
 public:
  /// Samples the nominal CoM every 10 ms: chords over a walk's cycle with 0.1 m of sway are within
  /// 0.05 mm of it.
  explicit PathLine(const NominalMotion& nominal);

  /// A point of the line, and when the nominal CoM is there; between ticks.
  struct Point {
    double tick{0.0};
    Eigen::Vector2d p_WC{Eigen::Vector2d::Zero()};
  };

  /// The point nearest to `p_W` of those that the nominal CoM passes within `reach` ticks of
  /// `around`; of several as near (where it stands, say) the one that is there nearest to `now`.
  Point NearestTo(const Eigen::Vector2d& p_W, double around, double reach, Tick now) const;

  /// The nominal CoM at `tick`, held at the line's ends before and after them.
  Eigen::Vector2d At(double tick) const;

 private:
  Tick stride_;
  std::vector<Eigen::Vector2d> points_;  // one every stride_, from tick 0; at least two
};

}  // namespace sidestep
