// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/write_mjcf.h"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <vector>

#include "models/mjcf/ground.h"
#include "models/urdf_to_mjcf/mjcf_text.h"

namespace sidestep {
namespace {

// Contacts of the feet: time constant 4 ms (at least two steps of 2 ms or less), critically damped,
// nearly rigid: a standing robot sinks in by microns. The floor yields to them by priority; a
// listed pair knows no priority, so that the class says it again for pairs.
constexpr char kDefaults[] =
    R"(  <compiler angle="radian" autolimits="true" inertiafromgeom="false"/>
  <default>
    <geom contype="0" conaffinity="0" group="1"/>
    <default class="body">
      <geom conaffinity="1" group="3"/>
    </default>
    <default class="foot">
      <geom conaffinity="1" group="3" condim="3" priority="1" solref="0.004 1" solimp="0.95 0.99 0.002"/>
      <pair condim="3" solref="0.004 1" solimp="0.95 0.99 0.002"/>
    </default>
  </default>
)";

class MjcfWriter {
 public:
  explicit MjcfWriter(const UrdfConversion& conversion) : conversion_(conversion) {}

  UrdfMjcf Write(const std::string& name, const Body& base) {
    xml_ << "<mujoco" << Attribute("model", name) << ">\n" << kDefaults;
    xml_ << "  <asset>\n";
    WriteMaterials(base);
    if (conversion_.has_visuals) WriteMeshes(base);
    xml_ << "  </asset>\n  <worldbody>\n";
    WriteBody(base, nullptr, false, "    ");
    xml_ << "  </worldbody>\n";
    WritePairs();
    WriteActuators();
    WriteSensors();
    xml_ << "</mujoco>\n";
    return {xml_.str(), ground_pairs_.str()};
  }

 private:
  void WriteMaterials(const Body& base) {
    ForEachBody(base, [&](const Body& body) {
      for (const Shape& shape : body.shapes) {
        const std::string rgba = Numbers(shape.rgba);
        if (materials_.contains(rgba)) continue;
        materials_[rgba] = "robot_" + std::to_string(materials_.size());
        xml_ << "    <material" << Attribute("name", materials_[rgba]) << Attribute("rgba", rgba)
             << " specular=\"0.4\" shininess=\"0.6\"/>\n";
      }
    });
  }

  void WriteMeshes(const Body& base) {
    ForEachBody(base, [&](const Body& body) {
      for (const Shape& shape : body.shapes) {
        if (!shape.mesh || shape.mesh->mjcf.empty()) continue;
        const std::string name = "robot_mesh_" + std::to_string(meshes_.size());
        if (!meshes_.emplace(shape.mesh->mjcf, name).second) continue;
        xml_ << "    <mesh" << Attribute("name", name) << shape.mesh->mjcf << "/>\n";
      }
    });
  }

  /// `is_foot` tells of the parent; a moving body is the top of its own weld group.
  void WriteBody(const Body& body, const Body* parent, bool is_foot, const std::string& indent) {
    if (parent == nullptr || body.joint) is_foot = CarriesFrame(body, conversion_.foot_frames);
    const std::string inside = indent + "  ";
    xml_ << indent << "<body" << Attribute("name", body.name) << PoseAttributes(body.X_PB) << ">\n";
    if (parent == nullptr) xml_ << inside << "<freejoint name=\"floating_base\"/>\n";
    if (body.joint) WriteJoint(*body.joint, inside);
    const Eigen::Matrix3d& I = body.mass.inertia_kgm2;
    Eigen::VectorXd inertia_kgm2(6);  // in MuJoCo's order
    inertia_kgm2 << I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2);
    xml_ << inside << "<inertial" << Attribute("pos", Numbers(body.mass.com_m))
         << Attribute("mass", Number(body.mass.mass_kg))
         << Attribute("fullinertia", Numbers(inertia_kgm2)) << "/>\n";
    WriteShapes(body, is_foot, inside);
    for (const Frame& frame : body.frames) {
      xml_ << inside << "<site" << Attribute("name", frame.name) << PoseAttributes(frame.X_BF)
           << " size=\"0.005\" group=\"3\"/>\n";
    }
    for (const Body& child : body.children) WriteBody(child, &body, is_foot, inside);
    xml_ << indent << "</body>\n";
  }

  void WriteJoint(const Joint& joint, const std::string& indent) {
    xml_ << indent << "<joint" << Attribute("name", joint.name)
         << Attribute("type", joint.is_slide ? "slide" : "hinge")
         << Attribute("axis", Numbers(joint.axis));
    if (!joint.p_BJ.isZero(0.0)) xml_ << Attribute("pos", Numbers(joint.p_BJ));
    if (joint.has_range) {
      xml_ << Attribute("range", Number(joint.lower) + " " + Number(joint.upper));
    }
    for (const UrdfActuator& actuator : conversion_.actuators) {
      if (actuator.joint != joint.name) continue;
      xml_ << Attribute("armature", Number(actuator.armature_kgm2))
           << Attribute("damping", Number(actuator.damping_Nms_per_rad));
    }
    xml_ << "/>\n";
  }

