// SPDX-License-Identifier: BSD-3-Clause
// Zero moment points and signs of the correction, by hand.
#include "controller/wbc/com_zmp_correction.h"

#include <gtest/gtest.h>

namespace sidestep::wbc::com_zmp_correction_test {
namespace {

constexpr double kRounding = 1e-12;
constexpr double kQuarter = 0.5 * 3.14159265358979323846;

FootState Foot(const Eigen::Vector3d& p_WF, const Wrench& wrench) {
  FootState foot;
  foot.p_WF = p_WF;
  foot.wrench = wrench;
  return foot;
}

TEST(ZeroMomentPointTest, LiesBetweenTheFeetNearerTheOneThatBearsMore) {
  const std::vector<FootState> feet{Foot({0.1, 0.08, 0.0}, {{0, 0, 100.0}, {0, 0, 0}}),
                                    Foot({0.3, -0.08, 0.0}, {{0, 0, 300.0}, {0, 0, 0}})};
  const auto zmp = ZeroMomentPoint(feet, 10.0);
  ASSERT_TRUE(zmp);
  // (100 * 0.1 + 300 * 0.3) / 400, (100 * 0.08 - 300 * 0.08) / 400.
  EXPECT_LT((*zmp - Eigen::Vector2d(0.25, -0.04)).norm(), kRounding);
}

TEST(ZeroMomentPointTest, TorqueOfAFootMovesItWithinTheSole) {
  // Upward force ahead of F turns about -y, to the left of F about +x.
  const auto zmp =
      ZeroMomentPoint({Foot({0.1, 0.2, 0.0}, {{0, 0, 100.0}, {5.0, -3.0, 7.0}})}, 10.0);
  ASSERT_TRUE(zmp);
  EXPECT_LT((*zmp - Eigen::Vector2d(0.1 + 0.03, 0.2 + 0.05)).norm(), kRounding);
}

TEST(ZeroMomentPointTest, ForceOverTheGroundIsFollowedDownAlongItsLine) {
  // From 0.05 m above the ground along (10, -20, 100): 5 mm back and 10 mm to the left.
  const auto zmp = ZeroMomentPoint({Foot({0.1, 0.2, 0.05}, {{10, -20, 100}, {0, 0, 0}})}, 10.0);
  ASSERT_TRUE(zmp);
  EXPECT_LT((*zmp - Eigen::Vector2d(0.095, 0.21)).norm(), kRounding);
}

TEST(ZeroMomentPointTest, FeetThatCarryTooLittleHaveNone) {
  const auto carrying = [](double force_N) {
    return ZeroMomentPoint({Foot({0.1, 0.2, 0.0}, {{0, 0, force_N}, {0, 0, 0}})}, 50.0);
  };
  EXPECT_FALSE(carrying(49.9));
  EXPECT_TRUE(carrying(50.1));
  EXPECT_FALSE(carrying(-500.0));
  EXPECT_FALSE(ZeroMomentPoint({}, 50.0));
}

/// One foot at (0.2, -0.1, 0), turned a quarter to the left, of two vertices 0.1 m ahead and behind
/// in F: in W 0.1 m to the left and to the right.
class PlannedZeroMomentPointTest : public testing::Test {
 protected:
  PlannedZeroMomentPointTest() {
    vertices_m_[0] = Eigen::Matrix3Xd::Zero(3, 2);
    vertices_m_[0].row(0) << 0.1, -0.1;
    feet_[0].contact.R_WF =
        Eigen::AngleAxisd(kQuarter, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    feet_[0].contact.adjusted_p_WF = {0.2, -0.1, 0.0};
    feet_[0].vertex_force_N.setZero(3, 2);
  }

  std::vector<FootTarget> feet_{1};
  std::vector<Eigen::Matrix3Xd> vertices_m_{1};
};

TEST_F(PlannedZeroMomentPointTest, WeighsTheVerticesByTheirForces) {
  feet_[0].vertex_force_N.row(2) << 30.0, 10.0;
  const auto zmp = PlannedZeroMomentPoint(feet_, vertices_m_, 10.0);
  ASSERT_TRUE(zmp);
  EXPECT_LT((*zmp - Eigen::Vector2d(0.2, -0.1 + 0.1 * (30.0 - 10.0) / 40.0)).norm(), kRounding);
}

TEST_F(PlannedZeroMomentPointTest, IsWhereTheContactIsAdjustedToNotWhereTheFootFlies) {
  feet_[0].vertex_force_N.row(2) << 20.0, 20.0;
  feet_[0].p_WF = {5.0, 5.0, 5.0};
  feet_[0].contact.nominal_p_WF = {7.0, 7.0, 7.0};
  const auto zmp = PlannedZeroMomentPoint(feet_, vertices_m_, 10.0);
  ASSERT_TRUE(zmp);
  EXPECT_LT((*zmp - Eigen::Vector2d(0.2, -0.1)).norm(), kRounding);
}

TEST_F(PlannedZeroMomentPointTest, FootWithoutForceDoesNotCount) {
  feet_[0].vertex_force_N.row(2) << 20.0, 20.0;
  feet_.push_back(feet_[0]);
  vertices_m_.push_back(vertices_m_[0]);
  feet_[1].contact.adjusted_p_WF = {3.0, 3.0, 0.0};
  feet_[1].vertex_force_N.setZero();
  const auto zmp = PlannedZeroMomentPoint(feet_, vertices_m_, 10.0);
  ASSERT_TRUE(zmp);
  EXPECT_LT((*zmp - Eigen::Vector2d(0.2, -0.1)).norm(), kRounding);
}

TEST_F(PlannedZeroMomentPointTest, PlanWithoutForcesHasNone) {
  EXPECT_FALSE(PlannedZeroMomentPoint(feet_, vertices_m_, 10.0));
}

class CorrectedComVelocityTest : public testing::Test {
 protected:
  CorrectedComVelocityTest() {
    params_.com_feedback_per_s = 4.0;
    params_.zmp_feedback_per_s = 0.5;
    state_.p_WC = {0.10, 0.20, 0.50};
    com_.p_WC = state_.p_WC;
    com_.v_WC = {0.3, -0.2, 0.1};
  }

