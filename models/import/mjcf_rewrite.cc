// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/mjcf_rewrite.h"

#include <algorithm>

#include "models/import/mjcf_couplings.h"
#include "models/import/mjcf_floors.h"
#include "models/import/mjcf_frames.h"
#include "models/import/mjcf_meshes.h"
#include "models/import/mjcf_newer.h"
#include "models/import/text.h"

namespace sidestep::importer {
namespace {

const std::set<std::string>& KeptDefaults() {
  static const std::set<std::string> kKept{"default",  "mesh",     "material", "joint",
                                           "geom",     "site",     "general",  "motor",
                                           "position", "velocity", "damper",   "intvelocity"};
  return kKept;
}

class Rewriter {
 public:
  Rewriter(const XmlTree& tree, MeshFiles* files, Problems* problems, Notes* notes)
      : tree_(tree), files_(files), problems_(*problems), notes_(*notes), newer_(tree, problems) {}

  MjcfParts Run() {
    parts_.root = {"mujoco", {}, {}, 0, 0};
    for (const char* name : {"compiler", "asset", "worldbody", "contact", "actuator"}) {
      parts_.root.children.push_back({name, {}, {}, 0, 0});
    }
    Part("compiler").Set("autolimits", "true");  // the default of today's MuJoCo
    for (const XmlElement& section : tree_.root.children) {
      if (section.tag == "compiler") TakeCompiler(section);  // wherever it stands, it holds
    }
    for (const XmlElement& section : tree_.root.children) TakeSection(section);
    Part("compiler").Set("convexhull", "false");  // we fit our own, and flat meshes have none
    parts_.root.children.insert(parts_.root.children.begin() + 1, defaults_.begin(),
                                defaults_.end());
    StandInForFloors(&Part("worldbody"), &Part("contact"), &notes_);
    ResolveMeshes(tree_, &Part("asset"), &parts_.root, files_, &problems_);
    FindCouplings(tree_, &parts_, &problems_, &notes_);
    newer_.Tell(&notes_);
    std::vector<std::string> tags;
    for (const auto& [tag, count] : passed_over_) {
      tags.push_back(std::to_string(count) + " <" + tag + ">");
    }
    if (!tags.empty()) {
      std::string text;
      for (const std::string& tag : tags) text += (text.empty() ? "" : ", ") + tag;
      notes_.push_back("passed over " + text);
    }
    return std::move(parts_);
  }

 private:
  XmlElement& Part(const std::string& tag) {
    return *std::find_if(parts_.root.children.begin(), parts_.root.children.end(),
                         [&](const XmlElement& part) { return part.tag == tag; });
  }

  void TakeSection(const XmlElement& section) {
    if (section.tag == "compiler") return;
    if (section.tag == "default") {
      XmlElement& copy = defaults_.emplace_back(section);
      copy.children.clear();
      TakeDefault(section, &copy);
    } else if (section.tag == "asset") {
      for (const XmlElement& asset : section.children) TakeAsset(asset);
    } else if (section.tag == "worldbody") {
      TakeBody(section, false, &Part("worldbody"));
    } else if (section.tag == "contact") {
      for (const XmlElement& pair : section.children) TakePair(pair);
    } else if (section.tag == "actuator") {
      for (const XmlElement& actuator : section.children) TakeActuator(actuator);
    } else if (section.tag != "equality" && section.tag != "tendon") {
      ++passed_over_[section.tag];  // those two: see mjcf_couplings
    }
  }

  /// What says where files are, and what would cost us bodies or shapes, is left out.
  void TakeCompiler(const XmlElement& compiler) {
    static const std::set<std::string> kLeftOut{
        "meshdir",    "texturedir", "assetdir",  "strippath", "discardvisual",
        "convexhull", "fusestatic", "usethread", "alignfree", "saveinertial"};
    XmlElement copy = compiler;
    copy.children.clear();
    std::erase_if(copy.attributes, [](const auto& a) { return kLeftOut.count(a.first) > 0; });
    newer_.Mend("mujoco", &copy);
    XmlElement& to = Part("compiler");
    to.file = copy.file;
    to.place = copy.place;
    for (const auto& [name, value] : copy.attributes) to.Set(name, value);
    is_always_from_geoms_ = to.Text("inertiafromgeom") == "true";
  }

  void TakeDefault(const XmlElement& from, XmlElement* to) {
    for (const XmlElement& child : from.children) {
      if (KeptDefaults().count(child.tag) == 0) continue;
      XmlElement copy = child;
      copy.children.clear();
      if (child.tag == "default") {
        TakeDefault(child, &copy);
      } else {
        newer_.Mend("default", &copy);
      }
      to->children.push_back(std::move(copy));
    }
  }

  void TakeAsset(const XmlElement& asset) {
    if (asset.tag != "mesh" && asset.tag != "material") {
      ++passed_over_[asset.tag];
      return;
    }
    XmlElement copy = asset;
    copy.children.clear();
    newer_.Mend("asset", &copy);
    if (asset.tag == "mesh") newer_.RefuseChildren(asset);
    Part("asset").children.push_back(std::move(copy));
  }

