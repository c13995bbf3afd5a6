// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// body_tree: a robot between URDF and MJCF: bodies with mass, what hangs on them, their children.
//
// Flow: URDF -> [read_urdf] -> Body tree -> [split_bodies] -> Body tree -> [write_mjcf] -> MJCF.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "models/support/file_notes.h"
#include "models/urdf_to_mjcf/mass_properties.h"

namespace sidestep {

enum class ShapeKind { kBox, kSphere, kCylinder, kCapsule, kMesh };

/// What a URDF says of a mesh, and what is found of it.
struct MeshReference {
  std::string filename;  ///< As in the URDF: a path or `package://name/path`.
  Eigen::Vector3d scale{Eigen::Vector3d::Ones()};
  /// Attributes of the MJCF's `<mesh>` that make it: a file that MuJoCo reads, or all vertices and
  /// faces. Empty if it is not to be drawn.
  std::string mjcf{};
};

/// A primitive or a mesh on a body.
struct Shape {
  std::string name;  ///< As in the URDF; may be empty.
  std::string link;  ///< Of the URDF, that it was read from.
  ShapeKind kind{ShapeKind::kBox};
  /// As MuJoCo wants it (m): half extents of a box; radius of a sphere; radius and half length of
  /// a cylinder or of a capsule without its caps.
  Eigen::Vector3d size_m{Eigen::Vector3d::Zero()};
  Eigen::Isometry3d X_BS{Eigen::Isometry3d::Identity()};  ///< Pose in the body.
  Eigen::Vector4d rgba{0.7, 0.7, 0.7, 1.0};
  bool collides{false};  ///< A collision shape, else one to look at.
  bool is_drawn{true};   ///< Collision shapes show only where a link has nothing else to look at.
  std::optional<MeshReference> mesh{};  ///< Of kMesh; only looked at, even if it should collide.
  TextPlace place{};                    ///< In the URDF.
};

/// A named frame: a link without mass.
struct Frame {
  std::string name;
  Eigen::Isometry3d X_BF{Eigen::Isometry3d::Identity()};
};

/// The joint between a body and its parent.
struct Joint {
  std::string name;
  bool is_slide{false};
  /// Where it is in the body: at its origin, but for links without mass between joint and body.
  Eigen::Vector3d p_BJ{Eigen::Vector3d::Zero()};
  Eigen::Vector3d axis{Eigen::Vector3d::UnitX()};  ///< In the body.
  bool has_range{false};
  double lower{0.0};  ///< rad or m.
  double upper{0.0};
};

struct Body {
  std::string name;
  Eigen::Isometry3d X_PB{Eigen::Isometry3d::Identity()};  ///< Pose in the parent, joint at zero.
  std::optional<Joint> joint;                             ///< Absent: welded, or the base.
  MassProperties mass;                                    ///< In the body's frame.
  std::vector<Shape> shapes;
  std::vector<Frame> frames;
  std::vector<Body> children;
};

/// The body under `root` (itself included) called `name`, or null.
Body* FindBody(Body& root, const std::string& name);

/// The body under `root` that carries the frame called `name`, or null.
Body* FindCarrier(Body& root, const std::string& name);

/// Whether `body`, or one welded to it from below, carries one of the frames.
bool CarriesFrame(const Body& body, const std::vector<std::string>& frames);

/// Calls visit(body) for `root` and all under it, parents first.
template <typename Tree, typename Visitor>
void ForEachBody(Tree& root, Visitor&& visit) {
  visit(root);
  for (auto& child : root.children) ForEachBody(child, visit);
}

}  // namespace sidestep
