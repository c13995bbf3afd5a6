// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_classes: attributes as an MJCF's classes of defaults hand them down, where that must be
// known before MuJoCo's compiler knows it.

#include <map>
#include <string>
#include <utility>

#include "models/import/xml_tree.h"

namespace sidestep::importer {

class MjcfClasses {
 public:
  /// @param root  A <mujoco>, of which the <default>s are read.
  explicit MjcfClasses(const XmlElement& root);

  /// What the element, else its class, else `childclass` says of the attribute; empty if nobody.
  /// @param childclass  Of the nearest body or frame that has one; empty: the outermost class.
  std::string Text(const XmlElement& element, const std::string& childclass,
                   const std::string& attribute) const;

 private:
  /// Values by tag and attribute, with what comes from the class above.
  using Values = std::map<std::pair<std::string, std::string>, std::string>;

  void Read(const XmlElement& section, Values values);

  Values outermost_;
  std::map<std::string, Values> classes_;
};

}  // namespace sidestep::importer
