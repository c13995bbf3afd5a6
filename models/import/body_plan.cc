// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/body_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "models/import/branches.h"
#include "models/import/side_names.h"
#include "models/import/text.h"
#include "models/import/upper_body.h"
#include "models/support/config_error.h"

namespace sidestep::importer {
namespace {

constexpr std::size_t kMinLegJoints = 2;  // with fewer it is not a leg that we could name
constexpr double kLeastClearance = 0.1;   // of the robot's height: all but legs is above the feet

class PlanFinder : private Branches {
 public:
  PlanFinder(const SourceRobot& robot, std::string file, Notes* notes)
      : Branches(robot), robot_(robot), file_(std::move(file)), notes_(notes) {}

  BodyPlan Find() {
    FindLegs();
    FindFacing();
    FindUpperBody(robot_, &plan_);
    const std::vector<int> actuated = plan_.Actuated();
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
      const int joint = static_cast<int>(i);
      const bool is_used = std::find(actuated.begin(), actuated.end(), joint) != actuated.end();
      if (robot_.joints[i].is_moving() && !is_used) plan_.locked.push_back(joint);
    }
    return plan_;
  }

 private:
  [[noreturn]] void Fail(const std::string& what) const {
    throw ConfigError(file_ + ": error: " + what);
  }

  void FindLegs() {
    const std::vector<int> ends = Ends();
    std::string arms;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      for (std::size_t k = i + 1; k < ends.size(); ++k) {
        const int pelvis = CommonAncestor(ends[i], ends[k]);
        const std::vector<int> chain = Chain(pelvis, ends[i]);
        if (chain.size() != Chain(pelvis, ends[k]).size() || chain.size() < kMinLegJoints) continue;
        if (!MirrorEachOther(ends[i], ends[k])) continue;
        if (IsArm(chain)) {
          arms = Name(ends[i]) + "' and '" + Name(ends[k]);
          continue;
        }
        plan_.pelvis = pelvis;
        RequireLowest(ends[i], ends[k]);
        plan_.legs = {Leg(ends[i]), Leg(ends[k])};
        return;
      }
    }
    const std::string coupled = CoupledLegJoints();
    if (!coupled.empty()) Fail("has no two legs with as many joints" + coupled);
    Fail(arms.empty() ? "has no two legs: no two branches of as many joints mirror each other"
                      : "has no two legs: '" + arms + "' end two arms, as their joints' names say");
  }

