// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/force_sensing.h"

#include <algorithm>

#include "controller/estimator/low_pass.h"
#include "models/support/require.h"

namespace sidestep {
namespace {

std::size_t IndexOf(const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  SIDESTEP_REQUIRE(found != names.end(), name);
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace

ForceSensing::ForceSensing(const RobotDescription& robot, const EstimatorParams& params,
                           double dt_s, RigidBody* rigid_body)
    : params_(params), dt_s_(dt_s), rigid_body_(rigid_body) {
  for (const FootDescription& foot : robot.feet) {
    auto& sensors = foot_sensors_.emplace_back();
    for (const std::string& name : foot.force_torque) {
      sensors.push_back(IndexOf(name, robot.force_torque));
    }
  }
  for (const std::string& name : robot.arm_force_torque) {
    arm_sensors_.push_back(IndexOf(name, robot.force_torque));
  }
  velocity_.setZero(rigid_body->num_velocities());
  acceleration_.setZero(rigid_body->num_velocities());
}

void ForceSensing::Update(const SensorFrame& frame, RobotState* state) {
  if (!rigid_body_->force_torque().empty()) rigid_body_->UpdateForceTorque(acceleration_);
  for (std::size_t i = 0; i < state->feet.size(); ++i) {
    FootState& foot = state->feet[i];
    foot.wrench = {};
    foot.wrench.force_N.z() = frame.feet[i].normal_force_N;
    if (!foot_sensors_[i].empty()) foot.wrench.force_N.setZero();
    for (const std::size_t sensor : foot_sensors_[i]) {
      const Wrench touch = Touch(frame, sensor, foot.p_WF);
      foot.wrench.force_N += touch.force_N;
      foot.wrench.torque_Nm += touch.torque_Nm;
    }
    foot.in_contact = foot.wrench.force_N.z() > params_.contact_threshold_N;
  }
  Wrench arms;
  for (const std::size_t sensor : arm_sensors_) {
    const Wrench touch = Touch(frame, sensor, state->p_WC);
    arms.force_N += touch.force_N;
    arms.torque_Nm += touch.torque_Nm;
  }
  SmoothExternal(arms);
  state->external_wrench = {};
  if (external_.force_N.norm() > params_.wrench_deadband_N) state->external_wrench = external_;
}

// What touches the distal part of a sensor: about the point p_W, in W.
Wrench ForceSensing::Touch(const SensorFrame& frame, std::size_t sensor,
                           const Eigen::Vector3d& p_W) const {
  const ForceTorqueKinematics& site = rigid_body_->force_torque()[sensor];
  const Wrench& measured = frame.force_torque[sensor];
  Wrench touch;
  touch.force_N = site.R_WS * (measured.force_N - site.unloaded.force_N);
  touch.torque_Nm = site.R_WS * (measured.torque_Nm - site.unloaded.torque_Nm) +
                    (site.p_WS - p_W).cross(touch.force_N);
  return touch;
}

void ForceSensing::SmoothExternal(const Wrench& wrench) {
  const double share = LowPassShare(params_.wrench_cutoff_hz, dt_s_);
  external_.force_N += share * (wrench.force_N - external_.force_N);
  external_.torque_Nm += share * (wrench.torque_Nm - external_.torque_Nm);
}

void ForceSensing::NoteVelocity(const Eigen::VectorXd& velocity) {
  if (has_velocity_) acceleration_ = (velocity - velocity_) / dt_s_;
  velocity_ = velocity;
  has_velocity_ = true;
}

}  // namespace sidestep
