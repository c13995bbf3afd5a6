// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_names: what an MJCF calls its parts, as MuJoCo's compiler sees them.

#include <mujoco/mujoco.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sidestep {

/// An actuator that torque control can't use as it is.
struct UnfitMotor {
  std::string joint;          ///< That it moves.
  std::string what;           ///< Follows "the motor of '<joint>' ".
  bool lacks_a_limit{false};  ///< It is a motor all the same.
};

/// Names in the order of the compiled model; unnamed parts are left out.
struct MjcfNames {
  std::vector<std::string> bodies;           ///< But the world.
  std::vector<std::string> floating_bodies;  ///< Those that base_joints.h takes for a base.
  std::vector<std::string> sites;
  std::vector<std::string> joints;  ///< Hinges and slides, but a base's.
  std::vector<std::string> sensors;
  /// Children of the world with joints that are no base, and why: see BaseFault().
  std::map<std::string, std::string> base_faults;
  std::vector<UnfitMotor> unfit_motors;
  /// That the actuators move, in their order; without those that act on no joint or a nameless one.
  std::vector<std::string> motor_joints;
};

/// Names of a compiled model.
MjcfNames NamesOf(const mjModel& model);

/// Compiles an MJCF. Throws ConfigError with MuJoCo's message, as `file:line:column: error: ...`
/// where MuJoCo tells the place, else `file: error: ...`.
MjcfNames ReadMjcfNames(const std::filesystem::path& mjcf);

}  // namespace sidestep