  InverseKinematicsParams params_;
  RobotState state_;
  ComTarget com_;
};

TEST_F(CorrectedComVelocityTest, OnPlanItIsThePlansVelocity) {
  const Eigen::Vector2d zmp(0.1, 0.1);
  EXPECT_LT((CorrectedComVelocity(params_, state_, com_, zmp, zmp) - com_.v_WC).norm(), kRounding);
}

TEST_F(CorrectedComVelocityTest, ComBehindItsPlanIsSentForward) {
  com_.p_WC += Eigen::Vector3d(0.01, -0.02, 0.03);
  const Eigen::Vector3d v_WC =
      CorrectedComVelocity(params_, state_, com_, std::nullopt, std::nullopt);
  EXPECT_LT((v_WC - com_.v_WC - Eigen::Vector3d(0.04, -0.08, 0.12)).norm(), kRounding);
}

TEST_F(CorrectedComVelocityTest, ZmpAheadOfItsPlanSendsTheComAheadAndLeavesTheHeightAlone) {
  const Eigen::Vector3d v_WC = CorrectedComVelocity(
      params_, state_, com_, Eigen::Vector2d(0.1, 0.1), Eigen::Vector2d(0.12, 0.06));
  EXPECT_LT((v_WC - com_.v_WC - Eigen::Vector3d(0.01, -0.02, 0.0)).norm(), kRounding);
}

TEST_F(CorrectedComVelocityTest, WithoutEitherZmpThereIsNothingToCompare) {
  const Eigen::Vector2d far(9.0, 9.0);
  EXPECT_EQ(CorrectedComVelocity(params_, state_, com_, std::nullopt, far), com_.v_WC);
  EXPECT_EQ(CorrectedComVelocity(params_, state_, com_, far, std::nullopt), com_.v_WC);
}

}  // namespace
}  // namespace sidestep::wbc::com_zmp_correction_test
