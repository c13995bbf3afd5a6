// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// belief_meter: what the controller believes of its motion and of pushes, against the truth.
//
// At each control tick the belief is held against the truth of the same tick, whatever is older in
// the sensors: a late belief is a wrong one. Two errors are told:
//   of the CoM's velocity   |v_WC believed - v_WC|, in space, over the whole run, and again over
//                           the pushes' windows: from a push's start until 1 s after its end
//   of the push             |F believed - sum of the pushes' forces|, horizontally, over the whole
//                           run: a landing that is taken for a push counts, and so does a push of
//                           which the controller knows nothing
// Means are over control ticks.

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "controller/types/robot_state.h"
#include "controller/types/tick.h"
#include "sim/scenario/push.h"
#include "sim/world/world.h"

namespace sidestep {

/// The largest of some errors and the root of their mean square; NaN without any.
class ErrorFigures {
 public:
  void Add(double error);
  double max() const { return max_; }
  double rms() const;

 private:
  double max_{std::numeric_limits<double>::quiet_NaN()};
  double sum_of_squares_{0.0};
  int count_{0};
};

class BeliefMeter {
 public:
  BeliefMeter(const std::vector<Push>& pushes, double tick_s);

  /// Other pushes instead of those it has; none of either may have started.
  void ReplacePushes(const std::vector<Push>& pushes);

  /// Takes a control tick. A belief without feet is of a controller that tells none, and not
  /// measured.
  void Add(Tick tick, const WorldTruth& truth, const RobotState& belief);

  const ErrorFigures& com_velocity_mps() const { return com_velocity_mps_; }
  /// In the pushes' windows alone; NaN without pushes.
  const ErrorFigures& pushed_com_velocity_mps() const { return pushed_com_velocity_mps_; }
  const ErrorFigures& push_N() const { return push_N_; }

 private:
  struct Window {
    Tick start{0};
    Tick end{0};  ///< Included.
  };

  double tick_s_;
  std::vector<Window> windows_;
  ErrorFigures com_velocity_mps_;
  ErrorFigures pushed_com_velocity_mps_;
  ErrorFigures push_N_;
};

}  // namespace sidestep
