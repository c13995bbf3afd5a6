// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/read_source.h"

#include <tinyxml.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "models/import/xml_values.h"
#include "models/support/xml_bounds.h"
#include "models/urdf_to_mjcf/parse_xml.h"
#include "models/urdf_to_mjcf/urdf_elements.h"
#include "models/urdf_to_mjcf/urdf_graph.h"

namespace sidestep::importer {
namespace {

class SourceReader {
 public:
  SourceReader(const std::filesystem::path& urdf, Notes* notes)
      : problems_(urdf.string()), values_(&problems_), notes_(notes) {}

  SourceRobot Read(const TiXmlElement& root) {
    if (root.ValueStr() != "robot") {
      problems_.Add(PlaceOf(root), "the outermost element must be <robot>");
      problems_.ThrowIfAny();
    }
    if (const char* name = root.Attribute("name")) robot_.name = name;
    ReadMaterials(root);
    for (const TiXmlElement* e = root.FirstChildElement(); e; e = e->NextSiblingElement()) {
      const std::string& tag = e->ValueStr();
      if (tag == "link") ReadLink(*e);
      if (tag.rfind("xacro:", 0) == 0)
        values_.Add(*e, "is xacro; expand the file first: xacro FILE -o robot.urdf");
      if (tag != "link" && tag != "joint" && tag != "material") ++passed_over_[tag];
    }
    problems_.ThrowIfAny();
    for (const TiXmlElement* e = root.FirstChildElement("joint"); e;
         e = e->NextSiblingElement("joint")) {
      ReadJoint(*e);
    }
    if (robot_.links.empty()) problems_.Add(PlaceOf(root), "has no links");
    problems_.ThrowIfAny();
    DropFloatingRoot();
    const std::string fault = ConnectLinks(&robot_);
    if (!fault.empty()) problems_.Add(PlaceOf(root), fault);
    problems_.ThrowIfAny();
    for (const auto& [tag, count] : passed_over_) {
      notes_->push_back("passed over " + std::to_string(count) + " <" + tag + ">");
    }
    return std::move(robot_);
  }

 private:
  void ReadMaterials(const TiXmlElement& root) {
    for (const TiXmlElement* e = root.FirstChildElement("material"); e;
         e = e->NextSiblingElement("material")) {
      const char* name = e->Attribute("name");
      const std::optional<Eigen::Vector4d> rgba = values_.Colour(*e);
      if (name != nullptr && rgba) materials_[name] = *rgba;
    }
  }

  void ReadLink(const TiXmlElement& element) {
    SourceLink link;
    link.place = PlaceOf(element);
    link.name = values_.Name(element);
    if (!links_.insert({link.name, static_cast<int>(robot_.links.size())}).second) {
      values_.Add(element, "= '" + link.name + "' is there twice");
    }
    if (robot_.links.size() == kMaxUrdfLinks) {
      values_.Add(element, "is one too many: a robot has at most " + std::to_string(kMaxUrdfLinks));
      problems_.ThrowIfAny();
    }
    if (const TiXmlElement* inertial = element.FirstChildElement("inertial")) {
      link.mass = values_.Mass(*inertial);
    }
    ReadShapes(element, "visual", &link.visuals);
    ReadShapes(element, "collision", &link.collisions);
    num_shapes_ += static_cast<int>(link.visuals.size() + link.collisions.size());
    if (num_shapes_ > kMaxUrdfShapes) {
      values_.Add(element,
                  "has one shape too many: a robot has at most " + std::to_string(kMaxUrdfShapes));
      problems_.ThrowIfAny();
    }
    robot_.links.push_back(std::move(link));
  }

  void ReadShapes(const TiXmlElement& link, const char* tag, std::vector<SourceShape>* shapes) {
    for (const TiXmlElement* e = link.FirstChildElement(tag); e; e = e->NextSiblingElement(tag)) {
      SourceShape shape;
      shape.place = PlaceOf(*e);
      if (const char* name = e->Attribute("name")) shape.name = name;
      shape.X_LS = values_.Pose(*e);
      if (!values_.Geometry(*e, &shape)) continue;
      if (const TiXmlElement* material = e->FirstChildElement("material")) {
        shape.rgba = values_.Colour(*material);
        const char* name = material->Attribute("name");
        if (name != nullptr && shape.rgba) materials_[name] = *shape.rgba;
        const auto known = materials_.find(name == nullptr ? "" : name);
        if (!shape.rgba && known != materials_.end()) shape.rgba = known->second;
      }
      shapes->push_back(std::move(shape));
    }
  }

