// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// robot_memory: robots that were read before. Building the iCub's model takes 20 ms, a thirtieth of
// a run after its push.

#include <filesystem>
#include <map>
#include <string>

#include "models/robot_description/robot_description.h"

namespace sidestep {

/// Remembers every robot.yaml by what stands in it and in its model's own file.
class RobotMemory {
 public:
  /// As ReadRobotDescription, and the same: a robot whose files have changed is read anew. What a
  /// model includes is not looked at again.
  RobotDescription Read(const std::filesystem::path& file);

 private:
  struct Known {
    std::string text;        // of the robot.yaml
    std::string model_text;  // empty without a model
    RobotDescription robot;
  };
  std::map<std::filesystem::path, Known> known_;
};

}  // namespace sidestep
