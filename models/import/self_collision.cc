// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/self_collision.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "models/import/joint_ranges.h"

namespace sidestep::importer {
namespace {

constexpr int kPostures = 400;
constexpr unsigned kSeed = 1;
constexpr double kApart_m = 0.01;
constexpr double kLeastShare = 0.003;  // of the mass: no fingers, plates and screens

/// What a link belongs to.
enum class Part { kTrunk, kLeftLeg, kRightLeg, kLeftArm, kRightArm };

std::vector<Part> PartsOf(const SourceRobot& robot, const BodyPlan& plan) {
  std::vector<Part> parts(robot.links.size(), Part::kTrunk);
  const auto mark = [&](const Limb& limb, Part part) {
    if (limb.joints.empty()) return;
    const int first = robot.joints[static_cast<std::size_t>(limb.joints.front())].child;
    for (const int link : Subtree(robot, first)) parts[static_cast<std::size_t>(link)] = part;
  };
  mark(plan.legs[0], Part::kLeftLeg);
  mark(plan.legs[1], Part::kRightLeg);
  mark(plan.arms[0], Part::kLeftArm);
  mark(plan.arms[1], Part::kRightArm);
  return parts;
}

bool IsLeg(Part part) { return part == Part::kLeftLeg || part == Part::kRightLeg; }
bool IsArm(Part part) { return part == Part::kLeftArm || part == Part::kRightArm; }

/// Number of actuated joints that part two links.
std::size_t JointsApart(const SourceRobot& robot, const std::set<int>& actuated, int a, int b) {
  std::set<int> above;
  for (const int link : {a, b}) {
    for (const int joint : JointsBetween(robot, robot.root, link)) {
      if (actuated.count(joint) == 0) continue;
      if (!above.insert(joint).second) above.erase(joint);  // above both
    }
  }
  return above.size();
}

/// Pairs that touch in some posture.
std::set<LinkPair> SampleContacts(const SourceRobot& robot, const BodyPlan& plan,
                                  const Posture& start, LinkContacts* contacts) {
  std::set<LinkPair> touching;
  std::mt19937 random(kSeed);
  Posture posture = start;
  for (int i = 0; i < kPostures; ++i) {
    for (const int index : plan.Actuated()) {
      const SourceJoint& joint = robot.joints[static_cast<std::size_t>(index)];
      const double share = static_cast<double>(random()) / static_cast<double>(random.max());
      posture.q[index] = LowerEnd(joint) + share * (UpperEnd(joint) - LowerEnd(joint));
    }
    touching.merge(contacts->Near(Placement(robot, posture), 0.0));
  }
  return touching;
}

void AddOnce(int link, std::vector<int>* links) {
  if (std::find(links->begin(), links->end(), link) == links->end()) links->push_back(link);
}

/// Takes links out, the one with the most near ones first, until no two are near.
void TakeOutNear(const std::set<LinkPair>& near, LinkBlock* block) {
  for (;;) {
    std::map<int, int> counts;
    for (const int a : block->first) {
      for (const int b : block->second) {
        if (near.count({std::min(a, b), std::max(a, b)}) == 0) continue;
        ++counts[a];
        ++counts[b];
      }
    }
    if (counts.empty()) return;
    const int worst =
        std::max_element(counts.begin(), counts.end(), [](const auto& x, const auto& y) {
          return x.second < y.second;
        })->first;
    std::erase(block->first, worst);
    std::erase(block->second, worst);
  }
}

}  // namespace

std::vector<LinkPair> PairsOfLimbs(const SourceRobot& robot, const BodyPlan& plan) {
  const std::vector<Part> parts = PartsOf(robot, plan);
  const std::vector<int> joints = plan.Actuated();
  const std::set<int> actuated(joints.begin(), joints.end());
  const double least_kg = kLeastShare * TotalMass_kg(robot);
  const auto counts = [&](const SourceLink& link) {
    return !link.collisions.empty() && link.mass.mass_kg >= least_kg;
  };
  std::vector<LinkPair> pairs;
  for (std::size_t a = 0; a < robot.links.size(); ++a) {
    for (std::size_t b = a + 1; b < robot.links.size(); ++b) {
      const bool is_of_limbs = parts[a] != parts[b] && (IsArm(parts[a]) || IsArm(parts[b]) ||
                                                        (IsLeg(parts[a]) && IsLeg(parts[b])));
      if (!is_of_limbs || !counts(robot.links[a]) || !counts(robot.links[b])) continue;
      const LinkPair pair{static_cast<int>(a), static_cast<int>(b)};
      if (JointsApart(robot, actuated, pair.first, pair.second) > 1) pairs.push_back(pair);
    }
  }
  return pairs;
}

std::vector<LinkBlock> FindSelfCollision(const SourceRobot& robot, const BodyPlan& plan,
                                         const Posture& start) {
  const std::vector<LinkPair> pairs = PairsOfLimbs(robot, plan);
  if (pairs.empty()) return {};
  LinkContacts contacts(robot, pairs);
  const std::set<LinkPair> near = contacts.Near(Placement(robot, start), kApart_m);
  const std::vector<Part> parts = PartsOf(robot, plan);
  const auto part = [&](int link) { return parts[static_cast<std::size_t>(link)]; };
  std::map<std::pair<Part, Part>, LinkBlock> blocks;
  for (const auto& [a, b] : SampleContacts(robot, plan, start, &contacts)) {
    const bool is_turned = part(b) < part(a);
    const int first = is_turned ? b : a, second = is_turned ? a : b;
    LinkBlock& block = blocks[{part(first), part(second)}];
    AddOnce(first, &block.first);
    AddOnce(second, &block.second);
  }
  std::vector<LinkBlock> found;
  for (auto& [unused, block] : blocks) {
    TakeOutNear(near, &block);
    if (!block.first.empty() && !block.second.empty()) found.push_back(block);
  }
  return found;
}

std::size_t CountArmsTooNear(const SourceRobot& robot, const BodyPlan& plan,
                             const Posture& posture) {
  const std::vector<Part> parts = PartsOf(robot, plan);
  std::vector<LinkPair> pairs = PairsOfLimbs(robot, plan);
  std::erase_if(pairs, [&](const LinkPair& pair) {
    return !IsArm(parts[static_cast<std::size_t>(pair.first)]) &&
           !IsArm(parts[static_cast<std::size_t>(pair.second)]);
  });
  if (pairs.empty()) return 0;
  return LinkContacts(robot, pairs).Near(Placement(robot, posture), kApart_m).size();
}

}  // namespace sidestep::importer
