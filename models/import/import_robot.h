// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// import_robot: a maker's URDF or MJCF as a robot that stands and walks here.
//
// In : a URDF or an MJCF as it is.    Out: a folder with robot.urdf, robot.yaml, meshes/ and three
// scenarios. What it finds out, it writes; where a person must decide, it says `# decide:`.

#include <filesystem>
#include <string>
#include <vector>

#include "models/import/mesh_files.h"
#include "models/import/problems.h"

namespace sidestep::importer {

struct ImportOptions {
  std::filesystem::path source;  ///< The URDF or MJCF.
  std::filesystem::path folder;  ///< Made if need be; files of the same names are replaced.
  std::string name;              ///< Of the robot; empty: the source's.
  std::string mode;              ///< position or torque, for the scenarios; empty: position.
  Packages packages;
  bool has_meshes{true};  ///< Whether visual meshes are copied.
};

/// What a person wants to know of it.
struct ImportReport {
  Notes done;                      ///< Changes, one sentence each.
  Notes found;                     ///< Facts: legs, soles, pose, gains.
  Notes to_decide;                 ///< Lines of robot.yaml that need a person.
  std::vector<std::string> files;  ///< Written, relative to the folder.
};

/// Imports. Throws ConfigError with all problems, each with its line, where the source can't become
/// a robot here; nothing is written then. Of an export that carries its robot: see restore_robot.h.
ImportReport ImportRobot(const ImportOptions& options);

}  // namespace sidestep::importer
