// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// robot_faults: what is wrong with a robot as it starts, though each key of its file is well: where
// its soles are, its joints, its CoM, its legs, what its feet feel.
//
// In : RobotDescription, its model at home.     Out: one fault a thing to mend, with numbers.
// Every rule is a bound named in robot_faults.cc or foot_faults.cc, wide enough for figures of
// three decimals. A robot without a model has no faults.

#include <filesystem>
#include <string>
#include <vector>

#include "models/robot_description/robot_description.h"

namespace sidestep {

/// One thing to mend.
struct RobotFault {
  std::string key;   ///< Of robot.yaml, dotted, such as `feet.0.frame`.
  std::string what;  ///< Follows the key and a blank: "= 0.79 is ...".
};

/// Reads a robot.yaml as ReadRobotDescription() does, and throws ConfigError with a line for each
/// of RobotFaults(), at the place of its key, if there are any.
RobotDescription ReadSoundRobot(const std::filesystem::path& file);

/// All of them, in the order of robot.yaml's keys as far as one thing goes. Throws ConfigError for
/// names that the model lacks.
std::vector<RobotFault> RobotFaults(const RobotDescription& robot);

}  // namespace sidestep
