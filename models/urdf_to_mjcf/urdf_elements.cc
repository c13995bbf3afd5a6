// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/urdf_elements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "models/support/plain_word.h"
#include "models/urdf_to_mjcf/urdf_values.h"

namespace sidestep {
namespace {

constexpr double kLeastAxis = 1e-6;  // of its length; MuJoCo wants one of 1e-15

/// Removes the children of `element` whose tags are none of `kept`.
template <std::size_t N>
void KeepOnly(const std::array<const char*, N>& kept, TiXmlElement* element) {
  for (TiXmlNode* child = element->FirstChild(); child != nullptr;) {
    TiXmlNode* const next = child->NextSibling();
    const bool is_kept = child->ToElement() != nullptr &&
                         std::any_of(kept.begin(), kept.end(),
                                     [&](const char* tag) { return child->ValueStr() == tag; });
    if (!is_kept) element->RemoveChild(child);
    child = next;
  }
}

class ElementChecker {
 public:
  explicit ElementChecker(UrdfDocument* document)
      : robot_(document->robot()), notes_(document->notes()) {}

  void Check() {
    DropForeign();
    robot_.RemoveAttribute("version");  // urdfdom takes "1.0" only
    if (TextOf(robot_, "name").empty()) {
      notes_.Problem(PlaceOf(robot_), "the <robot> has no name; give it one: <robot name=\"...\">");
    }
    int num_shapes = 0;
    ForEachChild(robot_, "link", [&](TiXmlElement& link) {
      CheckLink(&link);
      for (const char* kind : {"visual", "collision"}) {
        ForEachChild(link, kind, [&](TiXmlElement& /*shape*/) { ++num_shapes; });
      }
    });
    if (num_shapes > kMaxUrdfShapes) {
      notes_.Problem(PlaceOf(robot_), "the robot has " + std::to_string(num_shapes) +
                                          " shapes, more than " + std::to_string(kMaxUrdfShapes));
    }
    ForEachChild(robot_, "joint", [&](TiXmlElement& joint) { CheckJoint(&joint); });
  }

 private:
  /// What isn't of URDF's kinematics: simulators', drivers' and planners' own.
  void DropForeign() {
    std::map<std::string, int> counts;
    for (TiXmlNode* child = robot_.FirstChild(); child != nullptr;) {
      TiXmlNode* const next = child->NextSibling();
      const std::string& tag = child->ValueStr();
      if (child->ToElement() == nullptr) {
        robot_.RemoveChild(child);
      } else if (tag.starts_with("xacro:")) {
        notes_.Problem(PlaceOf(*child), "<" + tag + "> is xacro's; expand the file first: xacro " +
                                            "FILE > robot.urdf");
        notes_.ThrowProblems();  // what follows is no URDF either
      } else if (tag != "link" && tag != "joint" && tag != "material") {
        ++counts[tag];
        robot_.RemoveChild(child);
      }
      child = next;
    }
    std::string list;
    for (const auto& [tag, count] : counts) {
      list += (list.empty() ? "<" : ", <") + tag + "> (" + std::to_string(count) + ")";
    }
    if (!list.empty()) notes_.Notice({}, "elements that only other programs read: " + list);
  }

  /// "link 'x'", and notes what is wrong with its name.
  std::string NameOf(const TiXmlElement& element, std::set<std::string>* seen) {
    const std::string& kind = element.ValueStr();
    const std::string name = TextOf(element, "name");
    std::string label = kind + " '" + name.substr(0, kMaxWordLength) + "'";
    if (name.empty()) {
      notes_.Problem(PlaceOf(element), "a <" + kind + "> has no name");
    } else if (!IsPlainWord(name)) {
      notes_.Problem(PlaceOf(element), label + ": a name must be " + std::string(kPlainWordRule));
    } else if (!seen->insert(name).second) {
      notes_.Problem(PlaceOf(element), label + " is there twice; names must differ");
    }
    return label;
  }

  void CheckLink(TiXmlElement* link) {
    constexpr std::array<const char*, 3> kKept{"inertial", "visual", "collision"};
    const std::string label = NameOf(*link, &links_);
    KeepOnly(kKept, link);
    if (TiXmlElement* inertial = link->FirstChildElement("inertial")) {
      CheckInertial(label, inertial);
    }
    ForEachChild(*link, "visual", [&](TiXmlElement& visual) {
      const std::string fault = FaultOfShape(&visual);
      if (fault.empty()) return;
      notes_.Notice(PlaceOf(visual), label + " " + fault + "; it is not drawn");
      link->RemoveChild(&visual);
    });
    ForEachChild(*link, "collision", [&](TiXmlElement& collision) {
      Note(collision, label, FaultOfShape(&collision));
    });
  }

