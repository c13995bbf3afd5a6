// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/robot_memory.h"

#include <utility>

#include "models/mjcf/mjcf.h"
#include "models/robot_description/robot_faults.h"

namespace sidestep {
namespace {

std::string ModelText(const RobotDescription& robot) {
  return robot.model ? ReadTextFile(robot.model->file) : "";
}

}  // namespace

RobotDescription RobotMemory::Read(const std::filesystem::path& file) {
  std::string text = ReadTextFile(file);
  const auto found = known_.find(file);
  if (found != known_.end() && found->second.text == text &&
      found->second.model_text == ModelText(found->second.robot)) {
    return found->second.robot;
  }
  Known known{std::move(text), "", ReadSoundRobot(file)};
  known.model_text = ModelText(known.robot);
  return known_.insert_or_assign(file, std::move(known)).first->second.robot;
}

}  // namespace sidestep
