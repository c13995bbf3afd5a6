// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/urdf_to_mjcf.h"

#include <algorithm>

#include "models/support/require.h"
#include "models/urdf_to_mjcf/looks.h"
#include "models/urdf_to_mjcf/read_urdf.h"
#include "models/urdf_to_mjcf/split_bodies.h"
#include "models/urdf_to_mjcf/write_mjcf.h"

namespace sidestep {
namespace {

/// Moving joints on `body`.
void AddJoints(const Body& body, std::vector<std::string>* joints) {
  for (const Body& child : body.children) {
    if (child.joint) joints->push_back(child.joint->name);
  }
}

/// Every moving joint must have exactly one motor.
void CheckActuators(const Body& base, const std::vector<UrdfActuator>& actuators) {
  ForEachBody(base, [&](const Body& body) {
    if (!body.joint) return;
    const auto motors = std::count_if(
        actuators.begin(), actuators.end(),
        [&](const UrdfActuator& actuator) { return actuator.joint == body.joint->name; });
    SIDESTEP_REQUIRE(motors == 1, body.joint->name);
  });
}

}  // namespace

UrdfTree SurveyFor(const std::filesystem::path& urdf, const UrdfConversion& conversion) {
  UrdfTree tree = SurveyUrdf(urdf, conversion.locked_joints);
  NoteFaultyJoints(conversion.locked_joints, &tree);
  NoteMeshCollisions(conversion.foot_frames, &tree);
  FindLooks(conversion.mesh_folders, &tree.base, &tree.notes);
  return tree;
}

UrdfParts ReadUrdfParts(const std::filesystem::path& urdf) {
  const UrdfTree tree = SurveyUrdf(urdf, {});
  UrdfParts parts;
  parts.joints = tree.joints;
  ForEachBody(tree.base, [&](const Body& body) {
    UrdfLinkInfo link{body.name, body.mass, {}, {}};
    AddJoints(body, &link.joints);
    for (const Shape& shape : body.shapes) {
      if (!shape.name.empty()) link.shapes.push_back(shape.name);
    }
    parts.links.push_back(link);
    for (const Frame& frame : body.frames) parts.frames.push_back({frame.name, body.name});
  });
  return parts;
}

UrdfMjcf Convert(UrdfTree tree, const std::string& name, const UrdfConversion& conversion) {
  tree.notes.ThrowProblems();
  CheckActuators(tree.base, conversion.actuators);
  SplitBodies(conversion.force_torque, &tree.base);
  return WriteMjcf(name, tree.base, conversion);
}

UrdfMjcf UrdfToMjcf(const std::filesystem::path& urdf, const UrdfConversion& conversion) {
  return Convert(SurveyFor(urdf, conversion), urdf.stem().string(), conversion);
}

}  // namespace sidestep
