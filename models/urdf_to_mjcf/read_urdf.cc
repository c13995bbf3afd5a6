// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/read_urdf.h"

#include <console_bridge/console.h>
#include <tinyxml.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <utility>

#include "models/mjcf/mjcf.h"
#include "models/support/config_error.h"

namespace sidestep {
namespace {

/// Keeps what urdfdom would print on the console.
class CapturedErrors final : public console_bridge::OutputHandler {
 public:
  CapturedErrors() { console_bridge::useOutputHandler(this); }
  ~CapturedErrors() override { console_bridge::restorePreviousOutputHandler(); }
  CapturedErrors(const CapturedErrors&) = delete;
  CapturedErrors& operator=(const CapturedErrors&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char* /*file*/,
           int /*line*/) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_.empty()) first_ = text;
  }

  /// The first error in one line; urdfdom goes on after some as if all were well.
  std::string first() const {
    std::string line = first_;
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line;
  }

 private:
  std::string first_;
};

Eigen::Isometry3d FromUrdf(const urdf::Pose& pose) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() << pose.position.x, pose.position.y, pose.position.z;
  const urdf::Rotation& q = pose.rotation;
  X.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  return X;
}

bool HasMass(const urdf::Link& link) { return link.inertial && link.inertial->mass != 0.0; }

/// Builds the tree; knows the file's name for its errors.
class TreeReader {
 public:
  TreeReader(std::string file, const std::vector<std::string>& locked_joints)
      : file_(std::move(file)), locked_joints_(locked_joints) {}

  UrdfTree Read(const urdf::ModelInterface& model) {
    urdf::LinkConstSharedPtr link = model.getRoot();
    std::vector<Frame> above;  // poses in the link at hand
    while (!HasMass(*link)) {
      if (link->child_joints.size() != 1 || link->child_joints[0]->type != urdf::Joint::FIXED) {
        Fail("link '" + link->name +
             "' at the root has no mass, so that it needs exactly one child "
             "and a fixed joint");
      }
      const Eigen::Isometry3d X_LC = PoseOf(*link->child_joints[0]);
      above.push_back({link->name, Eigen::Isometry3d::Identity()});
      for (Frame& frame : above) frame.X_BF = X_LC.inverse() * frame.X_BF;
      link = link->child_links[0];
    }
    tree_.base = NewBody(*link);
    tree_.base.frames = above;
    AddLink(*link, Eigen::Isometry3d::Identity(), &tree_.base);
    return std::move(tree_);
  }

 private:
  [[noreturn]] void Fail(const std::string& what) const {
    throw ConfigError(file_ + ": error: " + what);
  }

  Eigen::Isometry3d PoseOf(const urdf::Joint& joint) const {
    return Checked(FromUrdf(joint.parent_to_joint_origin_transform), "joint '" + joint.name + "'");
  }

  Eigen::Isometry3d Checked(const Eigen::Isometry3d& X, const std::string& of) const {
    if (!X.matrix().allFinite()) Fail(of + " has an origin that is not finite");
    return X;
  }

  Body NewBody(const urdf::Link& link) const {
    const urdf::Inertial& inertial = *link.inertial;
    MassProperties mass;
    mass.mass_kg = inertial.mass;
    mass.inertia_kgm2 << inertial.ixx, inertial.ixy, inertial.ixz, inertial.ixy, inertial.iyy,
        inertial.iyz, inertial.ixz, inertial.iyz, inertial.izz;
    Body body;
    body.name = link.name;
    if (!IsPhysical(mass)) Fail("link '" + link.name + "' has a mass or inertia that no body has");
    body.mass = InFrame(Checked(FromUrdf(inertial.origin), "link '" + link.name + "'"), mass);
    return body;
  }

  /// Adds what `link`, fixed to `body` with pose X_BL, has and carries.
  void AddLink(const urdf::Link& link, const Eigen::Isometry3d& X_BL, Body* body) {
    AddShapes(link, X_BL, body);
    for (const urdf::JointSharedPtr& joint : link.child_joints) {
      const Eigen::Isometry3d X_BC = X_BL * PoseOf(*joint);
      const auto child = std::find_if(
          link.child_links.begin(), link.child_links.end(),
          [&](const urdf::LinkSharedPtr& other) { return other->name == joint->child_link_name; });
      AddChild(*joint, **child, X_BC, body);
    }
  }

  void AddChild(const urdf::Joint& joint, const urdf::Link& link, const Eigen::Isometry3d& X_BC,
                Body* body) {
    const std::optional<Joint> moving = MovingJoint(joint);
    if (!HasMass(link)) {
      if (moving) Fail("joint '" + joint.name + "' moves a link without mass, '" + link.name + "'");
      body->frames.push_back({link.name, X_BC});
      AddLink(link, X_BC, body);
      return;
    }
    Body child = NewBody(link);
    child.X_PB = X_BC;
    child.joint = moving;
    AddLink(link, Eigen::Isometry3d::Identity(), &child);
    body->children.push_back(std::move(child));
  }

