// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mujoco_world: the plant `mujoco`, a robot on a floor. Sole owner of the simulation's mjModel and
// mjData, and the one place where they are brought in step with each other.
//
// A step is MuJoCo's two halves: after the constructor and after every Step(), the first half
// (kinematics, collisions, velocities) belongs to the current state; the second half takes the
// command and the pushes and integrates. Contact forces and accelerations are those of the step
// that led to the current state.

#include <string>
#include <vector>

#include "models/mjcf/mjcf.h"
#include "sim/scenario/scenario.h"
#include "sim/world/pushes.h"
#include "sim/world/world.h"

namespace sidestep {

class MujocoWorld final : public World {
 public:
  /// Places the robot in its home posture. Throws ConfigError for names that the MJCF lacks.
  explicit MujocoWorld(const Scenario& scenario);

  const WorldTruth& truth() const override { return truth_; }
  bool is_valid() const override { return invalid_reason_.empty(); }
  const std::string& invalid_reason() const override { return invalid_reason_; }
  double mass_kg() const override { return mass_kg_; }
  const std::vector<std::string>& joint_names() const override { return joint_names_; }
  void Apply(const ActuatorCommand& command) override;
  void Step(Tick tick) override;

 private:
  /// A pushed body or frame: an object of the model.
  struct PushedObject {
    int body{0};
    int site{-1};  ///< -1: the body itself.
  };
  struct ImuSensors {
    int orientation{0}, gyro{0}, accelerometer{0};  ///< Addresses in sensordata.
  };

  void ResolveNames(const Scenario& scenario);
  int SensorAddress(const std::string& name) const;
  void UpdatePushes(Tick tick);
  void ApplyPushes();
  void ReadContacts();
  void ReadState();
  void CheckValid();

  MjModelPtr model_;
  MjDataPtr data_;
  Pushes pushes_;
  std::vector<PushedObject> pushed_;
  std::vector<PushedPose> pushed_poses_;
  double mass_kg_{0.0};
  int base_body_{0};
  std::vector<int> foot_site_;
  std::vector<int> foot_touch_;  // addresses in sensordata
  std::vector<int> joint_;       // of each actuator
  std::vector<std::string> joint_names_;
  ImuSensors imu_;
  WorldTruth truth_;
  std::string invalid_reason_;
};

}  // namespace sidestep
