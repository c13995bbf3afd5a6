// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/assume.h"

#include <memory>

#include "models/support/config_error.h"
#include "models/support/config_tree.h"
#include "sim/scenario/read_fields.h"

namespace sidestep::limit {

LimitParams Assume(const std::vector<std::string>& assignments, LimitParams params) {
  for (const std::string& assignment : assignments) {
    const ConfigSource source{"--assume " + assignment, false};
    const ConfigPlace place{std::make_shared<const ConfigSource>(source), 1, 1};
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) FailAt(place, "must read key=value");
    ConfigTree root;
    root.kind = ConfigKind::kMap;
    root.place = place;
    root.keys.push_back({assignment.substr(0, equals), place});
    root.children.push_back(ParseConfig(assignment.substr(equals + 1), source));
    ReadFields(ConfigNode(root, ""), params);
  }
  if (params.farthest_m < params.nearest_m) {
    throw ConfigError("error: farthest_m = " + NumberText(params.farthest_m) +
                      " is below nearest_m = " + NumberText(params.nearest_m));
  }
  return params;
}

}  // namespace sidestep::limit
