// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_couplings.h"

#include <algorithm>

namespace sidestep::importer {
namespace {

class CouplingFinder {
 public:
  CouplingFinder(const XmlTree& tree, MjcfParts* parts, Problems* problems, Notes* notes)
      : tree_(tree), parts_(*parts), problems_(*problems), notes_(*notes) {}

  void Find() {
    ForEach("actuator", [&](const XmlElement& actuator) {
      if (actuator.Find("tendon") != nullptr) pulled_.insert(actuator.Text("tendon"));
    });
    ForEach("equality", [&](const XmlElement& equality) {
      if (equality.Text("active") != "false") TakeEquality(equality);
    });
    ForEach("tendon", [&](const XmlElement& tendon) { TakeTendon(tendon); });
  }

 private:
  template <typename Visitor>
  void ForEach(const std::string& tag, Visitor&& visit) {
    for (const XmlElement& section : tree_.root.children) {
      if (section.tag != tag) continue;
      for (const XmlElement& element : section.children) visit(element);
    }
  }

  std::string NameOf(const XmlElement& element) const {
    return "<" + element.tag + "> '" + element.Text("name") + "'";
  }

  void TakeEquality(const XmlElement& equality) {
    const bool is_loop = equality.tag == "connect" || equality.tag == "weld";
    const std::string body1 = equality.Text("body1"), body2 = equality.Text("body2");
    if (equality.tag == "joint") {
      parts_.mimics.insert(equality.Text("joint1"));
    } else if (is_loop && !body1.empty() && (body2.empty() || body2 == "world")) {
      notes_.push_back(tree_.Place(equality) + ": left out " + NameOf(equality) +
                       ", which holds '" + body1 + "' in the world");
    } else if (is_loop && !body1.empty()) {
      parts_.couplings.push_back(
          {{},
           {body1, body2},
           tree_.Place(equality),
           NameOf(equality) + " closes a loop from '" + body1 + "' to '" + body2 + "'"});
    } else {
      problems_.AddAt(tree_.Place(equality),
                      NameOf(equality) + " can't be simulated here; delete it");
    }
  }

  void TakeTendon(const XmlElement& tendon) {
    const bool pulls = pulled_.count(tendon.Text("name")) > 0 ||
                       tendon.Find("stiffness") != nullptr || tendon.Find("damping") != nullptr;
    if (!pulls) {
      notes_.push_back(tree_.Place(tendon) + ": left out tendon '" + tendon.Text("name") +
                       "' and the limit that it sets");
      return;
    }
    Coupling coupling{{}, {}, tree_.Place(tendon), NameOf(tendon) + " is a tendon that pulls"};
    for (const XmlElement& part : tendon.children) {
      if (part.tag == "joint") coupling.joints.push_back(part.Text("joint"));
    }
    if (coupling.joints.empty()) {
      problems_.AddAt(tree_.Place(tendon),
                      NameOf(tendon) + " pulls along a path, which can't be simulated here");
    }
    parts_.couplings.push_back(std::move(coupling));
  }

  const XmlTree& tree_;
  MjcfParts& parts_;
  Problems& problems_;
  Notes& notes_;
  std::set<std::string> pulled_;
};

}  // namespace

void FindCouplings(const XmlTree& tree, MjcfParts* parts, Problems* problems, Notes* notes) {
  CouplingFinder(tree, parts, problems, notes).Find();
}

void RefuseCouplings(const std::vector<SourceCoupling>& couplings, const std::vector<int>& moving) {
  std::vector<std::string> lines;
  for (const SourceCoupling& coupling : couplings) {
    const bool is_moved = std::any_of(
        coupling.joints.begin(), coupling.joints.end(),
        [&](int joint) { return std::find(moving.begin(), moving.end(), joint) != moving.end(); });
    if (is_moved)
      lines.push_back(coupling.place + ": error: " + coupling.what +
                      ", and joints that move here are of it; delete it");
  }
  if (!lines.empty()) throw ConfigError(lines);
}

}  // namespace sidestep::importer
