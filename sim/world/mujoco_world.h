// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mujoco_world: the plant `mujoco`, a robot on a floor. Sole owner of the simulation's mjData, and
// the one place where it is brought in step with itself.
//
// A step is MuJoCo's two halves: after the constructor and after every Step(), the first half
// (kinematics, collisions, velocities) belongs to the current state; the second half takes the
// command and the pushes and integrates. Contact forces and accelerations are those of the step
// that led to the current state. The servos act at every step on the state it begins with.

#include <memory>
#include <string>
#include <vector>

#include "models/mjcf/base_joints.h"
#include "models/mjcf/mj_state.h"
#include "models/robot_description/robot_description.h"
#include "sim/actuators/joint_servos.h"
#include "sim/scenario/push.h"
#include "sim/scenario/world_params.h"
#include "sim/world/pushes.h"
#include "sim/world/world.h"

namespace sidestep {

/// A tick is one physics step. A MuJoCo warning or a state that is not finite makes it invalid for
/// good; nothing throws for that. The order of WorldTruth's joints is that of the MJCF's motors.
class MujocoWorld final : public World {
 public:
  /// Places the robot in its home posture. Throws ConfigError for names that the MJCF lacks, for
  /// a robot without one, and for servos that are not those of the MJCF's motors, in their order,
  /// and for uneven ground that lies in the robot.
  MujocoWorld(const RobotDescription& robot, const WorldParams& params,
              const std::vector<Push>& pushes);

  std::unique_ptr<World> Clone() const override { return std::make_unique<MujocoWorld>(*this); }
  const WorldTruth& truth() const override { return truth_; }
  bool is_valid() const override { return invalid_reason_.empty(); }
  const std::string& invalid_reason() const override { return invalid_reason_; }
  double mass_kg() const override { return mass_kg_; }
  const std::vector<JointInfo>& joints() const override { return joints_; }
  void ReplacePushes(const std::vector<Push>& pushes, Tick tick) override;
  void Apply(const ActuatorCommand& command) override;
  void Step(Tick tick) override;

 private:
  /// A pushed body or frame: an object of the model.
  struct PushedObject {
    int body{0};
    int site{-1};  ///< -1: the body itself.
  };
  // Addresses in sensordata.
  struct ImuSensors {
    int orientation{0}, gyro{0}, accelerometer{0};
  };
  struct ForceTorqueSensor {
    int force{0}, torque{0};
  };
  struct Foot {
    int site{0};
    int weld{0};    ///< body_weldid of the foot's bodies.
    int touch{-1};  ///< Address in sensordata; -1: it has force/torque sensors instead.
  };

  void ResolveNames(const RobotDescription& robot);
  void ResolveFeet(const RobotDescription& robot);
  void ResolveJoints(const RobotDescription& robot);
  void ResolvePushes(const std::vector<Push>& pushes);
  /// Throws ConfigError if the model has no such sensor.
  int SensorAddress(const std::string& name) const;
  void UpdatePushes(Tick tick);
  /// Writes xfrc_applied whole, zeros included: it persists in mjData.
  void ApplyPushes();
  /// Ground forces on feet, other bodies on the ground, self-contact: after the second half of a
  /// step, before the first half of the next moves the sites.
  void ReadContacts();
  void ReadGroundContact(int contact_id, int robot_body, double sign);
  /// All of truth_ but contacts and pushes: after the first half of a step.
  void ReadState();
  void ReadJoints();
  void ReadFeet();
  void ReadSensors();
  void CheckValid();
  /// Throws ConfigError if a patch of the ground lies in the robot at home.
  void CheckStart(const RobotDescription& robot) const;

  std::shared_ptr<const mjModel> model_;  // the same for all copies
  MjState data_;
  Pushes pushes_;
  std::vector<PushedObject> pushed_;  ///< One a push, as the next.
  std::vector<PushedPose> pushed_poses_;
  double mass_kg_{0.0};
  int base_body_{0};
  BaseJoints base_;
  std::vector<Foot> feet_;
  std::vector<int> joint_;  // of each actuator
  std::vector<JointInfo> joints_;
  JointServos servos_;
  bool is_uneven_;  // the ground, which then has an end
  ImuSensors imu_;
  std::vector<ForceTorqueSensor> force_torque_;
  WorldTruth truth_;            ///< Of the current tick; overwritten in place.
  std::string invalid_reason_;  ///< Empty while valid.
};

}  // namespace sidestep
