// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/read_mjcf.h"

#include <algorithm>
#include <optional>
#include <set>

#include "models/import/mjcf_bodies.h"
#include "models/import/mjcf_motors.h"
#include "models/import/mjcf_rewrite.h"
#include "models/import/mjcf_shapes.h"
#include "models/import/posture.h"
#include "models/import/text.h"
#include "models/import/xml_tree.h"
#include "models/mjcf/mjcf.h"
#include "models/mjcf/mjcf_message.h"
#include "models/support/xml_bounds.h"
#include "models/support/xml_tags.h"

namespace sidestep::importer {
namespace {

// MuJoCo's compiler takes time by the square of these.
constexpr std::size_t kMaxBodies = 2000;   // as many as a URDF's links
constexpr std::size_t kMaxParts = 20'000;  // elements of all kinds
constexpr double kMostDistance_m = 10.0;   // of a body from its parent: see robot_parts.h

void Count(const XmlElement& element, std::size_t* bodies, std::size_t* parts) {
  *bodies += element.tag == "body" ? 1 : 0;
  ++*parts;
  for (const XmlElement& child : element.children) Count(child, bodies, parts);
}

void RefuseCrowds(const XmlElement& root, const std::string& place) {
  std::size_t bodies = 0, parts = 0;
  Count(root, &bodies, &parts);
  const bool is_bodies = bodies > kMaxBodies;
  if (!is_bodies && parts <= kMaxParts) return;
  throw ConfigError(place + ": error: has more than " +
                    std::to_string(is_bodies ? kMaxBodies : kMaxParts) +
                    (is_bodies ? " bodies" : " elements of robots and scenery"));
}

/// Compiles; MuJoCo's complaint gets the place in the maker's file.
MjModelPtr Compile(const XmlTree& tree, const XmlElement& root) {
  std::vector<const XmlElement*> lines;
  const std::string text = XmlText(root, &lines);
  try {
    return CompileMjcf(text, "", "");
  } catch (const ConfigError& error) {
    MjcfMessage message = ReadMjcfMessage(error.what());
    constexpr std::string_view kHead = ": error: ";
    if (message.what.starts_with(kHead)) message.what.erase(0, kHead.size());
    const auto line = static_cast<std::size_t>(message.line);
    const bool is_known = line >= 1 && line <= lines.size();
    throw ConfigError(
        std::vector{(is_known ? tree.Place(*lines[line - 1]) : tree.Place(tree.root)) +
                    ": error: " + message.what});
  }
}

/// A robot in millimetres, or scattered over the world, is a mistake to be told here.
void RefuseDistances(const SourceRobot& robot, const MjcfParts& parts, const std::string& place,
                     Problems* problems) {
  for (const SourceJoint& joint : robot.joints) {
    const SourceLink& link = robot.links[static_cast<std::size_t>(joint.child)];
    const double most_m = std::max(joint.X_PC.translation().cwiseAbs().maxCoeff(),
                                   link.mass.com_m.cwiseAbs().maxCoeff());
    if (most_m <= kMostDistance_m) continue;
    const auto known = parts.places.find("body " + link.name);
    problems->AddAt(known == parts.places.end() ? place : known->second,
                    "body '" + link.name + "' or its CoM is " + Figure(most_m, 3) +
                        " m away, which is more than " + Figure(kMostDistance_m) +
                        "; lengths are in metres");
  }
  problems->ThrowIfAny();
}

/// Bodies and joints by name become joints of the robot.
std::vector<SourceCoupling> TakeCouplings(const mjModel& model, const MjcfParts& parts,
                                          const MjcfBodies& bodies) {
  std::vector<SourceCoupling> couplings;
  for (const Coupling& coupling : parts.couplings) {
    SourceCoupling taken{{}, coupling.place, coupling.what};
    for (const std::string& name : coupling.joints) {
      const int id = mj_name2id(&model, mjOBJ_JOINT, name.c_str());
      if (id >= 0) taken.joints.push_back(bodies.joint[static_cast<std::size_t>(id)]);
    }
    std::set<int> between;  // above the one or the other, not both
    for (const std::string& name : coupling.bodies) {
      const int id = mj_name2id(&model, mjOBJ_BODY, name.c_str());
      const int link = id < 0 ? -1 : bodies.link[static_cast<std::size_t>(id)];
      if (link < 0) continue;
      for (const int joint : JointsBetween(bodies.robot, bodies.robot.root, link)) {
        if (!between.insert(joint).second) between.erase(joint);
      }
    }
    taken.joints.insert(taken.joints.end(), between.begin(), between.end());
    couplings.push_back(std::move(taken));
  }
  return couplings;
}

}  // namespace

bool IsMjcf(const std::filesystem::path& file) {
  const std::string text = ReadXmlText(file), name = file.string();
  const std::optional<XmlTag> outermost = XmlTags(name, text).Next();
  return outermost && outermost->name.starts_with("mujoco");
}

SourceRobot ReadMjcf(const std::filesystem::path& file, MeshFiles* files, Notes* notes) {
  const XmlTree tree = ReadXmlTree(file, *files);
  Problems problems(file.string());
  if (tree.root.tag != "mujoco") problems.AddAt(tree.Place(tree.root), "is no <mujoco>");
  const MjcfParts parts = RewriteMjcf(tree, files, &problems, notes);
  problems.ThrowIfAny();
  RefuseCrowds(parts.root, tree.Place(tree.root));
  const MjModelPtr model = Compile(tree, parts.root);
  MjcfBodies bodies = TakeBodies(*model, parts, tree.Place(tree.root), &problems, notes);
  RefuseDistances(bodies.robot, parts, tree.Place(tree.root), &problems);
  TakeShapes(*model, &bodies, files, notes);
  TakeMotors(*model, &bodies, notes);
  bodies.robot.couplings = TakeCouplings(*model, parts, bodies);
  bodies.robot.language = "MJCF";
  bodies.robot.name =
      tree.root.Text("model").empty() ? file.stem().string() : tree.root.Text("model");
  return std::move(bodies.robot);
}

}  // namespace sidestep::importer
