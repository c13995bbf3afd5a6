// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// world: what a plant offers to the episode. Its truth goes to sensors, recorder and verdict only.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "controller/types/actuator_command.h"
#include "controller/types/sensor_frame.h"
#include "controller/types/tick.h"
#include "controller/types/wrench.h"
#include "sim/scenario/push.h"

namespace sidestep {

/// A foot as it is. The force belongs to the step that led to this state.
struct FootTruth {
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};
  Eigen::Matrix3d R_WF{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d v_WF{Eigen::Vector3d::Zero()};
  Eigen::Vector3d f_F_W{Eigen::Vector3d::Zero()};  ///< Ground on robot (N).
  Eigen::Vector3d m_F_W{Eigen::Vector3d::Zero()};  ///< Its moment about F (N m).
  double touch_N{0.0};  ///< Normal force: as a perfect touch sensor reads it, else of f_F_W.
  bool in_contact{false};
};

/// A push as it acts now.
struct PushTruth {
  Eigen::Vector3d force_W_N{Eigen::Vector3d::Zero()};
  Eigen::Vector3d p_W{Eigen::Vector3d::Zero()};  ///< Where it acts.
};

/// The state of the world at a tick.
struct WorldTruth {
  Eigen::VectorXd qpos;  ///< Of the world's mjModel: what a recording replays.
  Eigen::Vector3d p_WB{Eigen::Vector3d::Zero()};
  Eigen::Quaterniond q_WB{Eigen::Quaterniond::Identity()};
  Eigen::Vector3d v_WB{Eigen::Vector3d::Zero()};    ///< Of B's origin, in W.
  Eigen::Vector3d w_WB_B{Eigen::Vector3d::Zero()};  ///< In B.
  Eigen::VectorXd joint_position;                   ///< Order of the actuators.
  Eigen::VectorXd joint_velocity;
  Eigen::VectorXd joint_torque_Nm;  ///< Of the motors, in the step that led here; N for a slide.
  int num_saturated{0};             ///< Motors that were asked for more than they can, in it.
  Eigen::Vector3d p_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d angular_momentum{Eigen::Vector3d::Zero()};  ///< h_C_W.
  ImuSample imu;  ///< As a perfect unit reads; the acceleration of the step that led here.
  std::vector<FootTruth> feet;
  /// As perfect sensors read, in the order of the robot's: distal on proximal, in the sensor's
  /// site, about its origin; of the step that led here.
  std::vector<Wrench> force_torque;
  std::vector<PushTruth> pushes;     ///< One a scripted push; zero force while it does not act.
  bool body_touches_ground{false};   ///< Anything but a foot.
  double self_contact_depth_m{0.0};  ///< Deepest that two bodies of the robot are in each other.
  double actuator_power_W{0.0};      ///< Sum of |torque times velocity|.
};

/// An actuated joint of a plant. Bounds are infinite where the model has none.
struct JointInfo {
  std::string name;
  bool is_slide{false};  ///< In m and N, not rad and N m.
  double position_min{-std::numeric_limits<double>::infinity()};
  double position_max{std::numeric_limits<double>::infinity()};
  double torque_limit_Nm{std::numeric_limits<double>::infinity()};  ///< The greater way.
};

/// A plant: something with feet that commands move and pushes disturb.
class World {
 public:
  virtual ~World() = default;

  /// A world of its own in the same state, at the same tick: under the same commands both go on bit
  /// for bit alike, and neither disturbs the other.
  virtual std::unique_ptr<World> Clone() const = 0;

  /// State at the current tick.
  virtual const WorldTruth& truth() const = 0;

  /// False once the physics diverged: non-finite state or a MuJoCo warning. Never true again.
  virtual bool is_valid() const = 0;

  /// Why is_valid() is false, in one line.
  virtual const std::string& invalid_reason() const = 0;

  virtual double mass_kg() const = 0;

  /// In the order of the actuators.
  virtual const std::vector<JointInfo>& joints() const = 0;

  /// Other pushes instead of those it has, at its current tick `tick`. None of either may act at or
  /// before `tick`. Throws ConfigError for a body that the robot lacks.
  virtual void ReplacePushes(const std::vector<Push>& pushes, Tick tick) = 0;

  /// Takes the command that acts from now on, until the next one.
  virtual void Apply(const ActuatorCommand& command) = 0;

  /// Advances by one tick under the last command and the pushes of `tick`.
  virtual void Step(Tick tick) = 0;

 protected:
  World() = default;
  World(const World&) = default;  // by Clone() only: a World& must not be copied in part
  World& operator=(const World&) = default;
};

}  // namespace sidestep
