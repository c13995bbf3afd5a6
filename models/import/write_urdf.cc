// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/write_urdf.h"

#include <cmath>
#include <map>
#include <sstream>

#include "models/import/text.h"

namespace sidestep::importer {
namespace {

constexpr int kDigits = 12;
constexpr double kNothing = 1e-13;  // what rounding leaves of a zero

std::string Number(double value) {
  return Figure(std::abs(value) < kNothing ? 0.0 : value, kDigits);
}

std::string Numbers(const Eigen::Vector3d& v) {
  return Number(v.x()) + " " + Number(v.y()) + " " + Number(v.z());
}

/// Roll, pitch, yaw; with the pitch at a right angle, all of the rest is yaw.
Eigen::Vector3d Rpy(const Eigen::Matrix3d& R) {
  const double level = std::hypot(R(0, 0), R(1, 0));
  const double pitch = std::atan2(-R(2, 0), level);
  if (level < 1e-9) return {0.0, pitch, std::atan2(-R(0, 1), R(1, 1))};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

/// What a comment may hold: two hyphens would end it.
std::string Comment(std::string text) {
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--")) {
    text.replace(at, 2, "- ");
  }
  return "<!-- " + text + " -->";
}

class UrdfWriter {
 public:
  explicit UrdfWriter(const SourceRobot& robot) : robot_(robot) {}

  std::string Write(const std::string& source) {
    out_ << "<?xml version=\"1.0\"?>\n"
         << Comment("Made by sidestep robots import from " + source) << "\n"
         << "<robot name=\"" << XmlEscaped(robot_.name) << "\">\n";
    WriteMaterials();
    for (const int link : robot_.order) {
      const int above = robot_.joint_above[static_cast<std::size_t>(link)];
      out_ << "\n";
      WriteLink(robot_.links[static_cast<std::size_t>(link)]);
      if (above >= 0) WriteJoint(robot_.joints[static_cast<std::size_t>(above)]);
    }
    out_ << "</robot>\n";
    return out_.str();
  }

 private:
  static std::string Rgba(const Eigen::Vector4d& c) {
    return Number(c[0]) + " " + Number(c[1]) + " " + Number(c[2]) + " " + Number(c[3]);
  }

  void WriteMaterials() {
    for (const SourceLink& link : robot_.links) {
      for (const SourceShape& shape : link.visuals) {
        if (!shape.rgba || materials_.count(Rgba(*shape.rgba)) > 0) continue;
        const std::string name = "colour_" + std::to_string(materials_.size() + 1);
        materials_[Rgba(*shape.rgba)] = name;
        out_ << "  <material name=\"" << name << "\"><color rgba=\"" << Rgba(*shape.rgba)
             << "\"/></material>\n";
      }
    }
  }

  std::string Origin(const Eigen::Isometry3d& X) const {
    const Eigen::Vector3d rpy = Rpy(X.linear());
    std::string text = "<origin xyz=\"" + Numbers(X.translation()) + "\"";
    if (rpy.norm() > kNothing) text += " rpy=\"" + Numbers(rpy) + "\"";
    return text + "/>";
  }

  void WriteLink(const SourceLink& link) {
    if (!link.note.empty()) out_ << "  " << Comment(link.note) << "\n";
    out_ << "  <link name=\"" << XmlEscaped(link.name) << "\"";
    if (!link.has_mass() && link.visuals.empty() && link.collisions.empty()) {
      out_ << "/>\n";
      return;
    }
    out_ << ">\n";
    if (link.has_mass()) WriteInertial(link.mass);
    for (const SourceShape& shape : link.visuals) WriteShape(shape, "visual");
    for (const SourceShape& shape : link.collisions) WriteShape(shape, "collision");
    out_ << "  </link>\n";
  }

