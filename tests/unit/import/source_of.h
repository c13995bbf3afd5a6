// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// source_of: a maker's robot, read.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "models/import/read_mjcf.h"
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

/// @param notes  May be null.
inline SourceRobot SourceOfMjcf(const std::string& mjcf, Notes* notes = nullptr) {
  const TempFolder folder;
  const std::filesystem::path file = folder.Write("robot.xml", mjcf);
  MeshFiles files(file, {});
  Notes own;
  return ReadMjcf(file, &files, notes == nullptr ? &own : notes);
}

/// What reading the MJCF complains of, with the file called robot.xml.
inline std::string MjcfErrorOf(const std::string& mjcf) {
  const TempFolder folder;
  const std::filesystem::path file = folder.Write("robot.xml", mjcf);
  MeshFiles files(file, {});
  Notes notes;
  return folder.ErrorOf([&] { ReadMjcf(file, &files, &notes); });
}

inline bool HasNote(const Notes& notes, const std::string& part) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

inline int JointCalled(const SourceRobot& robot, const std::string& name) {
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (robot.joints[i].name == name) return static_cast<int>(i);
  }
  ADD_FAILURE() << "no joint " << name;
  return 0;
}

inline const SourceLink& LinkCalled(const SourceRobot& robot, const std::string& name) {
  const int link = FindLink(robot, name);
  EXPECT_GE(link, 0) << "no link " << name;
  return robot.links[static_cast<std::size_t>(std::max(link, 0))];
}

/// A pelvis on which `inside` hangs, a leg's worth of one hinge, and what `after` says.
inline std::string SmallMjcf(const std::string& inside, const std::string& after = "",
                             const std::string& before = "") {
  return "<mujoco>\n" + before +
         "<worldbody><body name=\"pelvis\"><freejoint/>\n<inertial pos=\"0 0 0\" mass=\"3\" "
         "diaginertia=\"1 1 1\"/>\n<body name=\"leg\"><inertial pos=\"0 0 0\" mass=\"2\" "
         "diaginertia=\"1 1 1\"/>\n<joint name=\"hip\" range=\"-1 1\"/></body>\n" +
         inside + "</body></worldbody>\n" + after + "</mujoco>\n";
}

}  // namespace sidestep::importer
