// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// state_estimator: from a SensorFrame to the RobotState that the rest of the controller believes.

#include <memory>

#include "controller/model/rigid_body.h"
#include "controller/types/robot_state.h"
#include "controller/types/sensor_frame.h"

namespace sidestep {

/// One way to know the state of a robot with joints. Holds no pointers: copies go on by themselves.
class StateEstimator {
 public:
  virtual ~StateEstimator() = default;

  /// Takes the next frame and returns the belief at its instant; leaves `body`, which must be the
  /// robot that the estimator was made for, at that belief. The reference stays valid; the object
  /// behind it changes with the next call. Does not allocate after the first call.
  virtual const RobotState& Update(const SensorFrame& frame, RigidBody* body) = 0;

  /// A copy that goes on from here bit for bit as this one does.
  virtual std::unique_ptr<StateEstimator> Clone() const = 0;

 protected:
  StateEstimator() = default;
  StateEstimator(const StateEstimator&) = default;
  StateEstimator& operator=(const StateEstimator&) = default;
};

}  // namespace sidestep
