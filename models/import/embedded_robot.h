// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// embedded_robot: an exported MJCF that carries the files of the robot it was made from, so that an
// import of it is that robot again, bit for bit.
//
// They stand in <custom><text>, which MuJoCo reads and nobody simulates, with a checksum of all the
// document. Who edits the MJCF, even in a number, gets the robot that it then tells of.

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "models/robot_description/robot_description.h"

namespace sidestep::importer {

/// Names, without folders, and texts. The first is the robot.yaml.
using RobotFiles = std::vector<std::pair<std::string, std::string>>;

/// `mjcf`, a whole document, with robot.yaml and the model's file in it. Unchanged if these are not
/// all that the robot needs: without a model, a model in another folder, one that opens other
/// files. Meshes to look at are not carried. Throws ConfigError if a file can't be read.
std::string WithRobotFiles(const std::string& mjcf, const RobotDescription& robot);

/// The files in `mjcf`, or nothing: there are none, or it was edited since.
std::optional<RobotFiles> RobotFilesIn(const std::string& mjcf);

}  // namespace sidestep::importer
