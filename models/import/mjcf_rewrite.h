// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_rewrite: what of a maker's MJCF makes a robot, in words that the MuJoCo at hand understands.
//
// Bodies, shapes, classes, materials' colours and actuators of joints stay. Floors, lights,
// cameras, options, keyframes, sensors go: the world is ours. Of what is newer than our MuJoCo
//   actuatorfrcrange   of a joint becomes its `user` numbers, so that classes still hand it down
//   kv, dampratio      of <position> become the actuator's `user` number, likewise
//   <frame>            becomes a body without a name, welded
//   autolimits         is on where the file says nothing, as MuJoCo has it today
//   what changes nothing that we read (inheritrange, maxhullvert ...) is taken out
// and all that is left is a problem with its line and what to delete.

#include <map>
#include <set>
#include <string>
#include <vector>

#include "models/import/mesh_files.h"
#include "models/import/problems.h"
#include "models/import/xml_tree.h"

namespace sidestep::importer {

/// Something in the file that our robot would lack if one of these joints moved.
struct Coupling {
  std::vector<std::string> joints;  ///< Names; or ...
  std::vector<std::string> bodies;  ///< ... two, and it is all joints between them.
  std::string place;                ///< `file:line:column`.
  std::string what;                 ///< A sentence about it.
};

struct MjcfParts {
  XmlElement root;  ///< The document to be compiled.
  std::map<std::string, std::string>
      places;                    ///< `file:line:column` of "body NAME" and "joint NAME".
  std::set<std::string> mimics;  ///< Joints that an equality ties to others.
  std::vector<Coupling> couplings;
};

/// Rewrites. Meshes get the real path of their file as far as `files` may read it; one that is not
/// there is complained of and becomes a stand-in. Problems are added, and none thrown.
MjcfParts RewriteMjcf(const XmlTree& tree, MeshFiles* files, Problems* problems, Notes* notes);

}  // namespace sidestep::importer