  void WriteInertial(const MassProperties& mass) {
    const Eigen::Matrix3d& I = mass.inertia_kgm2;
    out_ << "    <inertial><origin xyz=\"" << Numbers(mass.com_m) << "\"/><mass value=\""
         << Number(mass.mass_kg) << "\"/>\n      <inertia ixx=\"" << Number(I(0, 0)) << "\" ixy=\""
         << Number(I(0, 1)) << "\" ixz=\"" << Number(I(0, 2)) << "\" iyy=\"" << Number(I(1, 1))
         << "\" iyz=\"" << Number(I(1, 2)) << "\" izz=\"" << Number(I(2, 2)) << "\"/></inertial>\n";
  }

  void WriteShape(const SourceShape& shape, const char* tag) {
    if (!shape.note.empty()) out_ << "    " << Comment(shape.note) << "\n";
    out_ << "    <" << tag;
    if (!shape.name.empty()) out_ << " name=\"" << XmlEscaped(shape.name) << "\"";
    out_ << ">" << Origin(shape.X_LS) << "<geometry>" << Geometry(shape) << "</geometry>";
    if (shape.rgba) {
      const auto material = materials_.find(Rgba(*shape.rgba));
      if (material != materials_.end()) out_ << "<material name=\"" << material->second << "\"/>";
    }
    out_ << "</" << tag << ">\n";
  }

  static std::string Geometry(const SourceShape& shape) {
    switch (shape.kind) {
      case ShapeKind::kBox:
        return "<box size=\"" + Numbers(shape.size_m) + "\"/>";
      case ShapeKind::kSphere:
        return "<sphere radius=\"" + Number(shape.size_m.x()) + "\"/>";
      case ShapeKind::kCylinder:
        return "<cylinder radius=\"" + Number(shape.size_m.x()) + "\" length=\"" +
               Number(shape.size_m.y()) + "\"/>";
      case ShapeKind::kMesh:
        break;
    }
    const bool is_scaled = shape.scale != Eigen::Vector3d::Ones();
    return "<mesh filename=\"" + XmlEscaped(shape.mesh) + "\"" +
           (is_scaled ? " scale=\"" + Numbers(shape.scale) + "\"" : "") + "/>";
  }

  void WriteJoint(const SourceJoint& joint) {
    const std::map<JointKind, std::string> types{{JointKind::kFixed, "fixed"},
                                                 {JointKind::kRevolute, "revolute"},
                                                 {JointKind::kContinuous, "continuous"},
                                                 {JointKind::kPrismatic, "prismatic"}};
    if (!joint.note.empty()) out_ << "  " << Comment(joint.note) << "\n";
    out_ << "  <joint name=\"" << XmlEscaped(joint.name) << "\" type=\"" << types.at(joint.kind)
         << "\"><parent link=\"" << NameOf(joint.parent) << "\"/><child link=\""
         << NameOf(joint.child) << "\"/>" << Origin(joint.X_PC);
    if (joint.is_moving()) WriteMotion(joint);
    out_ << "</joint>\n";
  }

  void WriteMotion(const SourceJoint& joint) {
    out_ << "\n    <axis xyz=\"" << Numbers(joint.axis) << "\"/><limit";
    if (joint.has_range()) {
      out_ << " lower=\"" << Number(joint.lower) << "\" upper=\"" << Number(joint.upper) << "\"";
    }
    out_ << " effort=\"" << Number(joint.effort_Nm) << "\" velocity=\""
         << Number(joint.velocity_radps) << "\"/>";
    if (joint.damping_Nms_per_rad > 0.0) {
      out_ << "<dynamics damping=\"" << Number(joint.damping_Nms_per_rad) << "\"/>";
    }
  }

  std::string NameOf(int link) const {
    return XmlEscaped(robot_.links[static_cast<std::size_t>(link)].name);
  }

  const SourceRobot& robot_;
  std::ostringstream out_;
  std::map<std::string, std::string> materials_;  ///< By colour.
};

}  // namespace

std::string UrdfText(const SourceRobot& robot, const std::string& source) {
  return UrdfWriter(robot).Write(source);
}

}  // namespace sidestep::importer
