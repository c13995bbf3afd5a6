// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// force_sensing: what the ground does to the feet and the world to the arms, from touch and
// force/torque sensors.
//
// A force/torque sensor feels all that acts on its distal part: what touches it, its weight and its
// inertia. The nominal model predicts the last two, so
//   w_touch = w_measured - w_unloaded(q, nu, nudot)
// with nudot the change of the belief's velocity over the period before the last (the last one's is
// not known yet), whatever the age of the readings. Source: the Newton-Euler equations of the
// distal part, as in Ivaldi et al., "Computing robot internal/external wrenches by means of
// inertial, tactile and F/T sensors", Humanoids 2011.

#include <Eigen/Core>
#include <vector>

#include "controller/model/rigid_body.h"
#include "controller/types/control_params.h"
#include "controller/types/robot_state.h"
#include "controller/types/sensor_frame.h"

namespace sidestep {

class ForceSensing {
 public:
  /// `body` is the robot, for its sizes; `dt_s` is the time between frames.
  ForceSensing(const RobotDescription& robot, const EstimatorParams& params, double dt_s,
               const RigidBody& body);

  /// Writes every foot's in_contact and wrench into `state`, and keeps arms(). `body` must be at
  /// `state`, and `state` hold its derived quantities; only positions relative to each other
  /// matter. Does not allocate.
  void Update(const SensorFrame& frame, RigidBody* body, RobotState* state);

  /// Takes the velocity nu (nv) that the estimator settled on, for the next frame's acceleration.
  void NoteVelocity(const Eigen::VectorXd& velocity);

  /// What touched the arms in the last frame, neither smoothed nor within a deadband, about C, in
  /// W.
  const Wrench& arms() const { return arms_; }

 private:
  double contact_threshold_N_;
  double dt_s_;
  std::vector<std::vector<std::size_t>> foot_sensors_;  // indices of RobotDescription::force_torque
  std::vector<std::size_t> arm_sensors_;
  Eigen::VectorXd velocity_;
  Eigen::VectorXd acceleration_;
  bool has_velocity_{false};
  Wrench arms_;
};

}  // namespace sidestep
