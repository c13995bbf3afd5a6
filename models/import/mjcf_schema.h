// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_schema: which elements and attributes of an MJCF the MuJoCo at hand knows, by its own word.

#include <map>
#include <set>
#include <string>
#include <utility>

namespace sidestep::importer {

class MjcfSchema {
 public:
  /// Reads what mj_printSchema() prints.
  MjcfSchema();

  /// Whether `tag` may have it in `parent`; of worldbody, bodies and their bodies that is "body".
  bool HasAttribute(const std::string& parent, const std::string& tag,
                    const std::string& attribute) const;

 private:
  std::map<std::pair<std::string, std::string>, std::set<std::string>> attributes_;
};

}  // namespace sidestep::importer
