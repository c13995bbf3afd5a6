// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// external_wrench: what the controller takes the world's push on the robot to be. The only writer
// of RobotState::external_wrench.
//
//   unknown     nothing
//   known       what the frame says, from the simulation
//   estimated   w_arms + F    w_arms: smoothed, none if its force is within the deadband
//                             F: of the momentum observer, none within a deadband of its own

#include <optional>

#include "controller/estimator/momentum_observer.h"
#include "controller/types/control_params.h"
#include "controller/types/robot_state.h"
#include "controller/types/sensor_frame.h"

namespace sidestep {

class ExternalWrench {
 public:
  /// Of a robot that could feel pushes: `mass_kg` is its mass, `dt_s` the time between frames.
  ExternalWrench(ExternalWrenchKnowledge knowledge, const EstimatorParams& params, double mass_kg,
                 double dt_s);

  /// Of a plant without sensors for it: it may be told a push, and feels none.
  explicit ExternalWrench(ExternalWrenchKnowledge knowledge);

  /// Writes the external wrench of this frame into `state`, whose other fields must be final.
  /// `arms` is what touches the arms at this instant, about C, in W (ForceSensing::arms()). Call it
  /// once a frame. Does not allocate.
  void Update(const SensorFrame& frame, const Wrench& arms, RobotState* state);

 private:
  Wrench Estimate(const SensorFrame& frame, const Wrench& arms, const RobotState& state);

  ExternalWrenchKnowledge knowledge_;
  EstimatorParams params_;
  double dt_s_{0.0};
  std::optional<MomentumObserver> observer_;  // none without sensors
  Wrench smooth_arms_;
};

}  // namespace sidestep
