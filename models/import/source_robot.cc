// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/source_robot.h"

#include <algorithm>

#include "models/support/require.h"

namespace sidestep::importer {
namespace {

/// The one link without a parent, or -1 with `fault` told.
int FindRoot(const SourceRobot& robot, std::string* fault) {
  int root = -1;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    if (robot.joint_above[link] >= 0) continue;
    if (root >= 0) {
      *fault = "links '" + robot.links[static_cast<std::size_t>(root)].name + "' and '" +
               robot.links[link].name + "' both have no parent; join them by a joint";
      return -1;
    }
    root = static_cast<int>(link);
  }
  if (root < 0) *fault = "every link has a parent: the joints form a loop";
  return root;
}

}  // namespace

std::string ConnectLinks(SourceRobot* robot) {
  const std::size_t num_links = robot->links.size();
  robot->joint_above.assign(num_links, -1);
  robot->joints_below.assign(num_links, {});
  for (std::size_t i = 0; i < robot->joints.size(); ++i) {
    const SourceJoint& joint = robot->joints[i];
    int& above = robot->joint_above[static_cast<std::size_t>(joint.child)];
    if (above >= 0) {
      return "link '" + robot->links[static_cast<std::size_t>(joint.child)].name +
             "' has two parents, by joints '" +
             robot->joints[static_cast<std::size_t>(above)].name + "' and '" + joint.name +
             "': closed loops can't be simulated; take one out";
    }
    above = static_cast<int>(i);
    robot->joints_below[static_cast<std::size_t>(joint.parent)].push_back(static_cast<int>(i));
  }
  std::string fault;
  robot->root = FindRoot(*robot, &fault);
  if (!fault.empty()) return fault;
  robot->order = {robot->root};
  for (std::size_t i = 0; i < robot->order.size(); ++i) {
    for (const int joint : robot->joints_below[static_cast<std::size_t>(robot->order[i])]) {
      robot->order.push_back(robot->joints[static_cast<std::size_t>(joint)].child);
    }
  }
  if (robot->order.size() != num_links) return "some joints form a loop apart from the root";
  return {};
}

int FindLink(const SourceRobot& robot, const std::string& name) {
  const auto found = std::find_if(robot.links.begin(), robot.links.end(),
                                  [&](const SourceLink& link) { return link.name == name; });
  return found == robot.links.end() ? -1 : static_cast<int>(found - robot.links.begin());
}

std::string UnusedName(const SourceRobot& robot, const std::string& name) {
  const auto is_used = [&](const std::string& text) {
    return FindLink(robot, text) >= 0 ||
           std::any_of(robot.joints.begin(), robot.joints.end(),
                       [&](const SourceJoint& joint) { return joint.name == text; });
  };
  std::string unused = name;
  for (int i = 2; is_used(unused); ++i) unused = name + "_" + std::to_string(i);
  return unused;
}

int AddFrame(const std::string& name, int parent, const Eigen::Isometry3d& X_PF,
             const std::string& note, SourceRobot* robot) {
  SourceLink link;
  link.name = name;
  link.note = note;
  SourceJoint joint;
  joint.name = UnusedName(*robot, name + "_fixed");
  joint.parent = parent;
  joint.child = static_cast<int>(robot->links.size());
  joint.X_PC = X_PF;
  robot->links.push_back(link);
  robot->joints.push_back(joint);
  const std::string fault = ConnectLinks(robot);
  SIDESTEP_REQUIRE(fault.empty(), fault);
  return joint.child;
}

double TotalMass_kg(const SourceRobot& robot) {
  double mass_kg = 0.0;
  for (const SourceLink& link : robot.links) mass_kg += link.mass.mass_kg;
  return mass_kg;
}

}  // namespace sidestep::importer
