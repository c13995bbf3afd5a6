// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// xml_values: numbers, poses, masses and shapes in a URDF's elements, and what is wrong with them.

#include <tinyxml.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// Reads values out of elements. Whatever is wrong goes to the list of problems, and a harmless
/// value is returned in its stead.
class XmlValues {
 public:
  explicit XmlValues(Problems* problems) : problems_(problems) {}

  /// `file:line:column: error: <tag> 'name' what`.
  void Add(const TiXmlElement& element, const std::string& what);

  /// The attribute `name`, which must not be empty.
  std::string Name(const TiXmlElement& element);

  /// Of the child <origin>; identity where there is none.
  Eigen::Isometry3d Pose(const TiXmlElement& parent);

  /// Of an <inertial>, in the frame of its link. Not yet checked to be possible.
  MassProperties Mass(const TiXmlElement& inertial);

  /// The child <color> of a <material>; empty where there is none.
  std::optional<Eigen::Vector4d> Colour(const TiXmlElement& material);

  /// Reads the child <geometry>; false, with the problem told, if it is none that we know.
  bool Geometry(const TiXmlElement& parent, SourceShape* shape);

  /// <axis>, <limit> and <dynamics> of a joint that moves.
  void Motion(const TiXmlElement& element, SourceJoint* joint);

 private:
  /// `count` numbers of an attribute; `otherwise` where it is missing.
  std::vector<double> Numbers(const TiXmlElement& element, const char* attribute,
                              const std::vector<double>& otherwise);
  double Number(const TiXmlElement& element, const char* attribute, double otherwise);
  double Required(const TiXmlElement& element, const char* attribute);

  Problems* problems_;
};

}  // namespace sidestep::importer