  /// Shapes to look at go to a massless body of their own, without a name: MuJoCo leaves bodies out
  /// of its collision search only as a whole, and skipping geoms one by one took a fifth of a step.
  void WriteShapes(const Body& body, bool is_foot, const std::string& indent) {
    std::vector<const Shape*> visuals;
    for (const Shape& shape : body.shapes) {
      if (shape.kind == ShapeKind::kMesh && shape.mesh->mjcf.empty()) continue;
      if (shape.collides) {
        WriteShape(shape, is_foot, indent);
      } else {
        visuals.push_back(&shape);
      }
    }
    if (visuals.empty() || !conversion_.has_visuals) return;
    xml_ << indent << "<body>\n";
    for (const Shape* shape : visuals) WriteShape(*shape, is_foot, indent + "  ");
    xml_ << indent << "</body>\n";
  }

  void WriteShape(const Shape& shape, bool is_foot, const std::string& indent) {
    constexpr std::array<const char*, 5> kTypes{"box", "sphere", "cylinder", "capsule", "mesh"};
    constexpr std::array<Eigen::Index, 5> kSizes{3, 1, 2, 2, 0};
    const auto kind = static_cast<std::size_t>(shape.kind);
    xml_ << indent << "<geom";
    if (shape.collides) {
      std::vector<std::string>& names = collision_names_[shape.link];
      names.push_back(shape.link + "_collision_" + std::to_string(names.size()));
      const std::string contact_class = Attribute("class", is_foot ? "foot" : "body");
      xml_ << Attribute("name", names.back()) << contact_class;
      ground_pairs_ << "    <pair" << contact_class << Attribute("geom1", kGroundGeom)
                    << Attribute("geom2", names.back()) << "/>\n";
      if (shape.is_drawn) xml_ << " group=\"1\"";
    }
    const std::string form = shape.mesh
                                 ? Attribute("mesh", meshes_.at(shape.mesh->mjcf))
                                 : Attribute("size", Numbers(shape.size_m.data(), kSizes[kind]));
    xml_ << Attribute("type", kTypes[kind]) << form << PoseAttributes(shape.X_BS)
         << Attribute("material", materials_.at(Numbers(shape.rgba))) << "/>\n";
  }

  void WritePairs() {
    xml_ << "  <contact>\n";
    for (const UrdfCollisionGroups& groups : conversion_.self_collision) {
      for (const std::string& link1 : groups[0]) {
        for (const std::string& link2 : groups[1]) WritePairsOf(link1, link2);
      }
    }
    xml_ << "  </contact>\n";
  }

  void WritePairsOf(const std::string& link1, const std::string& link2) {
    for (const std::string& geom1 : collision_names_[link1]) {
      for (const std::string& geom2 : collision_names_[link2]) {
        xml_ << "    <pair" << Attribute("geom1", geom1) << Attribute("geom2", geom2) << "/>\n";
      }
    }
  }

  void WriteActuators() {
    xml_ << "  <actuator>\n";
    for (const UrdfActuator& actuator : conversion_.actuators) {
      const std::string limit = Number(actuator.torque_limit_Nm);
      xml_ << "    <motor" << Attribute("name", actuator.joint)
           << Attribute("joint", actuator.joint)
           << Attribute("ctrlrange", "-" + limit + " " + limit) << "/>\n";
    }
    xml_ << "  </actuator>\n";
  }

  void WriteSensors() {
    const std::string& imu = conversion_.imu;
    xml_ << "  <sensor>\n    <framequat" << Attribute("name", imu + "_orientation")
         << " objtype=\"site\"" << Attribute("objname", imu) << "/>\n";
    WriteSensor("gyro", imu, "_gyro");
    WriteSensor("accelerometer", imu, "_accelerometer");
    for (const UrdfForceTorque& sensor : conversion_.force_torque) {
      WriteSensor("force", sensor.name, "_force");
      WriteSensor("torque", sensor.name, "_torque");
    }
    xml_ << "  </sensor>\n";
  }

  void WriteSensor(const char* type, const std::string& site, const char* suffix) {
    xml_ << "    <" << type << Attribute("name", site + suffix) << Attribute("site", site)
         << "/>\n";
  }

  const UrdfConversion& conversion_;
  std::ostringstream xml_;
  std::ostringstream ground_pairs_;
  std::map<std::string, std::string> materials_;                     ///< By colour.
  std::map<std::string, std::string> meshes_;                        ///< By what makes them.
  std::map<std::string, std::vector<std::string>> collision_names_;  ///< Of geoms, by URDF link.
};

}  // namespace

UrdfMjcf WriteMjcf(const std::string& name, const Body& base, const UrdfConversion& conversion) {
  return MjcfWriter(conversion).Write(name, base);
}

}  // namespace sidestep