  /// What is to be said where legs lack the joints that follow others; empty if none does.
  std::string CoupledLegJoints() const {
    std::vector<int> coupled;
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
      const SourceJoint& joint = robot_.joints[i];
      if (joint.is_mimic && !joint.is_moving() && LegInName(joint.name) > 0) {
        coupled.push_back(static_cast<int>(i));
      }
    }
    if (coupled.empty()) return "";
    return ": " + NamesOf(coupled) +
           " can't follow another joint here and was fixed; take its <mimic> or "
           "<equality> out, and it moves by itself";
  }

  /// Whether the names of a branch's joints and links speak of an arm.
  bool IsArm(const std::vector<int>& chain) const {
    int votes = 0;
    for (const int joint : chain) {
      votes += LegInName(Joint(joint).name) + LegInName(Name(Joint(joint).child));
    }
    return votes < 0;
  }

  /// Arms of a robot without legs end above the rest of it.
  void RequireLowest(int left, int right) const {
    std::set<int> in_limbs;
    for (const int end : {left, right}) {
      for (const int link : Subtree(robot_, Joint(Chain(plan_.pelvis, end).front()).child)) {
        in_limbs.insert(link);
      }
    }
    const double feet = std::max(Lowest(left), Lowest(right));
    for (const int link : robot_.order) {
      const MassProperties& mass = Link(link).mass;  // an origin may be anywhere
      if (in_limbs.count(link) > 0 || !Link(link).has_mass() ||
          (zero().X_WL(link) * mass.com_m).z() > feet + kLeastClearance * Height())
        continue;
      Fail("has no two legs that stand on the ground: '" + Name(link) +
           "' is no higher than the ends of '" + Name(left) + "' and '" + Name(right) + "'");
    }
  }

  Limb Leg(int end) {
    Limb leg{Chain(plan_.pelvis, end), end};
    if (leg.joints.size() < kLegJoints && leg.joints.size() != kPointLegJoints) {
      Fail("the leg that ends in '" + Name(end) + "' has " + std::to_string(leg.joints.size()) +
           " joints (" + NamesOf(leg.joints) +
           "): a sole that is to stay flat wherever the pelvis goes needs six, a foot that is a "
           "point needs three" +
           CoupledLegJoints());
    }
    if (leg.joints.size() > kLegJoints) {
      const std::vector<int> toes(leg.joints.begin() + kLegJoints, leg.joints.end());
      notes_->push_back("locked " + NamesOf(toes) + ": a leg's joints beyond the sixth");
      leg.joints.resize(kLegJoints);
      leg.end = Joint(leg.joints.back()).child;
    }
    return leg;
  }

  const std::string& Name(int link) const {
    return robot_.links[static_cast<std::size_t>(link)].name;
  }
  std::string NamesOf(const std::vector<int>& joints) const {
    std::string text;
    for (const int joint : joints) text += (text.empty() ? "" : ", ") + Joint(joint).name;
    return text;
  }

  /// +1 if a leg's joints and links are called left, -1 right, 0 neither.
  int SideOf(const Limb& limb) const {
    int votes = SideInName(Name(limb.end));
    for (const int joint : limb.joints) {
      votes += SideInName(Joint(joint).name) + SideInName(Name(Joint(joint).child));
    }
    return votes > 0 ? 1 : votes < 0 ? -1 : 0;
  }

  /// Puts the left leg first and finds where the robot faces.
  void FindFacing() {
    Eigen::Vector3d across = Place(plan_.legs[0].end) - Place(plan_.legs[1].end);
    const bool is_sideways = std::abs(across.x()) > std::abs(across.y());
    int side = SideOf(plan_.legs[0]) - SideOf(plan_.legs[1]);
    if (side == 0 || (!is_sideways && FeetFaceAlongX() && side * across.y() < 0.0)) {
      if (side != 0) notes_->push_back("took the leg at y > 0 for the left one, against its name");
      side = is_sideways ? (across.x() < 0.0 ? 1 : -1) : (across.y() > 0.0 ? 1 : -1);
    }
    if (side < 0) {
      std::swap(plan_.legs[0], plan_.legs[1]);
      across = -across;
    }
    if (across.head<2>().norm() < kLeastLateral_m) Fail("its feet are not side by side at zero");
    const double facing = std::atan2(-across.x(), across.y());
    plan_.facing_rad = std::round(facing / (0.5 * std::numbers::pi)) * 0.5 * std::numbers::pi;
    if (plan_.facing_rad != 0.0) {
      notes_->push_back("the robot faces " + Figure(plan_.facing_rad * 180.0 / std::numbers::pi) +
                        " degrees from its x at zero");
    }
  }

  /// Whether the feet's masses lie before their ankles.
  bool FeetFaceAlongX() const {
    double ahead_m = 0.0;
    for (const Limb& leg : plan_.legs) {
      ahead_m +=
          zero().CenterOfMass_W(leg.end).x() - zero().X_WJ(leg.joints.back()).translation().x();
    }
    return ahead_m > 0.0;
  }

  const SourceRobot& robot_;
  std::string file_;
  Notes* notes_;
  BodyPlan plan_;
};

}  // namespace

std::vector<int> BodyPlan::Actuated() const {
  std::vector<int> joints;
  const auto add = [&](const std::vector<int>& more) {
    joints.insert(joints.end(), more.begin(), more.end());
  };
  for (const Limb& leg : legs) add(leg.joints);
  add(torso_joints);
  for (const Limb& arm : arms) add(arm.joints);
  return joints;
}

BodyPlan FindBodyPlan(const SourceRobot& robot, const std::string& file, Notes* notes) {
  return PlanFinder(robot, file, notes).Find();
}

}  // namespace sidestep::importer
