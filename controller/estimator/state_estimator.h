// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// state_estimator: from a SensorFrame to the RobotState that the rest of the controller believes.

#include "controller/types/robot_state.h"
#include "controller/types/sensor_frame.h"

namespace sidestep {

/// One way to know the state.
class StateEstimator {
 public:
  virtual ~StateEstimator() = default;

  /// Takes the next frame and returns the belief at its instant. The reference stays valid; the
  /// object behind it changes with the next call. Does not allocate after the first call.
  virtual const RobotState& Update(const SensorFrame& frame) = 0;
};

}  // namespace sidestep
