// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with a URDF only for a certain robot.yaml: what it locks, which links are feet.
#include <algorithm>

#include "models/urdf_to_mjcf/read_urdf.h"

namespace sidestep {
namespace {

bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Links that collide with meshes only, or also with meshes.
struct MeshLinks {
  std::vector<std::string> names;
  TextPlace first;

  void Add(const Shape& shape) {
    if (Contains(names, shape.link)) return;
    const bool is_first = names.empty() || shape.place.line < first.line;
    if (is_first) first = shape.place;
    names.push_back(shape.link);
  }

  std::string Listed() const {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
  }
};

bool IsMesh(const Shape& shape) { return shape.collides && shape.kind == ShapeKind::kMesh; }
bool IsPrimitive(const Shape& shape) { return shape.collides && shape.kind != ShapeKind::kMesh; }

/// Calls visit(shape) for all shapes of `body` and what is welded to it.
template <typename Visitor>
void ForEachWeldedShape(const Body& body, Visitor&& visit) {
  for (const Shape& shape : body.shapes) visit(shape);
  for (const Body& child : body.children) {
    if (!child.joint) ForEachWeldedShape(child, visit);
  }
}

}  // namespace

void NoteFaultyJoints(const std::vector<std::string>& locked_joints, UrdfTree* tree) {
  std::string taken;
  TextPlace first;
  for (const UrdfJointInfo& joint : tree->joints) {
    if (joint.fault.empty()) continue;
    if (!Contains(locked_joints, joint.name)) {
      tree->notes.Problem(joint.place,
                          "joint '" + joint.name + "' " + joint.fault +
                              "; list it in locked_joints of robot.yaml, or mend it here");
      continue;
    }
    if (taken.empty()) first = joint.place;
    taken += (taken.empty() ? "" : "; ") + joint.name + " " + joint.fault;
  }
  if (!taken.empty()) {
    tree->notes.Notice(first, "locked joints, which could not move here anyway: " + taken);
  }
}

void NoteMeshCollisions(const std::vector<std::string>& foot_frames, UrdfTree* tree) {
  MeshLinks left_out, bare_feet;
  ForEachBody(tree->base, [&](const Body& body) {
    if (!body.joint && &body != &tree->base) return;  // of the group above
    bool has_primitive = false;
    ForEachWeldedShape(body, [&](const Shape& shape) { has_primitive |= IsPrimitive(shape); });
    const bool is_bare_foot = !has_primitive && CarriesFrame(body, foot_frames);
    ForEachWeldedShape(body, [&](const Shape& shape) {
      if (IsMesh(shape)) (is_bare_foot ? bare_feet : left_out).Add(shape);
    });
  });
  if (!bare_feet.names.empty()) {
    tree->notes.Problem(bare_feet.first,
                        "feet have only meshes to stand on, in the links " + bare_feet.Listed() +
                            "; give each foot a <collision> with a box for its sole");
  }
  if (!left_out.names.empty()) {
    tree->notes.Notice(
        left_out.first,
        "meshes don't collide here; they are left out of the links " + left_out.Listed());
  }
}

}  // namespace sidestep
