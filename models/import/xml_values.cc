// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/xml_values.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "models/support/parse_number.h"
#include "models/urdf_to_mjcf/parse_xml.h"

namespace sidestep::importer {
namespace {

constexpr double kMaxNumber = 1e12;

/// Words between white space.
std::vector<std::string> WordsIn(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::optional<double> NumberIn(std::string word) {
  if (!word.empty() && word[0] == '+') word.erase(0, 1);
  const std::optional<double> number = ParseAs<double>(word);
  return number && std::isfinite(*number) && std::abs(*number) <= kMaxNumber ? number
                                                                             : std::nullopt;
}

const TiXmlElement* Child(const TiXmlElement& parent, const char* tag) {
  return parent.FirstChildElement(tag);
}

}  // namespace

void XmlValues::Add(const TiXmlElement& element, const std::string& what) {
  const TiXmlNode* named = &element;
  while (named->ToElement() != nullptr && named->ToElement()->Attribute("name") == nullptr &&
         named->Parent() != nullptr && named->Parent()->ToElement() != nullptr) {
    named = named->Parent();
  }
  std::string where = "<" + element.ValueStr() + ">";
  const TiXmlElement* owner = named->ToElement();
  if (owner != nullptr && owner->Attribute("name") != nullptr && owner->ValueStr() != "robot") {
    where = owner->ValueStr() + " '" + owner->Attribute("name") + "'" +
            (owner == &element ? "" : ": " + where);
  }
  problems_->Add(PlaceOf(element), where + " " + what);
}

std::string XmlValues::Name(const TiXmlElement& element) {
  const char* name = element.Attribute("name");
  if (name == nullptr || *name == '\0') Add(element, "needs a name");
  return name == nullptr ? "" : name;
}

std::vector<double> XmlValues::Numbers(const TiXmlElement& element, const char* attribute,
                                       const std::vector<double>& otherwise) {
  const char* text = element.Attribute(attribute);
  if (text == nullptr) return otherwise;
  std::vector<double> numbers;
  for (const std::string& word : WordsIn(text)) {
    if (const std::optional<double> number = NumberIn(word)) numbers.push_back(*number);
  }
  if (numbers.size() == otherwise.size() && WordsIn(text).size() == otherwise.size())
    return numbers;
  Add(element, std::string("needs ") + attribute + " of " + std::to_string(otherwise.size()) +
                   (otherwise.size() == 1 ? " number" : " numbers") + ", not '" + text + "'");
  return otherwise;
}

double XmlValues::Number(const TiXmlElement& element, const char* attribute, double otherwise) {
  return Numbers(element, attribute, {otherwise})[0];
}

double XmlValues::Required(const TiXmlElement& element, const char* attribute) {
  if (element.Attribute(attribute) == nullptr) Add(element, std::string("needs ") + attribute);
  return Number(element, attribute, 0.0);
}

Eigen::Isometry3d XmlValues::Pose(const TiXmlElement& parent) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  const TiXmlElement* origin = Child(parent, "origin");
  if (origin == nullptr) return X;
  const std::vector<double> p = Numbers(*origin, "xyz", {0.0, 0.0, 0.0});
  const std::vector<double> rpy = Numbers(*origin, "rpy", {0.0, 0.0, 0.0});
  X.translation() << p[0], p[1], p[2];
  X.linear() = (Eigen::AngleAxisd(rpy[2], Eigen::Vector3d::UnitZ()) *
                Eigen::AngleAxisd(rpy[1], Eigen::Vector3d::UnitY()) *
                Eigen::AngleAxisd(rpy[0], Eigen::Vector3d::UnitX()))
                   .toRotationMatrix();
  return X;
}

MassProperties XmlValues::Mass(const TiXmlElement& inertial) {
  MassProperties mass;
  const TiXmlElement* value = Child(inertial, "mass");
  if (value == nullptr) {
    Add(inertial, "needs <mass value=\"...\"/>");
    return mass;
  }
  mass.mass_kg = Required(*value, "value");
  if (mass.mass_kg < 0.0) Add(*value, "must not be negative");
  if (const TiXmlElement* inertia = Child(inertial, "inertia")) {
    const double ixy = Number(*inertia, "ixy", 0.0);
    const double ixz = Number(*inertia, "ixz", 0.0);
    const double iyz = Number(*inertia, "iyz", 0.0);
    mass.inertia_kgm2 << Required(*inertia, "ixx"), ixy, ixz, ixy, Required(*inertia, "iyy"), iyz,
        ixz, iyz, Required(*inertia, "izz");
  }
  return InFrame(Pose(inertial), mass);
}

std::optional<Eigen::Vector4d> XmlValues::Colour(const TiXmlElement& material) {
  const TiXmlElement* colour = Child(material, "color");
  if (colour == nullptr || colour->Attribute("rgba") == nullptr) return std::nullopt;
  const std::vector<double> rgba = Numbers(*colour, "rgba", {0.7, 0.7, 0.7, 1.0});
  return Eigen::Vector4d(rgba[0], rgba[1], rgba[2], rgba[3]).cwiseMax(0.0).cwiseMin(1.0);
}

bool XmlValues::Geometry(const TiXmlElement& parent, SourceShape* shape) {
  const TiXmlElement* geometry = Child(parent, "geometry");
  const TiXmlElement* what = geometry == nullptr ? nullptr : geometry->FirstChildElement();
  const std::string kind = what == nullptr ? "" : what->ValueStr();
  if (kind == "box") {
    const std::vector<double> size = Numbers(*what, "size", {0.0, 0.0, 0.0});
    shape->size_m << size[0], size[1], size[2];
  } else if (kind == "sphere") {
    shape->kind = ShapeKind::kSphere;
    shape->size_m.x() = Required(*what, "radius");
  } else if (kind == "cylinder" || kind == "capsule") {
    shape->kind = ShapeKind::kCylinder;
    shape->size_m << Required(*what, "radius"), Required(*what, "length"), 0.0;
    if (kind == "capsule") shape->size_m.y() += 2.0 * shape->size_m.x();
  } else if (kind == "mesh" && what->Attribute("filename") != nullptr) {
    shape->kind = ShapeKind::kMesh;
    shape->mesh = what->Attribute("filename");
    const std::vector<double> scale = Numbers(*what, "scale", {1.0, 1.0, 1.0});
    shape->scale << scale[0], scale[1], scale[2];
  } else {
    Add(parent, "needs a <geometry> with a box, sphere, cylinder or mesh");
    return false;
  }
  if (shape->size_m.minCoeff() < 0.0) Add(*what, "must not have a negative size");
  return true;
}

void XmlValues::Motion(const TiXmlElement& element, SourceJoint* joint) {
  if (const TiXmlElement* axis = Child(element, "axis")) {
    const std::vector<double> xyz = Numbers(*axis, "xyz", {1.0, 0.0, 0.0});
    joint->axis << xyz[0], xyz[1], xyz[2];
  }
  if (joint->axis.norm() < 1e-6) Add(element, "moves about an axis of length 0");
  joint->axis.normalize();
  if (const TiXmlElement* limit = Child(element, "limit")) {
    joint->lower = Number(*limit, "lower", 0.0);
    joint->upper = Number(*limit, "upper", 0.0);
    joint->effort_Nm = Number(*limit, "effort", 0.0);
    joint->velocity_radps = Number(*limit, "velocity", 0.0);
    if (joint->has_range() && joint->lower > joint->upper) {
      Add(*limit, "has its lower end above the upper one");
    }
  } else if (joint->has_range()) {
    Add(element, "needs a <limit>");
  }
  if (const TiXmlElement* dynamics = Child(element, "dynamics")) {
    joint->damping_Nms_per_rad = std::max(0.0, Number(*dynamics, "damping", 0.0));
  }
}

}  // namespace sidestep::importer
