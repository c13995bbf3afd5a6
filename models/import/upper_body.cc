// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/upper_body.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "models/import/branches.h"

namespace sidestep::importer {
namespace {

class UpperBodyFinder : private Branches {
 public:
  UpperBodyFinder(const SourceRobot& robot, BodyPlan* plan)
      : Branches(robot), robot_(robot), plan_(*plan) {}

  void Find() {
    FindArms();
    FindTorso();
  }

 private:
  bool IsInLegs(int link) const {
    for (const Limb& leg : plan_.legs) {
      const std::vector<int> below = Subtree(robot_, Joint(leg.joints.front()).child);
      if (std::find(below.begin(), below.end(), link) != below.end()) return true;
    }
    return false;
  }

  /// Whether any leg hangs below `link`.
  bool CarriesLegs(int link) const {
    const std::vector<int> below = Subtree(robot_, link);
    return std::find(below.begin(), below.end(), plan_.legs[0].end) != below.end();
  }

  double Lateral(int link) const {
    const Eigen::Vector3d p =
        Place(link) - 0.5 * (Place(plan_.legs[0].end) + Place(plan_.legs[1].end));
    return -std::sin(plan_.facing_rad) * p.x() + std::cos(plan_.facing_rad) * p.y();
  }

  void FindArms() {
    double best_kg = 0.0;
    for (const SourceJoint& left : robot_.joints) {
      for (const SourceJoint& right : robot_.joints) {
        if (!left.is_moving() || !right.is_moving() || &left == &right) continue;
        if (Segment(left.parent) != Segment(right.parent)) continue;
        if (IsInLegs(left.child) || IsInLegs(right.child)) continue;
        if (CarriesLegs(left.child) || CarriesLegs(right.child)) continue;
        if (!MirrorEachOther(left.child, right.child)) continue;
        const Limb arms[2] = {Arm(left), Arm(right)};
        if (Lateral(arms[0].end) < kLeastLateral_m || Lateral(arms[1].end) > -kLeastLateral_m)
          continue;
        const double mass_kg = SubtreeMass_kg(robot_, left.child);
        if (mass_kg <= best_kg || arms[0].joints.size() != arms[1].joints.size()) continue;
        best_kg = mass_kg;
        plan_.arms = {arms[0], arms[1]};
      }
    }
  }

  /// Down to where the limb forks into fingers, four joints at most.
  Limb Arm(const SourceJoint& first) const {
    Limb arm{{static_cast<int>(&first - robot_.joints.data())}, first.child};
    while (arm.joints.size() < kMaxArmJoints) {
      const std::optional<int> next = Next(arm.end);
      if (!next) break;
      arm.joints.push_back(*next);
      arm.end = Joint(*next).child;
    }
    return arm;
  }

  void FindTorso() {
    if (plan_.has_arms()) {
      plan_.torso = Segment(Joint(plan_.arms[0].joints.front()).parent);
    } else {
      double most_kg = 0.0;
      for (const int link : robot_.order) {
        if (Segment(link) != link || IsInLegs(link) || SegmentMass_kg(link) <= most_kg) continue;
        most_kg = SegmentMass_kg(link);
        plan_.torso = link;
      }
    }
    const int meeting = CommonAncestor(plan_.pelvis, plan_.torso);
    std::vector<int> down = Chain(meeting, plan_.pelvis);
    std::reverse(down.begin(), down.end());
    const std::vector<int> up = Chain(meeting, plan_.torso);
    plan_.torso_joints = down;
    plan_.torso_joints.insert(plan_.torso_joints.end(), up.begin(), up.end());
  }

  const SourceRobot& robot_;
  BodyPlan& plan_;
};

}  // namespace

void FindUpperBody(const SourceRobot& robot, BodyPlan* plan) {
  UpperBodyFinder(robot, plan).Find();
}

}  // namespace sidestep::importer
