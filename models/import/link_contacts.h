// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// link_contacts: which links' collision shapes overlap in a posture, by MuJoCo's own geometry.

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "models/import/posture.h"
#include "models/import/source_robot.h"
#include "models/mjcf/mjcf.h"

namespace sidestep::importer {

/// Two links, as indices.
using LinkPair = std::pair<int, int>;

/// The links' shapes as bodies that float apart, posed one by one. Shapes must not be meshes.
class LinkContacts {
 public:
  /// Only `pairs` are looked at.
  LinkContacts(const SourceRobot& robot, const std::vector<LinkPair>& pairs);

  /// Those of the pairs that are nearer than `margin_m` to each other.
  std::set<LinkPair> Near(const Placement& placement, double margin_m);

 private:
  std::vector<int> links_;  ///< Bodies 1, 2, ... are these.
  MjModelPtr model_;
  MjDataPtr data_;
};

}  // namespace sidestep::importer
