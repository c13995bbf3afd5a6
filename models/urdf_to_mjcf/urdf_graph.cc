// SPDX-License-Identifier: BSD-3-Clause
#include "models/urdf_to_mjcf/urdf_graph.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace sidestep {
namespace {

class GraphChecker {
 public:
  explicit GraphChecker(UrdfDocument* document)
      : robot_(document->robot()), notes_(document->notes()) {}

  void Check() {
    ForEachChild(robot_, "link", [&](TiXmlElement& link) {
      places_.emplace(TextOf(link, "name"), PlaceOf(link));
      order_.push_back(TextOf(link, "name"));
    });
    if (order_.empty()) return notes_.Problem(PlaceOf(robot_), "the robot has no <link>");
    if (order_.size() > kMaxUrdfLinks) {
      return notes_.Problem(PlaceOf(robot_), "the robot has " + std::to_string(order_.size()) +
                                                 " links, more than " +
                                                 std::to_string(kMaxUrdfLinks));
    }
    ForEachChild(robot_, "joint", [&](TiXmlElement& joint) { AddJoint(joint); });
    if (notes_.has_problems()) return;
    CheckRoots();
  }

 private:
  static std::string LinkOf(const TiXmlElement& joint, const char* side) {
    const TiXmlElement* link = joint.FirstChildElement(side);
    return link != nullptr ? TextOf(*link, "link") : "";
  }

  void AddJoint(const TiXmlElement& joint) {
    const std::string label = "joint '" + TextOf(joint, "name") + "'";
    const std::string parent = LinkOf(joint, "parent"), child = LinkOf(joint, "child");
    bool is_good = !parent.empty() && !child.empty();
    for (const std::string& link : {parent, child}) {
      if (link.empty() || places_.contains(link)) continue;
      notes_.Problem(PlaceOf(joint), label + " joins link '" + link +
                                         "', which is not there; add the link or remove the joint");
      is_good = false;
    }
    if (!is_good) return;
    if (parent == child) {
      return notes_.Problem(PlaceOf(joint), label + " joins link '" + child + "' to itself");
    }
    const auto [first, is_new] = joint_above_.emplace(child, TextOf(joint, "name"));
    if (!is_new) {
      return notes_.Problem(PlaceOf(joint),
                            label + " gives link '" + child + "' a second parent, beside joint '" +
                                first->second + "'; a URDF is a tree, so that loops must be cut");
    }
    children_[parent].push_back(child);
  }

  /// There must be one root, from which every link is reached: what isn't, loops.
  void CheckRoots() {
    std::string root;
    for (const std::string& link : order_) {
      if (joint_above_.contains(link)) continue;
      if (!root.empty()) {
        notes_.Problem(places_[link], "link '" + link + "' hangs on nothing, and so does '" + root +
                                          "'; a robot is one tree: join them or remove one");
      }
      if (root.empty()) root = link;
    }
    if (root.empty()) {
      return notes_.Problem(places_[order_.front()],
                            "every link hangs on another, in a loop; a URDF is a tree with a root");
    }
    if (notes_.has_problems()) return;
    const std::set<std::string> reached = Reach(root);
    for (const std::string& link : order_) {
      if (!reached.contains(link) && !notes_.has_problems()) {
        notes_.Problem(places_[link], "link '" + link + "' hangs on a loop of links, not on '" +
                                          root + "'; a URDF is a tree, so that loops must be cut");
      }
    }
  }

  std::set<std::string> Reach(const std::string& root) {
    std::set<std::string> reached{root};
    std::vector<std::string> level{root};
    for (int depth = 0; !level.empty(); ++depth) {
      if (depth > kMaxUrdfDepth) {
        notes_.Problem(places_[level.front()], "link '" + level.front() + "' hangs on more than " +
                                                   std::to_string(kMaxUrdfDepth) +
                                                   " joints in a row");
        break;
      }
      std::vector<std::string> next;
      for (const std::string& link : level) {
        for (const std::string& child : children_[link]) {
          if (reached.insert(child).second) next.push_back(child);
        }
      }
      level = std::move(next);
    }
    return reached;
  }

  TiXmlElement& robot_;
  FileNotes& notes_;
  std::vector<std::string> order_;           ///< Of links, as in the file.
  std::map<std::string, TextPlace> places_;  ///< Of links.
  std::map<std::string, std::string> joint_above_;
  std::map<std::string, std::vector<std::string>> children_;
};

}  // namespace

void CheckGraph(UrdfDocument* document) { GraphChecker(document).Check(); }

}  // namespace sidestep