  /// @param has_inertial  Of the nearest body with a name: its shapes' masses don't count then.
  void TakeBody(const XmlElement& from, bool has_inertial, XmlElement* to) {
    static const std::set<std::string> kParts{"inertial", "joint", "freejoint", "geom", "site"};
    static const std::set<std::string> kUnseen{"camera", "light"};
    static const std::set<std::string> kScenery{"replicate", "composite", "flexcomp"};
    for (const XmlElement& child : from.children) {
      if (child.tag == "body" || child.tag == "frame") {
        TakeChild(child, has_inertial, to);
      } else if (kParts.count(child.tag) > 0) {
        TakePart(child, to);
      } else if (kUnseen.count(child.tag) > 0 ||
                 (to->tag == "worldbody" && kScenery.count(child.tag) > 0)) {
        ++passed_over_[child.tag];
      } else {
        newer_.RefuseElement(child);
      }
    }
  }

  void TakeChild(const XmlElement& from, bool has_inertial, XmlElement* to) {
    XmlElement body = from;
    body.tag = "body";
    body.children.clear();
    if (from.tag == "frame") {
      RefuseJointsIn(from);
      body.Erase("name");
      if (to->tag == "worldbody") {
        frames_.push_back(&from);
        TakeBody(from, false, to);  // what else is in it is scenery
        frames_.pop_back();
        return;
      }
      if (has_inertial) {
        XmlElement nothing{"inertial", {}, {}, from.file, from.place};
        nothing.attributes = {{"pos", "0 0 0"}, {"mass", "0"}, {"diaginertia", "0 0 0"}};
        body.children.push_back(std::move(nothing));
      }
    } else {
      has_inertial = !is_always_from_geoms_ &&
                     std::any_of(from.children.begin(), from.children.end(),
                                 [](const XmlElement& e) { return e.tag == "inertial"; });
      const std::string fault =
          to->tag == "worldbody" ? PutIntoFrames(frames_, Part("compiler"), &body) : std::string();
      if (!fault.empty()) {
        problems_.AddAt(tree_.Place(*frames_.back()), "<frame> can't be read" + fault);
      }
    }
    newer_.Mend("body", &body);
    if (const std::string* name = body.Find("name")) {
      parts_.places["body " + *name] = tree_.Place(from);
    }
    TakeBody(from, has_inertial, &body);
    to->children.push_back(std::move(body));
  }

  void RefuseJointsIn(const XmlElement& frame) {
    for (const XmlElement& child : frame.children) {
      if (child.tag != "joint" && child.tag != "freejoint") continue;
      problems_.AddAt(tree_.Place(child), "<joint> '" + child.Text("name") +
                                              "' is in a <frame>: move it into the body, in the "
                                              "body's axes");
    }
  }

  void TakePart(const XmlElement& from, XmlElement* to) {
    if (from.Find("hfield") != nullptr || from.Text("type") == "hfield") return;
    XmlElement part = from;
    part.children.clear();
    newer_.RefuseChildren(from);
    if (part.tag == "joint" && part.Find("name") == nullptr) {
      part.Set("name", "unnamed_joint_" + std::to_string(++num_unnamed_));
    }
    newer_.Mend("body", &part);
    if (part.tag == "joint") parts_.places["joint " + part.Text("name")] = tree_.Place(from);
    to->children.push_back(std::move(part));
  }

  /// A pair is looked at to see which shapes collide.
  void TakePair(const XmlElement& pair) {
    if (pair.tag != "pair") return;
    XmlElement copy{"pair", {}, {}, pair.file, pair.place};
    for (const char* geom : {"geom1", "geom2"}) copy.Set(geom, pair.Text(geom));
    Part("contact").children.push_back(std::move(copy));
  }

  void TakeActuator(const XmlElement& actuator) {
    static const std::set<std::string> kKept{"general",  "motor",  "position",
                                             "velocity", "damper", "intvelocity"};
    const bool is_of_joint = actuator.Find("joint") != nullptr || actuator.Find("jointinparent");
    if (actuator.Find("tendon") != nullptr) return;  // see mjcf_couplings
    if (kKept.count(actuator.tag) == 0 || !is_of_joint) {
      notes_.push_back(tree_.Place(actuator) + ": left out the <" + actuator.tag + "> '" +
                       actuator.Text("name") + "', which is no joint's motor");
      return;
    }
    XmlElement copy = actuator;
    copy.children.clear();
    newer_.Mend("actuator", &copy);
    Part("actuator").children.push_back(std::move(copy));
  }

  const XmlTree& tree_;
  MeshFiles* files_;
  Problems& problems_;
  Notes& notes_;
  NewerWords newer_;
  MjcfParts parts_;
  std::vector<XmlElement> defaults_;       // of every section: MuJoCo merges them itself
  std::vector<const XmlElement*> frames_;  // around a child of the world, the outermost first
  bool is_always_from_geoms_{false};
  int num_unnamed_{0};
  std::map<std::string, int> passed_over_;
};

}  // namespace

MjcfParts RewriteMjcf(const XmlTree& tree, MeshFiles* files, Problems* problems, Notes* notes) {
  return Rewriter(tree, files, problems, notes).Run();
}

}  // namespace sidestep::importer
