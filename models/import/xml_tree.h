// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// xml_tree: an MJCF with all that it includes as one tree, to be changed and written again, whose
// elements know the file and the place that they came from.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "models/import/mesh_files.h"
#include "models/import/problems.h"

namespace sidestep::importer {

struct XmlElement {
  std::string tag;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlElement> children;
  std::size_t file{0};  ///< Index into XmlTree::files.
  TextPlace place;      ///< Of no line where it was made up.

  /// Null where there is no such attribute.
  const std::string* Find(const std::string& name) const;
  /// Empty where there is none.
  std::string Text(const std::string& name) const;
  /// Replaces or adds.
  void Set(const std::string& name, const std::string& value);
  void Erase(const std::string& name);
};

struct XmlTree {
  XmlElement root;
  std::vector<std::string> files;  ///< The first is the one that was asked for.

  /// `file:line:column` of an element.
  std::string Place(const XmlElement& element) const;
};

/// Reads `file` and puts the children of what it includes in the <include>s' places. Includes are
/// looked for beside `file` and beside the file that includes them, as far as `files` may read.
/// Throws ConfigError with every problem: no XML, more than xml_bounds.h allows in one file or in
/// all, files that include themselves, that are missing or lie elsewhere.
XmlTree ReadXmlTree(const std::filesystem::path& file, const MeshFiles& files);

/// Text with one element a line. `lines`, if any, gets the element that begins line i + 1; they
/// point into the tree.
std::string XmlText(const XmlElement& root, std::vector<const XmlElement*>* lines);

}  // namespace sidestep::importer
