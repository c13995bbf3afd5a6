// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// world: what a plant offers to the episode. Its truth goes to sensors, recorder and verdict only.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

#include "controller/types/actuator_command.h"
#include "controller/types/sensor_frame.h"
#include "controller/types/tick.h"
#include "sim/scenario/scenario.h"

namespace sidestep {

/// A foot as it is. The force belongs to the step that led to this state.
struct FootTruth {
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v_WF{Eigen::Vector3d::Zero()};
  Eigen::Vector3d f_F_W{Eigen::Vector3d::Zero()};  ///< Ground on robot (N).
  double touch_N{0.0};  ///< Normal force as a perfect touch sensor reads it.
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
  Eigen::Vector3d p_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d v_WC{Eigen::Vector3d::Zero()};
  Eigen::Vector3d angular_momentum{Eigen::Vector3d::Zero()};  ///< h_C_W.
  ImuSample imu;  ///< As a perfect unit reads; the acceleration of the step that led here.
  std::vector<FootTruth> feet;
  std::vector<PushTruth> pushes;    ///< One a scripted push; zero force while it does not act.
  bool body_touches_ground{false};  ///< Anything but a foot.
  double actuator_power_W{0.0};     ///< Sum of |torque times velocity|.
};

/// A plant: something with feet that commands move and pushes disturb.
class World {
 public:
  virtual ~World() = default;

  /// State at the current tick.
  virtual const WorldTruth& truth() const = 0;

  /// False once the physics diverged: non-finite state or a MuJoCo warning. Never true again.
  virtual bool is_valid() const = 0;

  /// Why is_valid() is false, in one line.
  virtual const std::string& invalid_reason() const = 0;

  virtual double mass_kg() const = 0;
  virtual const std::vector<std::string>& joint_names() const = 0;

  /// Takes the command that acts from now on, until the next one.
  virtual void Apply(const ActuatorCommand& command) = 0;

  /// Advances by one tick under the last command and the pushes of `tick`.
  virtual void Step(Tick tick) = 0;
};

/// Makes the plant that the scenario asks for.
std::unique_ptr<World> MakeWorld(const Scenario& scenario);

}  // namespace sidestep