  void ReadJoint(const TiXmlElement& element) {
    SourceJoint joint;
    joint.place = PlaceOf(element);
    joint.name = values_.Name(element);
    if (!joint_names_.insert(joint.name).second) {
      values_.Add(element, "= '" + joint.name + "' is there twice");
    }
    joint.parent = LinkOf(element, "parent");
    joint.child = LinkOf(element, "child");
    joint.X_PC = values_.Pose(element);
    const char* type = element.Attribute("type");
    const std::map<std::string, JointKind> kinds{{"fixed", JointKind::kFixed},
                                                 {"revolute", JointKind::kRevolute},
                                                 {"continuous", JointKind::kContinuous},
                                                 {"prismatic", JointKind::kPrismatic},
                                                 {"floating", JointKind::kFixed}};
    const auto kind = kinds.find(type == nullptr ? "" : type);
    if (kind == kinds.end()) {
      values_.Add(element, "must be fixed, revolute, continuous or prismatic");
      return;
    }
    joint.kind = kind->second;
    if (kind->first == "floating") floating_.push_back(static_cast<int>(robot_.joints.size()));
    if (joint.is_moving()) values_.Motion(element, &joint);
    joint.is_mimic = element.FirstChildElement("mimic") != nullptr;
    robot_.joints.push_back(std::move(joint));
  }

  int LinkOf(const TiXmlElement& joint, const char* side) {
    const TiXmlElement* element = joint.FirstChildElement(side);
    const char* name = element == nullptr ? nullptr : element->Attribute("link");
    const auto found = links_.find(name == nullptr ? "" : name);
    if (found != links_.end()) return found->second;
    values_.Add(joint,
                std::string("needs <") + side + " link=\"...\"/> that names a link" +
                    (name == nullptr ? "" : "; there is none called '" + std::string(name) + "'"));
    return 0;
  }

  /// A floating joint is fine under a root without mass; the root goes, with the joint.
  void DropFloatingRoot() {
    if (floating_.empty()) return;
    const int index = floating_.front();
    const SourceJoint joint = robot_.joints[static_cast<std::size_t>(index)];
    const bool is_root =
        std::none_of(robot_.joints.begin(), robot_.joints.end(),
                     [&](const SourceJoint& other) { return other.child == joint.parent; });
    const auto children =
        std::count_if(robot_.joints.begin(), robot_.joints.end(),
                      [&](const SourceJoint& other) { return other.parent == joint.parent; });
    const SourceLink& world = robot_.links[static_cast<std::size_t>(joint.parent)];
    if (floating_.size() > 1 || !is_root || children != 1 || world.has_mass()) {
      problems_.Add(joint.place,
                    "joint '" + joint.name +
                        "' floats; only the one between a world without mass and the robot may");
      problems_.ThrowIfAny();
    }
    notes_->push_back("left out link '" + world.name + "' and joint '" + joint.name +
                      "': the base floats anyway");
    const int gone = joint.parent;
    robot_.links.erase(robot_.links.begin() + gone);
    robot_.joints.erase(robot_.joints.begin() + index);
    for (SourceJoint& other : robot_.joints) {
      if (other.parent > gone) --other.parent;
      if (other.child > gone) --other.child;
    }
  }

  Problems problems_;
  XmlValues values_;
  Notes* notes_;
  SourceRobot robot_;
  std::map<std::string, Eigen::Vector4d> materials_;
  std::map<std::string, int> links_;
  std::set<std::string> joint_names_;
  std::vector<int> floating_;
  std::map<std::string, int> passed_over_;
  int num_shapes_{0};
};

}  // namespace

SourceRobot ReadSource(const std::filesystem::path& urdf, Notes* notes) {
  TiXmlDocument document;
  ParseXml(urdf.string(), ReadXmlText(urdf), &document);
  if (document.RootElement() == nullptr) throw ConfigError(urdf.string() + ": error: is no URDF");
  return SourceReader(urdf, notes).Read(*document.RootElement());
}

}  // namespace sidestep::importer
