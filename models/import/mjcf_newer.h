// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_newer: words of an MJCF that the MuJoCo at hand does not know: translated, taken out, or
// told with what to delete. Also where numbers that are none are found out.

#include <map>
#include <string>

#include "models/import/mjcf_schema.h"
#include "models/import/problems.h"
#include "models/import/xml_tree.h"

namespace sidestep::importer {

class NewerWords {
 public:
  NewerWords(const XmlTree& tree, Problems* problems) : tree_(tree), problems_(*problems) {}

  /// Makes the element's attributes ones that MuJoCo knows. The lower and the upper end of a
  /// joint's actuatorfrcrange end up in `user`, and so does of a servo the kv or, as a negative
  /// number, the dampratio: one number, so that an element's replaces its class's.
  /// @param parent  What it stands in: default, asset, body, actuator, mujoco.
  void Mend(const std::string& parent, XmlElement* element);

  /// That an element can't be taken, and what to do.
  void RefuseElement(const XmlElement& element);

  /// Shapes and meshes that a plugin makes.
  void RefuseChildren(const XmlElement& element);

  /// What was taken out.
  void Tell(Notes* notes) const;

 private:
  void CheckNumbers(const XmlElement& element);
  /// For `user`; empty where the servo says nothing.
  std::string DampingOf(const XmlElement& servo, bool is_kv_newer);

  const XmlTree& tree_;
  Problems& problems_;
  MjcfSchema schema_;
  std::map<std::string, int> taken_out_;  ///< Attributes, and how often.
  Notes left_out_;
};

}  // namespace sidestep::importer
