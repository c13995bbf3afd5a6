// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// force_sensing: what the ground does to the feet and the world to the arms, from touch and
// force/torque sensors.
//
// A force/torque sensor feels all that acts on its distal part: what touches it, its weight and its
// inertia. The nominal model predicts the last two, so
//   w_touch = w_measured - w_unloaded(q, nu, nudot)
// with nudot the change of the belief's velocity over the period before the last (the last one's is
// not known yet), whatever the age of the readings. The difference is smoothed. Source: the
// Newton-Euler equations of the distal part, as in Ivaldi et al., "Computing robot
// internal/external wrenches by means of inertial, tactile and F/T sensors", Humanoids 2011.

#include <Eigen/Core>
#include <vector>

#include "controller/model/rigid_body.h"
#include "controller/types/control_params.h"
#include "controller/types/robot_state.h"
#include "controller/types/sensor_frame.h"

namespace sidestep {

class ForceSensing {
 public:
  /// `rigid_body` must outlive this object; `dt_s` is the time between frames.
  ForceSensing(const RobotDescription& robot, const EstimatorParams& params, double dt_s,
               RigidBody* rigid_body);

  /// Writes every foot's in_contact and wrench, and the external wrench at the arms about C, into
  /// `state`. The rigid body must be at `state`, and `state` hold its derived quantities; only
  /// positions relative to each other matter. Does not allocate.
  void Update(const SensorFrame& frame, RobotState* state);

  /// Takes the velocity nu (nv) that the estimator settled on, for the next frame's acceleration.
  void NoteVelocity(const Eigen::VectorXd& velocity);

  /// What the arms feel, smoothed, without deadband, about C, in W.
  const Wrench& arms() const { return external_; }

 private:
  Wrench Touch(const SensorFrame& frame, std::size_t sensor, const Eigen::Vector3d& p_W) const;
  void SmoothExternal(const Wrench& wrench);

  EstimatorParams params_;
  double dt_s_;
  RigidBody* rigid_body_;
  std::vector<std::vector<std::size_t>> foot_sensors_;  // indices of RobotDescription::force_torque
  std::vector<std::size_t> arm_sensors_;
  Eigen::VectorXd velocity_;
  Eigen::VectorXd acceleration_;
  bool has_velocity_{false};
  Wrench external_;  // smoothed
};

}  // namespace sidestep
