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

#include "models/urdf_to_mjcf/mass_properties.h"

namespace sidestep {

enum class ShapeKind { kBox, kSphere, kCylinder, kCapsule };

/// A primitive on a body.
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
};

/// A named frame: a link without mass.
struct Frame {
  std::string name;
  Eigen::Isometry3d X_BF{Eigen::Isometry3d::Identity()};
};

/// The joint between a body and its parent, at the body's origin.
struct Joint {
  std::string name;
  bool is_slide{false};
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

/// Calls visit(body) for `root` and all under it, parents first.
template <typename Tree, typename Visitor>
void ForEachBody(Tree& root, Visitor&& visit) {
  visit(root);
  for (auto& child : root.children) ForEachBody(child, visit);
}

}  // namespace sidestep
