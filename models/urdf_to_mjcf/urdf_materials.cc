// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <sstream>

#include "models/urdf_to_mjcf/urdf_elements.h"
#include "models/urdf_to_mjcf/urdf_values.h"

namespace sidestep {
namespace {

/// What is wrong with the colour that `material` gives; empty if it gives a good one or none.
std::string FaultOfColor(TiXmlElement* material) {
  TiXmlElement* const color = material->FirstChildElement("color");
  if (color == nullptr) return "";
  if (color->Attribute("rgba") == nullptr) return "has a <color> without rgba";
  if (std::string fault = FaultOfNumbers(color, "rgba", 4, kMaxUrdfNumber); !fault.empty())
    return fault;
  std::istringstream numbers(TextOf(*color, "rgba"));
  for (double number = 0.0; numbers >> number;) {
    if (number < 0.0 || number > 1.0) {
      return "has rgba = '" + TextOf(*color, "rgba") + "', which must be from 0 to 1";
    }
  }
  return "";
}

class MaterialMender {
 public:
  explicit MaterialMender(UrdfDocument* document)
      : robot_(document->robot()), notes_(document->notes()) {}

  void Mend() {
    ForEachChild(robot_, "material", [&](TiXmlElement& material) { MendOfRobot(&material); });
    ForEachVisual([&](TiXmlElement& visual) { Collect(&visual); });
    ForEachVisual([&](TiXmlElement& visual) { Resolve(&visual); });
    Notice();
  }

 private:
  template <typename Visitor>
  void ForEachVisual(Visitor&& visit) {
    ForEachChild(robot_, "link", [&](TiXmlElement& link) {
      label_ = "link '" + TextOf(link, "name") + "'";
      ForEachChild(link, "visual", visit);
    });
  }

  static bool HasColor(const TiXmlElement& material) {
    return material.FirstChildElement("color") != nullptr;
  }

  void MendOfRobot(TiXmlElement* material) {
    const std::string name = TextOf(*material, "name");
    std::string fault = FaultOfColor(material);
    if (name.empty()) fault = "has no name";
    if (fault.empty() && !HasColor(*material)) fault = "has no <color>";
    if (fault.empty() && known_.contains(name)) fault = "is there twice; the first counts";
    if (fault.empty()) {
      known_.insert(name);
      return;
    }
    notes_.Notice(PlaceOf(*material), "material '" + name + "' " + fault);
    robot_.RemoveChild(material);
  }

  /// Colours that stand in a visual, which others may call by name.
  void Collect(TiXmlElement* visual) {
    TiXmlElement* const material = visual->FirstChildElement("material");
    if (material == nullptr) return;
    if (const std::string fault = FaultOfColor(material); !fault.empty()) {
      notes_.Notice(PlaceOf(*material), label_ + " " + fault + "; it is drawn grey");
      material->RemoveChild(material->FirstChildElement("color"));
    }
    if (!HasColor(*material)) return;
    if (TextOf(*material, "name").empty()) {
      if (num_unnamed_ == 0) first_unnamed_ = PlaceOf(*material);
      std::string name = "unnamed_" + std::to_string(++num_unnamed_);
      while (known_.contains(name)) name += "_";
      material->SetAttribute("name", name.c_str());
    }
    if (known_.insert(TextOf(*material, "name")).second) {
      robot_.InsertBeforeChild(robot_.FirstChild(), *material);
    }
  }

  void Resolve(TiXmlElement* visual) {
    TiXmlElement* const material = visual->FirstChildElement("material");
    const std::string name = material != nullptr ? TextOf(*material, "name") : "";
    if (material == nullptr || known_.contains(name)) return;
    if (!name.empty() && unknown_.empty()) first_unknown_ = PlaceOf(*material);
    if (!name.empty()) unknown_.insert(name);
    visual->RemoveChild(material);
  }

  void Notice() {
    if (num_unnamed_ > 0) {
      notes_.Notice(first_unnamed_, "materials without a name are taken by their colours: " +
                                        std::to_string(num_unnamed_));
    }
    std::string list;
    for (const std::string& name : unknown_) list += (list.empty() ? "" : ", ") + name;
    if (!list.empty()) {
      notes_.Notice(first_unknown_, "materials without a colour are drawn grey: " + list);
    }
  }

  TiXmlElement& robot_;
  FileNotes& notes_;
  std::set<std::string> known_;  ///< With a colour.
  std::string label_;            ///< Of the link at hand.
  int num_unnamed_{0};
  TextPlace first_unnamed_;
  std::set<std::string> unknown_;  ///< Names that stand for no colour.
  TextPlace first_unknown_;
};

}  // namespace

void MendMaterials(UrdfDocument* document) { MaterialMender(document).Mend(); }

}  // namespace sidestep
