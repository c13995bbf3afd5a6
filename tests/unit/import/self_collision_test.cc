// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/self_collision.h"

#include <algorithm>

#include "tests/unit/import/source_of.h"

namespace sidestep::importer {
namespace {

struct Fixture {
  SourceRobot robot = SourceOf(MakerRobot());
  Notes notes;
  BodyPlan plan = FindBodyPlan(robot, "robot.urdf", &notes);

  int Link(const std::string& name) const { return FindLink(robot, name); }
  bool Has(const std::vector<LinkPair>& pairs, const std::string& a, const std::string& b) const {
    const LinkPair pair{std::min(Link(a), Link(b)), std::max(Link(a), Link(b))};
    return std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
  }
};

TEST(SelfCollision, PairsLimbsButNotNeighbours) {
  const Fixture f;
  const std::vector<LinkPair> pairs = PairsOfLimbs(f.robot, f.plan);
  EXPECT_TRUE(f.Has(pairs, "left_foot", "right_foot"));
  EXPECT_TRUE(f.Has(pairs, "trunk", "left_forearm"));
  EXPECT_TRUE(f.Has(pairs, "left_forearm", "right_thigh"));
  EXPECT_FALSE(f.Has(pairs, "left_thigh", "left_foot"));
  EXPECT_FALSE(f.Has(pairs, "pelvis", "left_thigh"));
  EXPECT_FALSE(f.Has(pairs, "trunk", "head"));
}

TEST(SelfCollision, NearIsByDistanceBetweenShapes) {
  const Fixture f;
  LinkContacts contacts(f.robot, {{f.Link("left_shank"), f.Link("right_shank")}});
  Posture posture = ZeroPosture(f.robot);  // shanks 0.09 m wide, 0.18 m apart: 0.09 m between them
  EXPECT_EQ(contacts.Near(Placement(f.robot, posture), 0.085).size(), 0U);
  EXPECT_EQ(contacts.Near(Placement(f.robot, posture), 0.095).size(), 1U);
  posture.q[JointCalled(f.robot, "left_hip_roll")] = -0.3;
  EXPECT_EQ(contacts.Near(Placement(f.robot, posture), 0.0).size(), 1U);
}

TEST(SelfCollision, FindsFeetThatCanTouchAndLeavesOutWhatTouchesAtTheStart) {
  const Fixture f;
  const std::vector<LinkBlock> blocks = FindSelfCollision(f.robot, f.plan, ZeroPosture(f.robot));
  const std::vector<LinkBlock> again = FindSelfCollision(f.robot, f.plan, ZeroPosture(f.robot));
  ASSERT_FALSE(blocks.empty());
  ASSERT_EQ(blocks.size(), again.size());
  const auto has = [&](const std::vector<LinkBlock>& list, const std::string& a,
                       const std::string& b) {
    return std::any_of(list.begin(), list.end(), [&](const LinkBlock& block) {
      const auto in = [&](const std::vector<int>& side, const std::string& name) {
        return std::find(side.begin(), side.end(), f.Link(name)) != side.end();
      };
      return (in(block.first, a) && in(block.second, b)) ||
             (in(block.first, b) && in(block.second, a));
    });
  };
  EXPECT_TRUE(has(blocks, "left_foot", "right_foot"));
  Posture crossed = ZeroPosture(f.robot);
  crossed.q[JointCalled(f.robot, "left_hip_roll")] = -0.3;
  EXPECT_FALSE(has(FindSelfCollision(f.robot, f.plan, crossed), "left_shank", "right_shank"));
}

TEST(SelfCollision, CountsArmsThatAreTooNear) {
  const Fixture f;
  Posture posture = ZeroPosture(f.robot);
  EXPECT_EQ(CountArmsTooNear(f.robot, f.plan, posture), 0U);
  posture.q[JointCalled(f.robot, "left_shoulder_roll")] = -0.9;
  EXPECT_GT(CountArmsTooNear(f.robot, f.plan, posture), 0U);
}

}  // namespace
}  // namespace sidestep::importer
