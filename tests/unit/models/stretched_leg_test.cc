// SPDX-License-Identifier: BSD-3-Clause
// Lengths by hand, from the links of legs whose knee alone decides.
#include "models/mjcf/stretched_leg.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "models/mjcf/mjcf.h"

namespace sidestep::stretched_leg_test {
namespace {

constexpr double kRounding = 1e-12;

/// A thigh of 0.3 m and a shank of 0.4 m under a free base, an ankle 0.05 m above the sole.
MjState Leg(const std::string& knee, const std::string& ankle) {
  return MjState(CompileMjcf(
      "<mujoco><compiler angle='radian'/><worldbody>"
      "<body name='base' pos='0 0 1'><freejoint/><geom type='sphere' size='0.1'/>"
      "<body pos='0 0.1 -0.02'><joint axis='0 1 0'/><geom type='sphere' size='0.1'/>"
      "<body pos='0 0 -0.3'>" +
          knee +
          "<geom type='sphere' size='0.1'/>"
          "<body pos='0 0 -0.4'>" +
          ankle +
          "<geom type='sphere' size='0.1'/>"
          "<site name='foot' pos='0.03 0 -0.05'/></body></body></body></body></worldbody></mujoco>",
      "", "leg.xml"));
}

std::optional<StretchedLeg> Find(MjState leg, bool is_sole) {
  mj_kinematics(&leg.model(), leg.get());
  return FindStretchedLeg(leg, RequireId(leg.model(), mjOBJ_BODY, "base"),
                          RequireId(leg.model(), mjOBJ_SITE, "foot"), is_sole);
}

constexpr char kKnee[] = "<joint axis='0 1 0' limited='true' range='0 2.5'/>";
constexpr char kAnkle[] = "<joint axis='0 1 0'/>";

TEST(StretchedLegTest, OfASoleItGoesFromHipToAnkle) {
  const auto leg = Find(Leg(kKnee, kAnkle), true);
  ASSERT_TRUE(leg);
  EXPECT_LT((leg->p_WHip - Eigen::Vector3d(0.0, 0.1, 0.98)).norm(), kRounding);
  EXPECT_LT((leg->p_WAnkle - Eigen::Vector3d(0.0, 0.1, 0.28)).norm(), kRounding);
  EXPECT_NEAR(leg->length_m, 0.7, kRounding);
}

TEST(StretchedLegTest, OfAPointItGoesToThePoint) {
  const auto leg = Find(Leg(kKnee, ""), false);
  ASSERT_TRUE(leg);
  EXPECT_LT((leg->p_WAnkle - Eigen::Vector3d(0.03, 0.1, 0.23)).norm(), kRounding);
  // Shank and foot reach sqrt(0.45^2 + 0.03^2) from a knee that turns 0.0666 rad beyond straight.
  EXPECT_NEAR(leg->length_m, 0.3 + std::hypot(0.45, 0.03), 2e-4);
}

TEST(StretchedLegTest, AKneeThatStaysBentKeepsItShort) {
  const auto leg = Find(Leg("<joint axis='0 1 0' limited='true' range='1 2.5'/>", kAnkle), true);
  ASSERT_TRUE(leg);
  EXPECT_NEAR(leg->length_m, std::sqrt(0.09 + 0.16 + 0.24 * std::cos(1.0)), kRounding);
}

TEST(StretchedLegTest, ASlideReachesToItsEnd) {
  const auto leg = Find(
      Leg("<joint type='slide' axis='0 0 -1' limited='true' range='-0.1 0.15'/>", kAnkle), true);
  ASSERT_TRUE(leg);
  EXPECT_NEAR(leg->length_m, 0.85, kRounding);
}

TEST(StretchedLegTest, WithoutTwoJointsOrWithAnEndlessOneThereIsNone) {
  EXPECT_FALSE(Find(Leg("", ""), true));
  EXPECT_FALSE(Find(Leg("<joint type='slide' axis='0 0 -1'/>", kAnkle), true));
}

}  // namespace
}  // namespace sidestep::stretched_leg_test
