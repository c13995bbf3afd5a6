// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// source_robot: a robot as its maker's URDF or MJCF has it, and as the importer changes it.
//
// Flow: URDF, MJCF -> [read_source, read_mjcf] -> SourceRobot -> [clean_up] -> [body_plan,
// fit_sole, fit_shapes, start_pose, choose_motors] -> [write_urdf, write_robot_yaml,
// write_scenarios] -> a folder. Plain data: links and joints are told apart by their index.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "models/support/text_place.h"
#include "models/urdf_to_mjcf/mass_properties.h"

namespace sidestep::importer {

enum class ShapeKind { kBox, kSphere, kCylinder, kMesh };

/// A visual or a collision shape.
struct SourceShape {
  std::string name;
  ShapeKind kind{ShapeKind::kBox};
  /// m. Edges of a box; radius of a sphere; radius and length of a cylinder, along z.
  Eigen::Vector3d size_m{Eigen::Vector3d::Zero()};
  std::string mesh;  ///< As the URDF names the file, the MJCF its mesh.
  Eigen::Vector3d scale{Eigen::Vector3d::Ones()};  ///< Of the mesh; negative mirrors.
  Eigen::Isometry3d X_LS{Eigen::Isometry3d::Identity()};
  std::optional<Eigen::Vector4d> rgba;
  TextPlace place;
  std::string note;  ///< Why it differs from the maker's; becomes a comment.
};

struct SourceLink {
  std::string name;
  MassProperties mass;  ///< In the link's frame; mass_kg 0: a frame.
  std::vector<SourceShape> visuals;
  std::vector<SourceShape> collisions;
  TextPlace place;
  std::string note;

  bool has_mass() const { return mass.mass_kg > 0.0; }
};

enum class JointKind { kFixed, kRevolute, kContinuous, kPrismatic };

struct SourceJoint {
  std::string name;
  JointKind kind{JointKind::kFixed};
  int parent{-1};  ///< Index of a link.
  int child{-1};
  Eigen::Isometry3d X_PC{Eigen::Isometry3d::Identity()};  ///< The child in the parent, at zero.
  Eigen::Vector3d axis{Eigen::Vector3d::UnitX()};         ///< In the child; of length 1.
  double lower{0.0};                                      ///< rad or m.
  double upper{0.0};
  double effort_Nm{0.0};  ///< 0: the URDF says nothing.
  double velocity_radps{0.0};
  double damping_Nms_per_rad{0.0};
  double armature_kgm2{0.0};               ///< Only an MJCF tells; 0: unknown.
  double servo_stiffness_Nm_per_rad{0.0};  ///< Likewise, of a <position>.
  double servo_damping_Nms_per_rad{0.0};
  bool is_mimic{false};  ///< Follows another joint.
  TextPlace place;
  std::string note;

  bool is_moving() const { return kind != JointKind::kFixed; }
  bool has_range() const { return is_moving() && kind != JointKind::kContinuous; }
};

/// What a robot of ours can't have between joints that move.
struct SourceCoupling {
  std::vector<int> joints;
  std::string place;  ///< `file:line:column`.
  std::string what;   ///< A sentence about it.
};

struct SourceRobot {
  std::string name;
  std::string language{"URDF"};  ///< For messages.
  std::vector<SourceLink> links;
  std::vector<SourceJoint> joints;
  int root{0};
  std::vector<int> joint_above;                ///< Of each link; -1 of the root.
  std::vector<std::vector<int>> joints_below;  ///< Of each link.
  std::vector<int> order;                      ///< Links, parents before children.
  std::vector<SourceCoupling> couplings;
};

/// Fills root, joint_above, joints_below and order from links and joints. Returns what is no tree
/// about them, as one sentence; empty if all is well.
std::string ConnectLinks(SourceRobot* robot);

/// Index of the link called `name`, or -1.
int FindLink(const SourceRobot& robot, const std::string& name);

/// `name`, with `_2`, `_3` ... behind it if a link or a joint has it already.
std::string UnusedName(const SourceRobot& robot, const std::string& name);

/// Adds a link without mass on a fixed joint `<name>_fixed`. Returns its index. Connects anew.
int AddFrame(const std::string& name, int parent, const Eigen::Isometry3d& X_PF,
             const std::string& note, SourceRobot* robot);

/// kg, of all links.
double TotalMass_kg(const SourceRobot& robot);

}  // namespace sidestep::importer
