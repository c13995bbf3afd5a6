// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_classes.h"

namespace sidestep::importer {

MjcfClasses::MjcfClasses(const XmlElement& root) {
  for (const XmlElement& section : root.children) {
    if (section.tag != "default") continue;
    Read(section, outermost_);
    outermost_ = classes_[section.Text("class")];
  }
}

void MjcfClasses::Read(const XmlElement& section, Values values) {
  for (const XmlElement& element : section.children) {
    for (const auto& [name, value] : element.attributes) values[{element.tag, name}] = value;
  }
  for (const XmlElement& child : section.children) {
    if (child.tag == "default") Read(child, values);
  }
  classes_[section.Text("class")] = std::move(values);
}

std::string MjcfClasses::Text(const XmlElement& element, const std::string& childclass,
                              const std::string& attribute) const {
  if (const std::string* own = element.Find(attribute)) return *own;
  const std::string* name = element.Find("class");
  const auto known = classes_.find(name == nullptr ? childclass : *name);
  const Values& values =
      known == classes_.end() || known->first.empty() ? outermost_ : known->second;
  const auto value = values.find({element.tag, attribute});
  return value == values.end() ? "" : value->second;
}

}  // namespace sidestep::importer
