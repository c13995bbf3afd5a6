// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// urdf_document: a URDF as XML, before urdfdom sees it, with the places that urdfdom forgets.
//
// Flow: file -> [urdf_document] -> [urdf_elements, urdf_graph: what is wrong, what is harmless and
// mended in the document] -> text -> urdfdom -> [read_urdf] -> UrdfTree.

#include <tinyxml.h>

#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "models/support/file_notes.h"
#include "models/urdf_to_mjcf/parse_xml.h"

namespace sidestep {

/// The element's attribute, empty if it has none.
std::string TextOf(const TiXmlElement& element, const char* attribute);

class UrdfDocument {
 public:
  /// Parses the file. Throws ConfigError if it is no XML within CheckXmlBounds(), or without a
  /// <robot>.
  explicit UrdfDocument(const std::filesystem::path& file);

  TiXmlElement& robot() { return *robot_; }
  FileNotes& notes() { return notes_; }

  /// Place of the link or joint called `name` or, of its children called `child`, of that number
  /// `index` (of the last if there are fewer; its own if there is none).
  TextPlace Place(const std::string& kind, const std::string& name, const std::string& child = "",
                  std::size_t index = 0) const;

  /// The document as it is now.
  std::string Text() const;

 private:
  FileNotes notes_;
  TiXmlDocument document_;
  TiXmlElement* robot_{nullptr};
};

/// Calls visit(element) for the children of `parent` called `name`; it may remove its own.
template <typename Visitor>
void ForEachChild(TiXmlElement& parent, const char* name, Visitor&& visit) {
  for (TiXmlElement* child = parent.FirstChildElement(name); child != nullptr;) {
    TiXmlElement* const next = child->NextSiblingElement(name);
    visit(*child);
    child = next;
  }
}

}  // namespace sidestep
