// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// self_collision: which links of a robot can run into each other.

#include <vector>

#include "models/import/body_plan.h"
#include "models/import/link_contacts.h"
#include "models/import/posture.h"

namespace sidestep::importer {

/// Every link of the first list against every one of the second.
struct LinkBlock {
  std::vector<int> first;
  std::vector<int> second;
};

/// Pairs of links that a limb has and another limb, or an arm and the trunk: links with shapes and
/// more than 0.3 % of the mass. Without pairs that one joint parts. The first is the smaller index.
std::vector<LinkPair> PairsOfLimbs(const SourceRobot& robot, const BodyPlan& plan);

/// Links that touch ones of another limb in some of a few hundred random postures within the
/// joints' ranges, a block for every two limbs. Left out of a block are links that are less than
/// 1 cm from ones of the other side at the start: they are drawn so, or their shapes are too wide.
/// The same for the same robot: the random numbers are seeded.
std::vector<LinkBlock> FindSelfCollision(const SourceRobot& robot, const BodyPlan& plan,
                                         const Posture& start);

/// Pairs of an arm and of what is no part of it, that are less than 1 cm apart.
std::size_t CountArmsTooNear(const SourceRobot& robot, const BodyPlan& plan,
                             const Posture& posture);

}  // namespace sidestep::importer