  std::optional<Joint> MovingJoint(const urdf::Joint& joint) {
    if (joint.type == urdf::Joint::FIXED) return std::nullopt;
    const bool is_hinge =
        joint.type == urdf::Joint::REVOLUTE || joint.type == urdf::Joint::CONTINUOUS;
    if (!is_hinge && joint.type != urdf::Joint::PRISMATIC) {
      Fail("joint '" + joint.name + "' is neither fixed, revolute, continuous nor prismatic");
    }
    if (joint.mimic) Fail("joint '" + joint.name + "' mimics another, which can't be simulated");
    UrdfJointInfo info{joint.name};
    if (joint.limits) {
      info.effort_Nm = joint.limits->effort;
      info.velocity_radps = joint.limits->velocity;
    }
    if (joint.dynamics) info.damping_Nms_per_rad = joint.dynamics->damping;
    tree_.joints.push_back(info);
    if (std::find(locked_joints_.begin(), locked_joints_.end(), joint.name) !=
        locked_joints_.end()) {
      return std::nullopt;
    }
    Joint moving;
    moving.name = joint.name;
    moving.is_slide = !is_hinge;
    moving.axis << joint.axis.x, joint.axis.y, joint.axis.z;
    moving.has_range = joint.type != urdf::Joint::CONTINUOUS && joint.limits;
    if (moving.has_range) {
      moving.lower = joint.limits->lower;
      moving.upper = joint.limits->upper;
    }
    return moving;
  }

  void AddShapes(const urdf::Link& link, const Eigen::Isometry3d& X_BL, Body* body) const {
    bool has_visual = false;
    for (const urdf::VisualSharedPtr& visual : link.visual_array) {
      if (!visual->geometry || visual->geometry->type == urdf::Geometry::MESH) continue;
      Shape shape = ShapeOf(link, visual->name, *visual->geometry, X_BL, visual->origin);
      if (visual->material) {
        const urdf::Color& color = visual->material->color;
        shape.rgba << static_cast<double>(color.r), static_cast<double>(color.g),
            static_cast<double>(color.b), static_cast<double>(color.a);
      }
      body->shapes.push_back(shape);
      has_visual = true;
    }
    for (const urdf::CollisionSharedPtr& collision : link.collision_array) {
      if (!collision->geometry || collision->geometry->type == urdf::Geometry::MESH) {
        Fail("link '" + link.name +
             "' has a mesh as its collision shape; use boxes, spheres and cylinders");
      }
      Shape shape = ShapeOf(link, collision->name, *collision->geometry, X_BL, collision->origin);
      shape.collides = true;
      shape.is_drawn = !has_visual;
      body->shapes.push_back(shape);
    }
  }

  Shape ShapeOf(const urdf::Link& link, const std::string& name, const urdf::Geometry& geometry,
                const Eigen::Isometry3d& X_BL, const urdf::Pose& origin) const {
    Shape shape;
    shape.name = name;
    shape.link = link.name;
    shape.X_BS = X_BL * Checked(FromUrdf(origin), "a shape of link '" + link.name + "'");
    if (geometry.type == urdf::Geometry::BOX) {
      const urdf::Vector3& size = static_cast<const urdf::Box&>(geometry).dim;
      shape.size_m << 0.5 * size.x, 0.5 * size.y, 0.5 * size.z;
    } else if (geometry.type == urdf::Geometry::SPHERE) {
      shape.kind = ShapeKind::kSphere;
      shape.size_m.x() = static_cast<const urdf::Sphere&>(geometry).radius;
    } else {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
      const bool is_long = cylinder.length > 2.0 * cylinder.radius;
      shape.kind = is_long ? ShapeKind::kCapsule : ShapeKind::kCylinder;
      shape.size_m << cylinder.radius, 0.5 * cylinder.length - (is_long ? cylinder.radius : 0.0),
          0.0;
    }
    return shape;
  }

  std::string file_;
  const std::vector<std::string>& locked_joints_;
  UrdfTree tree_;
};

}  // namespace

UrdfTree ReadUrdf(const std::filesystem::path& urdf,
                  const std::vector<std::string>& locked_joints) {
  const std::string text = ReadTextFile(urdf);
  TiXmlDocument document;
  document.Parse(text.c_str());
  if (document.Error()) {
    throw ConfigError(urdf.string(), std::max(document.ErrorRow(), 1),
                      std::max(document.ErrorCol(), 1), document.ErrorDesc());
  }
  const CapturedErrors errors;
  const urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(text);
  if (!errors.first().empty()) throw ConfigError(urdf.string() + ": error: " + errors.first());
  if (!model || !model->getRoot()) throw ConfigError(urdf.string() + ": error: is no URDF");
  return TreeReader(urdf.string(), locked_joints).Read(*model);
}

}  // namespace sidestep