  void CheckInertial(const std::string& label, TiXmlElement* inertial) {
    Note(*inertial, label, FaultOfOrigin(inertial));
    TiXmlElement* const mass = inertial->FirstChildElement("mass");
    if (mass == nullptr || TextOf(*mass, "value").empty()) {
      notes_.Problem(PlaceOf(*inertial),
                     label +
                         " has an <inertial> without <mass value=\"...\">; give it one, or "
                         "leave the <inertial> out");
    } else {
      Note(*mass, label, FaultOfNumbers(mass, "value", 1, kMaxUrdfMass_kg));
    }
    TiXmlElement* inertia = inertial->FirstChildElement("inertia");
    if (inertia == nullptr) {
      inertia = inertial->InsertEndChild(TiXmlElement("inertia"))->ToElement();
    }
    for (const char* entry : {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"}) {
      if (inertia->Attribute(entry) == nullptr) inertia->SetAttribute(entry, "0");
      Note(*inertial, label, FaultOfNumbers(inertia, entry, 1, kMaxUrdfInertia_kgm2));
    }
  }

  void CheckJoint(TiXmlElement* joint) {
    constexpr std::array<const char*, 7> kKept{"origin", "parent",   "child", "axis",
                                               "limit",  "dynamics", "mimic"};
    const std::string label = NameOf(*joint, &joints_);
    KeepOnly(kKept, joint);
    Note(*joint, label, FaultOfOrigin(joint));
    for (const char* side : {"parent", "child"}) {
      const TiXmlElement* link = joint->FirstChildElement(side);
      if (link == nullptr || TextOf(*link, "link").empty()) {
        notes_.Problem(PlaceOf(*joint), label + " has no <" + std::string(side) +
                                            " link=\"...\">; every joint "
                                            "needs one");
      }
    }
    CheckType(label, joint);
    for (const char* tag : {"limit", "dynamics", "mimic"}) CheckDetails(label, tag, joint);
  }

  void CheckType(const std::string& label, TiXmlElement* joint) {
    constexpr std::array<const char*, 6> kTypes{"revolute", "continuous", "prismatic",
                                                "fixed",    "floating",   "planar"};
    const std::string type = TextOf(*joint, "type");
    if (std::find(kTypes.begin(), kTypes.end(), type) == kTypes.end()) {
      notes_.Problem(PlaceOf(*joint), label + " has the type '" + type +
                                          "', which is none of revolute, continuous, prismatic, "
                                          "fixed, floating, planar");
    }
    if (TiXmlElement* axis = joint->FirstChildElement("axis")) {
      const std::string fault = FaultOfNumbers(axis, "xyz", 3, kMaxUrdfNumber);
      Note(*axis, label, fault);
      std::istringstream numbers(TextOf(*axis, "xyz"));
      double x = 0.0, y = 0.0, z = 0.0;
      const bool is_zero = (numbers >> x >> y >> z) && std::hypot(x, y, z) < kLeastAxis;
      if (type == "fixed" || type == "floating") {
        joint->RemoveChild(axis);
      } else if (fault.empty() && is_zero) {
        notes_.Problem(PlaceOf(*axis), label + " has an axis of no length, which points nowhere");
      }
    }
    const bool needs_limit = type == "revolute" || type == "prismatic";
    if (needs_limit && joint->FirstChildElement("limit") == nullptr) {
      notes_.Problem(PlaceOf(*joint),
                     label + " is " + type +
                         " without a <limit lower=\"...\" upper=\"...\" effort=\"...\" "
                         "velocity=\"...\"/>; give it one, or make it continuous or fixed");
    }
  }

  void CheckDetails(const std::string& label, const std::string& tag, TiXmlElement* joint) {
    TiXmlElement* const element = joint->FirstChildElement(tag);
    if (element == nullptr) return;
    for (const char* number :
         {"lower", "upper", "effort", "velocity", "damping", "friction", "multiplier", "offset"}) {
      Note(*element, label, FaultOfNumbers(element, number, 1, kMaxUrdfNumber));
    }
    for (const char* size : {"effort", "velocity", "damping"}) {
      if (FiniteNumber(TextOf(*element, size)).value_or(0.0) < 0.0) {
        notes_.Problem(PlaceOf(*element), label + " has a negative " + size);
      }
    }
    if (tag == "limit") {  // what robot.yaml then has to say
      for (const char* size : {"effort", "velocity"}) {
        if (element->Attribute(size) == nullptr) element->SetAttribute(size, "0");
      }
    } else if (tag == "dynamics" && TextOf(*element, "damping").empty() &&
               TextOf(*element, "friction").empty()) {
      joint->RemoveChild(element);
    } else if (tag == "mimic" && TextOf(*element, "joint").empty()) {
      notes_.Problem(PlaceOf(*element), label + " has a <mimic> without joint");
    }
  }

  void Note(const TiXmlElement& at, const std::string& label, const std::string& fault) {
    if (!fault.empty()) notes_.Problem(PlaceOf(at), label + " " + fault);
  }

  TiXmlElement& robot_;
  FileNotes& notes_;
  std::set<std::string> links_;
  std::set<std::string> joints_;
};

}  // namespace

void CheckElements(UrdfDocument* document) {
  ElementChecker(document).Check();
  MendMaterials(document);
}

}  // namespace sidestep
