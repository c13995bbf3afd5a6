// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/force_sensing.h"

#include <algorithm>

#include "models/support/require.h"

namespace sidestep {
namespace {

std::size_t IndexOf(const std::string& name, const std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  SIDESTEP_REQUIRE(found != names.end(), name);
  return static_cast<std::size_t>(found - names.begin());
}

// What touches the distal part of a sensor: about the point p_W, in W.
Wrench TouchAbout(const Eigen::Vector3d& p_W, const ForceTorqueKinematics& site,
                  const Wrench& measured) {
  Wrench touch;
  touch.force_N = site.R_WS * (measured.force_N - site.unloaded.force_N);
  touch.torque_Nm = site.R_WS * (measured.torque_Nm - site.unloaded.torque_Nm) +
                    (site.p_WS - p_W).cross(touch.force_N);
  return touch;
}

}  // namespace

ForceSensing::ForceSensing(const RobotDescription& robot, const EstimatorParams& params,
                           double dt_s, const RigidBody& body)
    : contact_threshold_N_(params.contact_threshold_N), dt_s_(dt_s) {
  for (const FootDescription& foot : robot.feet) {
    auto& sensors = foot_sensors_.emplace_back();
    for (const std::string& name : foot.force_torque) {
      sensors.push_back(IndexOf(name, robot.force_torque));
    }
  }
  for (const std::string& name : robot.arm_force_torque) {
    arm_sensors_.push_back(IndexOf(name, robot.force_torque));
  }
  velocity_.setZero(body.num_velocities());
  acceleration_.setZero(body.num_velocities());
}

void ForceSensing::Update(const SensorFrame& frame, RigidBody* body, RobotState* state) {
  const std::vector<ForceTorqueKinematics>* sites = nullptr;
  if (body->has_force_torque()) sites = &body->PredictForceTorque(acceleration_);
  const auto touch_about = [&](const Eigen::Vector3d& p_W, std::size_t sensor) {
    return TouchAbout(p_W, (*sites)[sensor], frame.force_torque[sensor]);
  };
  for (std::size_t i = 0; i < state->feet.size(); ++i) {
    FootState& foot = state->feet[i];
    foot.wrench = {};
    foot.wrench.force_N.z() = frame.feet[i].normal_force_N;
    if (!foot_sensors_[i].empty()) foot.wrench.force_N.setZero();
    for (const std::size_t sensor : foot_sensors_[i]) {
      const Wrench touch = touch_about(foot.p_WF, sensor);
      foot.wrench.force_N += touch.force_N;
      foot.wrench.torque_Nm += touch.torque_Nm;
    }
    foot.in_contact = foot.wrench.force_N.z() > contact_threshold_N_;
  }
  arms_ = {};
  for (const std::size_t sensor : arm_sensors_) {
    const Wrench touch = touch_about(state->p_WC, sensor);
    arms_.force_N += touch.force_N;
    arms_.torque_Nm += touch.torque_Nm;
  }
}

void ForceSensing::NoteVelocity(const Eigen::VectorXd& velocity) {
  if (has_velocity_) acceleration_ = (velocity - velocity_) / dt_s_;
  velocity_ = velocity;
  has_velocity_ = true;
}

}  // namespace sidestep
