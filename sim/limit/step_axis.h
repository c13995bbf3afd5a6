// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// step_axis: the places of feet along one axis of the ground, as a grid.
//
// Every step has a frame of its own: origin at the standing foot's middle, x ahead, y towards the
// other foot. So y turns round from step to step: what was y towards a foot at s is s - y in the
// frame of the next step, which stands on that foot; x becomes x - s.

#include <cstddef>
#include <vector>

#include "sim/limit/interval.h"
#include "sim/limit/limit_params.h"

namespace sidestep::limit {

/// One axis of the frame of a step.
struct StepAxis {
  std::vector<double> footholds_m;  ///< Where the swinging foot may land in a step.
  std::vector<double> landings_m;   ///< Where it may in the first step: footholds and crossings.
  std::vector<double> origins_m;    ///< Where a foot may stand before it swings.
  double half_sole_m{0.0};
  bool turns_round{false};  ///< y, not x.
  double speed_mps{0.0};    ///< Of a foot in the air; infinite: it gets anywhere.

  /// Index in origins_m of the standing foot as the next step sees it, after a landing at
  /// `landing_m`, one of landings_m or footholds_m.
  std::size_t OriginAfter(double landing_m) const;

  /// `dcm`, of the frame of the next step, in the present one, after a landing at `landing_m`.
  Interval SeenFromBefore(const Interval& dcm, double landing_m) const {
    return turns_round ? Mirrored(dcm, landing_m) : Moved(dcm, landing_m);
  }
};

/// The axes x and y of `params`. Without freedom the gait's own footholds are the only ones.
StepAxis ForwardAxis(const LimitParams& params, StepFreedom freedom);
StepAxis SidewaysAxis(const LimitParams& params, StepFreedom freedom);

/// The y axis of a robot that moves in the plane y = 0: one place, for all feet.
StepAxis NoAxis();

}  // namespace sidestep::limit
