// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/urdfdom_model.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

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

  /// The first error; urdfdom goes on after some as if all were well.
  const std::string& first() const { return first_; }

 private:
  std::string first_;
};

Shape ShapeOf(const urdf::Link& link, const urdf::Geometry& geometry) {
  Shape shape;
  shape.link = link.name;
  if (geometry.type == urdf::Geometry::BOX) {
    const urdf::Vector3& size = static_cast<const urdf::Box&>(geometry).dim;
    shape.size_m << 0.5 * size.x, 0.5 * size.y, 0.5 * size.z;
  } else if (geometry.type == urdf::Geometry::SPHERE) {
    shape.kind = ShapeKind::kSphere;
    shape.size_m.x() = static_cast<const urdf::Sphere&>(geometry).radius;
  } else if (geometry.type == urdf::Geometry::MESH) {
    const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
    shape.kind = ShapeKind::kMesh;
    shape.mesh = MeshReference{mesh.filename, {mesh.scale.x, mesh.scale.y, mesh.scale.z}};
  } else {
    const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
    const bool is_long = cylinder.length > 2.0 * cylinder.radius;
    shape.kind = is_long ? ShapeKind::kCapsule : ShapeKind::kCylinder;
    shape.size_m << cylinder.radius, 0.5 * cylinder.length - (is_long ? cylinder.radius : 0.0), 0.0;
  }
  return shape;
}

}  // namespace

std::shared_ptr<urdf::ModelInterface> ParseUrdf(const UrdfDocument& document,
                                                const std::string& file) {
  const CapturedErrors errors;
  urdf::ModelInterfaceSharedPtr model = urdf::parseURDF(document.Text());
  if (!errors.first().empty()) throw ConfigError(std::vector{file + ": error: " + errors.first()});
  if (!model || !model->getRoot()) throw ConfigError(file + ": error: is no URDF");
  return model;
}

Eigen::Isometry3d FromUrdf(const urdf::Pose& pose) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() << pose.position.x, pose.position.y, pose.position.z;
  const urdf::Rotation& q = pose.rotation;
  X.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  return X;
}

MassProperties MassOf(const urdf::Link& link) {
  MassProperties mass;
  if (!link.inertial) return mass;
  const urdf::Inertial& inertial = *link.inertial;
  mass.mass_kg = inertial.mass;
  mass.inertia_kgm2 << inertial.ixx, inertial.ixy, inertial.ixz, inertial.ixy, inertial.iyy,
      inertial.iyz, inertial.ixz, inertial.iyz, inertial.izz;
  return InFrame(FromUrdf(inertial.origin), mass);
}

std::vector<Shape> ShapesOf(const urdf::Link& link, const Eigen::Isometry3d& X_BL,
                            const UrdfDocument& document) {
  std::vector<Shape> shapes;
  for (const urdf::VisualSharedPtr& visual : link.visual_array) {
    Shape shape = ShapeOf(link, *visual->geometry);
    shape.name = visual->name;
    shape.X_BS = X_BL * FromUrdf(visual->origin);
    shape.place = document.Place("link", link.name, "visual", shapes.size());
    if (visual->material) {
      const urdf::Color& color = visual->material->color;
      shape.rgba << static_cast<double>(color.r), static_cast<double>(color.g),
          static_cast<double>(color.b), static_cast<double>(color.a);
    }
    shapes.push_back(std::move(shape));
  }
  const std::size_t num_visuals = shapes.size();
  for (const urdf::CollisionSharedPtr& collision : link.collision_array) {
    Shape shape = ShapeOf(link, *collision->geometry);
    shape.name = collision->name;
    shape.X_BS = X_BL * FromUrdf(collision->origin);
    shape.place = document.Place("link", link.name, "collision", shapes.size() - num_visuals);
    shape.collides = true;
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

}  // namespace sidestep
