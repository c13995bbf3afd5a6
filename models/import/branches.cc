// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/branches.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace sidestep::importer {
namespace {

constexpr double kMirrorMass = 0.2;     // mirrored limbs differ in mass by less than this share
constexpr double kMirrorHeight = 0.05;  // and in height by less than this share of the robot's
constexpr double kMainShare = 0.5;      // of a branch's mass, where a limb forks

}  // namespace

std::vector<int> Branches::Chain(int ancestor, int link) const {
  std::vector<int> chain;
  for (const int joint : JointsBetween(robot_, ancestor, link)) {
    if (Joint(joint).is_moving()) chain.push_back(joint);
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

int Branches::CommonAncestor(int a, int b) const {
  std::set<int> above_a{a};
  for (const int joint : JointsBetween(robot_, robot_.root, a)) above_a.insert(Joint(joint).parent);
  while (above_a.count(b) == 0) b = Joint(robot_.joint_above[static_cast<std::size_t>(b)]).parent;
  return b;
}

double Branches::Lowest(int link) const {
  double lowest = std::min(Place(link).z(), zero_.CenterOfMass_W(link).z());
  for (const int joint : robot_.joints_below[static_cast<std::size_t>(link)]) {
    if (!Joint(joint).is_moving()) lowest = std::min(lowest, Lowest(Joint(joint).child));
  }
  return lowest;
}

std::vector<int> Branches::Ends() const {
  std::vector<int> ends;
  for (const SourceJoint& joint : robot_.joints) {
    if (!joint.is_moving()) continue;
    const std::vector<int> below = Subtree(robot_, joint.child);
    const bool is_end = std::none_of(below.begin() + 1, below.end(), [&](int link) {
      return Joint(robot_.joint_above[static_cast<std::size_t>(link)]).is_moving();
    });
    if (is_end) ends.push_back(joint.child);
  }
  std::sort(ends.begin(), ends.end(), [&](int a, int b) { return Lowest(a) < Lowest(b); });
  return ends;
}

bool Branches::MirrorEachOther(int link_a, int link_b) const {
  const double mass_a = SubtreeMass_kg(robot_, link_a), mass_b = SubtreeMass_kg(robot_, link_b);
  return std::abs(mass_a - mass_b) <= kMirrorMass * std::max(mass_a, mass_b) &&
         std::abs(Place(link_a).z() - Place(link_b).z()) <= kMirrorHeight * Height();
}

int Branches::Segment(int link) const {
  for (;;) {
    const int above = robot_.joint_above[static_cast<std::size_t>(link)];
    if (above < 0 || Joint(above).is_moving()) return link;
    link = Joint(above).parent;
  }
}

double Branches::SegmentMass_kg(int segment) const {
  double mass_kg = 0.0;
  for (const int link : robot_.order) {
    if (Segment(link) == segment)
      mass_kg += robot_.links[static_cast<std::size_t>(link)].mass.mass_kg;
  }
  return mass_kg;
}

std::optional<int> Branches::Next(int segment) const {
  std::optional<int> next;
  double most_kg = 0.0, all_kg = 0.0;
  for (const int below : Subtree(robot_, segment)) {
    const int joint = robot_.joint_above[static_cast<std::size_t>(below)];
    if (below == segment || !Joint(joint).is_moving() || Segment(Joint(joint).parent) != segment)
      continue;
    const double mass_kg = SubtreeMass_kg(robot_, below);
    all_kg += mass_kg;
    if (mass_kg <= most_kg) continue;
    most_kg = mass_kg;
    next = joint;
  }
  return most_kg > kMainShare * all_kg ? next : std::nullopt;
}

double Branches::FindHeight() const {
  double low = 0.0, high = 0.0;
  for (const int link : robot_.order) {
    low = std::min(low, Place(link).z());
    high = std::max(high, Place(link).z());
  }
  return std::max(high - low, 1e-6);
}

}  // namespace sidestep::importer
