// SPDX-License-Identifier: BSD-3-Clause
#include "models/robot_description/mjcf_includes.h"

#include <strings.h>
#include <tinyxml.h>

#include <set>
#include <system_error>

#include "models/mjcf/mjcf_bounds.h"
#include "models/support/xml_bounds.h"

namespace sidestep {
namespace {

bool HasIncludes(const std::string& file, const std::string& text) {
  XmlTags tags(file, text);
  while (const auto tag = tags.Next()) {
    if (IsInclude(*tag)) return true;
  }
  return false;
}

/// Whether the text was XML.
bool Parse(const std::string& text, TiXmlDocument* document) {
  document->Parse(WithoutStrayBytes(text).c_str(), nullptr, TIXML_ENCODING_UTF8);
  return !document->Error() && document->RootElement() != nullptr;
}

class Includer {
 public:
  explicit Includer(const std::filesystem::path& mjcf) : mjcf_(mjcf) {}

  void Fill(TiXmlElement* parent) {
    for (TiXmlElement* child = parent->FirstChildElement(); child != nullptr;) {
      TiXmlElement* const next = child->NextSiblingElement();
      if (strcasecmp(child->Value(), "include") == 0) {
        Replace(parent, child);
      } else {
        Fill(child);
      }
      child = next;
    }
  }

 private:
  void Replace(TiXmlElement* parent, TiXmlElement* include) {
    const char* const name = include->Attribute("file");
    if (name == nullptr || !include->NoChildren() || !names_.insert(name).second) return;
    const std::filesystem::path path = IncludedFile(mjcf_, name);
    std::error_code ignored;
    TiXmlDocument document;
    if (!std::filesystem::is_regular_file(path, ignored)) return;
    if (!Parse(ReadXmlText(path), &document)) return;
    Fill(document.RootElement());
    for (const TiXmlElement* e = document.RootElement()->FirstChildElement(); e != nullptr;
         e = e->NextSiblingElement()) {
      parent->InsertBeforeChild(include, *e);
    }
    parent->RemoveChild(include);
  }

  const std::filesystem::path& mjcf_;
  std::set<std::string> names_;
};

}  // namespace

std::string WithIncluded(const std::string& text, const std::filesystem::path& file) {
  TiXmlDocument document;
  if (!HasIncludes(file.string(), text) || !Parse(text, &document)) return text;
  Includer(file).Fill(document.RootElement());
  TiXmlPrinter printer;
  document.Accept(&printer);
  return printer.Str();
}

}  // namespace sidestep
