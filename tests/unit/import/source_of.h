// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// source_of: a maker's robot, read.

#include <string>

#include "models/import/read_source.h"
#include "tests/support/maker_robot.h"
#include "tests/support/temp_folder.h"

namespace sidestep::importer {

inline SourceRobot SourceOf(const std::string& urdf) {
  const TempFolder folder;
  Notes notes;
  return ReadSource(folder.Write("robot.urdf", urdf), &notes);
}

inline SourceRobot SourceOf(const MakerRobot& robot) { return SourceOf(UrdfOf(robot)); }

inline int JointCalled(const SourceRobot& robot, const std::string& name) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (robot.joints[i].name == name) return static_cast<int>(i);
  }
  ADD_FAILURE() << "no joint " << name;
  return 0;
}

}  // namespace sidestep::importer
