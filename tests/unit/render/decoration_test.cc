// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/decoration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "sim/render/foothold_marks.h"

namespace sidestep::render::decoration_test {
namespace {

StateRow PushedRow(double force_N) {
  StateRow row;
  row.time_s = 1.0;
  row.push_force_W << 0.0, force_N, 0.0;
  row.push_point_W << 0.1, 0.2, 0.9;
  return row;
}

StateLog LogOf(const std::vector<StateRow>& rows) {
  StateLog log;
  log.dt_s = 0.01;
  log.rows = rows;
  return log;
}

FootRow Foot(const Eigen::Vector3d& nominal, const Eigen::Vector3d& adjusted) {
  return {Eigen::Vector3d::Zero(), nominal, nominal, adjusted};
}

Footstep Step(double start_s, double end_s, const Eigen::Vector3d& p_WF) {
  Footstep step;
  step.foot = "left";
  step.start_s = start_s;
  step.end_s = end_s;
  step.nominal_p_WF = p_WF;
  step.adjusted_p_WF = p_WF;
  return step;
}

std::vector<Decoration> Plates(const std::vector<Decoration>& marks) {
  std::vector<Decoration> plates;
  for (const Decoration& mark : marks) {
    if (mark.color.head<3>().isApprox(FootColor(0).head<3>()) && mark.shape == Shape::kSlab) {
      plates.push_back(mark);
    }
  }
  return plates;
}

TEST(PushArrowTest, ThereIsNoneWithoutAPush) {
  EXPECT_TRUE(PushArrow(PushedRow(0.0), DrawScale{0.5, 0.01, 0.01}).empty());
}

TEST(PushArrowTest, ItComesFromOutsideAndItsTipIsThePointOfApplication) {
  const auto arrows = PushArrow(PushedRow(40.0), DrawScale{0.5, 0.01, 0.01});
  ASSERT_EQ(arrows.size(), 1U);
  EXPECT_TRUE(arrows[0].to.isApprox(Eigen::Vector3d(0.1, 0.2, 0.9)));
  // 40 N at 0.01 m/N: 0.4 m against the force's direction.
  EXPECT_TRUE(arrows[0].from.isApprox(Eigen::Vector3d(0.1, -0.2, 0.9)));
  EXPECT_EQ(arrows[0].label, "40 N");
}

TEST(PushArrowTest, ADoubledForceDoublesItsLength) {
  const DrawScale scale{0.5, 0.01, 0.01};
  const auto length = [&](double force_N) {
    const auto arrows = PushArrow(PushedRow(force_N), scale);
    return (arrows[0].to - arrows[0].from).norm();
  };
  EXPECT_NEAR(length(80.0), 2.0 * length(40.0), 1e-12);
}

TEST(PushArrowTest, AWeakPushIsLabelledWithADecimal) {
  EXPECT_EQ(PushArrow(PushedRow(5.04), DrawScale{})[0].label, "5.0 N");
  EXPECT_EQ(PushArrow(PushedRow(0.26), DrawScale{})[0].label, "0.3 N");
  EXPECT_EQ(PushArrow(PushedRow(9.96), DrawScale{})[0].label, "10 N");
}

TEST(DrawScaleTest, TheLargestPushOfTheRunHasTheSameLengthForAnyForce) {
  const auto length = [](double force_N) {
    const StateLog log = LogOf({PushedRow(0.0), PushedRow(force_N), PushedRow(0.5 * force_N)});
    return force_N * ScaleFor(log, 0.6).push_m_per_N;
  };
  EXPECT_NEAR(length(5.0), length(500.0), 1e-12);
  EXPECT_GT(length(5.0), 0.3);
}

TEST(DrawScaleTest, ARunWithoutPushesAndContactsHasFiniteScales) {
  const DrawScale scale = ScaleFor(LogOf({PushedRow(0.0)}), 0.6);
  EXPECT_EQ(scale.push_m_per_N, 0.0);
  EXPECT_EQ(scale.contact_m_per_N, 0.0);
}

TEST(ContactForceArrowsTest, OnlyLoadedFeetHaveOneAndItPointsAlongTheForce) {
  StateRow row = PushedRow(0.0);
  row.feet = {Foot({0, 0.1, 0}, {0, 0.1, 0}), Foot({0, -0.1, 0}, {0, -0.1, 0})};
  row.feet[0].f_F_W << 0.0, 3.0, 4.0;
  const auto arrows = ContactForceArrows(row, DrawScale{0.5, 0.0, 0.02});
  ASSERT_EQ(arrows.size(), 1U);
  EXPECT_TRUE(arrows[0].from.isApprox(Eigen::Vector3d(0, 0.1, 0)));
  EXPECT_TRUE((arrows[0].to - arrows[0].from).isApprox(Eigen::Vector3d(0, 0.06, 0.08)));
}

TEST(ComTraceTest, ItJoinsSuccessivePointsAndFadesToTheOldest) {
  const auto lines = ComTrace({{0, 0, 1}, {0.1, 0, 1}, {0.1, 0, 1}, {0.2, 0, 1}}, DrawScale{});
  ASSERT_EQ(lines.size(), 4U) << "two in the air, two on the floor; the third has no length";
  EXPECT_LT(lines[0].color.w(), lines[2].color.w());
  EXPECT_TRUE(lines[2].to.isApprox(Eigen::Vector3d(0.2, 0, 1)));
  EXPECT_NEAR(lines[3].to.x(), 0.2, 1e-12);
  EXPECT_LT(lines[3].to.z(), 0.02);
}

class FootholdMarksTest : public ::testing::Test {
 protected:
  FootholdMarksTest() {
    row_.time_s = 5.0;
    row_.feet = {Foot({0.3, 0.1, 0.0}, {0.34, 0.12, 0.0})};
  }
  std::vector<Decoration> Marks(const std::vector<Footstep>& steps) const {
    return FootholdMarks(row_, {"left"}, steps, {sole_}, 2.0, DrawScale{0.5, 0.0, 0.0});
  }
  StateRow row_;
  Sole sole_{"left", {-0.05, -0.03}, {0.10, 0.03}, 0.02};
};

TEST_F(FootholdMarksTest, TheNextFootholdIsMarkedWhereItWasMovedTo) {
  const auto plates = Plates(Marks({}));
  ASSERT_EQ(plates.size(), 1U);
  // The sole's middle is 25 mm ahead of F and the floor 20 mm below it.
  EXPECT_TRUE(plates[0].from.isApprox(Eigen::Vector3d(0.365, 0.12, -0.02)));
  EXPECT_NEAR(plates[0].half_m.x(), 0.075, 1e-12);
}

TEST_F(FootholdMarksTest, AMovedFootholdHasALineFromItsNominalPlace) {
  const auto marks = Marks({});
  const auto line = std::find_if(marks.begin(), marks.end(),
                                 [](const Decoration& mark) { return mark.shape == Shape::kLine; });
  ASSERT_NE(line, marks.end());
  EXPECT_TRUE((line->to - line->from).isApprox(Eigen::Vector3d(0.04, 0.02, 0.0)));
  row_.feet[0].adjusted_p_WF = row_.feet[0].nominal_p_WF;
  for (const Decoration& mark : Marks({})) EXPECT_NE(mark.shape, Shape::kLine);
}

TEST_F(FootholdMarksTest, OnlyTheLastTwoSecondsAndThePresentAreShown) {
  const auto plates = Plates(Marks({Step(0.0, 2.9, {0.0, 0.1, 0.0}),     // too old
                                    Step(2.9, 4.0, {0.1, 0.1, 0.0}),     // one second ago
                                    Step(4.2, 6.0, {0.2, 0.1, 0.0}),     // now
                                    Step(6.2, 7.0, {0.9, 0.1, 0.0})}));  // not yet known
  ASSERT_EQ(plates.size(), 3U);
  EXPECT_NEAR(plates[0].from.x(), 0.125, 1e-12);
  EXPECT_NEAR(plates[1].from.x(), 0.225, 1e-12);
  EXPECT_NEAR(plates[2].from.x(), 0.365, 1e-12);
  EXPECT_NEAR(plates[0].color.w(), 0.5F * plates[1].color.w(), 1e-6) << "half its memory is over";
}

TEST_F(FootholdMarksTest, TheFootholdAFootStandsOnIsMarkedOnce) {
  row_.feet = {Foot({0.2, 0.1, 0.0}, {0.2, 0.1, 0.0})};
  EXPECT_EQ(Plates(Marks({Step(4.2, 6.0, {0.2, 0.1, 0.0})})).size(), 1U);
}

TEST_F(FootholdMarksTest, SolesHaveTheYawOfTheirContact) {
  Footstep past = Step(2.9, 4.0, {0.1, 0.1, 0.0});
  Footstep coming = Step(5.2, 6.0, {0.3, 0.1, 0.0});
  past.yaw_rad = 0.2;
  coming.yaw_rad = 0.5 * std::numbers::pi;
  const std::vector<Decoration> marks = Marks({past, coming});
  const auto plates = Plates(marks);
  ASSERT_EQ(plates.size(), 2U);
  EXPECT_EQ(plates[0].yaw_rad, 0.2);
  EXPECT_EQ(plates[1].yaw_rad, coming.yaw_rad);
  // The sole's middle, 25 mm ahead of F, is now to its left.
  EXPECT_TRUE(plates[1].from.isApprox(Eigen::Vector3d(0.34, 0.145, -0.02)));
  double reach_m = 0.0;
  for (const Decoration& mark : marks) {
    if (mark.shape != Shape::kSlab || mark.yaw_rad != coming.yaw_rad) continue;
    reach_m = std::max(reach_m, mark.from.y() - 0.1);
  }
  EXPECT_NEAR(reach_m, 0.10, 1e-12) << "the outline's front bar";
}

TEST_F(FootholdMarksTest, TheOutlineEnclosesTheSole) {
  double reach_m = 0.0;
  for (const Decoration& mark : Marks({})) {
    if (mark.color.head<3>().isApprox(kNominalColor.head<3>())) {
      reach_m = std::max(reach_m, mark.from.x() + mark.half_m.x() - 0.3);
    }
  }
  EXPECT_GE(reach_m, 0.10);
  EXPECT_LT(reach_m, 0.11);
}

TEST(DecorationTest, TheRoundShadowLiesOnTheLowestFloorBelowTheCom) {
  StateRow row;
  row.feet.resize(2);
  row.feet[0].nominal_p_WF << 0.0, 0.1, 0.25;
  row.feet[1].nominal_p_WF << 0.0, -0.1, 0.05;
  const auto shadow = GroundShadow(row, {0.3, -0.2, 0.9}, {.com_height_m = 0.6});
  ASSERT_EQ(shadow.size(), 1U);
  EXPECT_EQ(shadow[0].shape, Shape::kDisc);
  EXPECT_TRUE(shadow[0].from.isApprox(Eigen::Vector3d(0.3, -0.2, 0.05)));
  EXPECT_LT(shadow[0].color.w(), 0.5F) << "marks below it are seen";
  row.feet.clear();
  EXPECT_TRUE(GroundShadow(row, {0.3, -0.2, 0.9}, {.com_height_m = 0.6}).empty());
}

TEST(DecorationTest, ColoursAreThoseOfThePalette) {
  EXPECT_TRUE(Painted("#FF0080", 0.5F).isApprox(Color(1.0F, 0.0F, 128.0F / 255.0F, 0.5F)));
  EXPECT_TRUE(FootColor(1).isApprox(Painted(palette::Foot(1), FootColor(1).w())));
  EXPECT_FALSE(FootColor(0).isApprox(FootColor(1)));
}

}  // namespace
}  // namespace sidestep::render::decoration_test
