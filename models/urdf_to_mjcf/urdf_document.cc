// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/urdf_document.h"

#include "models/support/config_error.h"
#include "models/support/xml_bounds.h"

namespace sidestep {

std::string TextOf(const TiXmlElement& element, const char* attribute) {
  const char* text = element.Attribute(attribute);
  return text != nullptr ? text : "";
}

UrdfDocument::UrdfDocument(const std::filesystem::path& file) : notes_(file.string()) {
  ParseXml(file.string(), ReadXmlText(file), &document_);
  robot_ = document_.FirstChildElement("robot");
  if (robot_ == nullptr) {
    throw ConfigError(file.string() + ": error: is no URDF: it has no <robot> element");
  }
}

TextPlace UrdfDocument::Place(const std::string& kind, const std::string& name,
                              const std::string& child, std::size_t index) const {
  const TiXmlElement* element = robot_->FirstChildElement(kind);
  while (element != nullptr && TextOf(*element, "name") != name) {
    element = element->NextSiblingElement(kind);
  }
  if (element == nullptr) return {};
  const TiXmlElement* found = child.empty() ? nullptr : element->FirstChildElement(child);
  for (; found != nullptr && index > 0 && found->NextSiblingElement(child) != nullptr; --index) {
    found = found->NextSiblingElement(child);
  }
  return PlaceOf(found != nullptr ? *found : *element);
}

std::string UrdfDocument::Text() const {
  TiXmlPrinter printer;
  printer.SetStreamPrinting();
  document_.Accept(&printer);
  return printer.Str();
}

}  // namespace sidestep
