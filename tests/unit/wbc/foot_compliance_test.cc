// SPDX-License-Identifier: BSD-3-Clause
// How feet give way to moments and loads that the plan has not: signs and figures by hand.
#include "controller/wbc/foot_compliance.h"

#include <gtest/gtest.h>

namespace sidestep::wbc::foot_compliance_test {
namespace {

constexpr double kRounding = 1e-12;
constexpr double kTurn_radps_per_Nm = 0.002;
constexpr double kLift_mps_per_N = 1e-4;

/// Two feet of two vertices, 0.1 m ahead and 0.04 m to the left, and the same behind and to the
/// right. The plan has 150 N and 50 N on the left one's, 100 N on each of the right one's.
class FootComplianceTest : public testing::Test {
 protected:
  FootComplianceTest() {
    params_.foot_moment_compliance_radps_per_Nm = kTurn_radps_per_Nm;
    params_.foot_load_compliance_mps_per_N = kLift_mps_per_N;
    state_.feet.resize(2);
    for (std::size_t i = 0; i < 2; ++i) {
      vertices_m_[i].resize(3, 2);
      vertices_m_[i] << 0.1, -0.1, 0.04, -0.04, 0.0, 0.0;
      feet_[i].planned_contact = true;
      feet_[i].vertex_force_N.setZero(3, 2);
      state_.feet[i].in_contact = true;
    }
    feet_[0].vertex_force_N.row(2) << 150.0, 50.0;
    feet_[1].vertex_force_N.row(2) << 100.0, 100.0;
    // As planned: of the left foot 50 mm ahead and 20 mm to the left.
    Feel(0, 200.0, {4.0, -10.0, 0.0});
    Feel(1, 200.0, {0.0, 0.0, 0.0});
  }

  void Feel(std::size_t foot, double force_N, const Eigen::Vector3d& moment_Nm) {
    state_.feet[foot].wrench = {{0.0, 0.0, force_N}, moment_Nm};
  }

  std::vector<FootYielding> GiveWay() const {
    std::vector<FootYielding> yielding;
    wbc::GiveWay(params_, state_, feet_, vertices_m_, &yielding);
    return yielding;
  }

  InverseKinematicsParams params_;
  RobotState state_;
  std::vector<FootTarget> feet_{2};
  std::vector<Eigen::Matrix3Xd> vertices_m_{2};
};

TEST_F(FootComplianceTest, FeetThatFeelWhatIsPlannedStayAsTheyAre) {
  for (const FootYielding& foot : GiveWay()) {
    EXPECT_NEAR(foot.lift_mps, 0.0, kRounding);
    EXPECT_LT(foot.w_WF.norm(), kRounding);
  }
}

TEST_F(FootComplianceTest, FootTurnsWithTheMomentThatThePlanHasNot) {
  Feel(0, 200.0, {4.0 + 8.0, -10.0 - 6.0, 30.0});
  const std::vector<FootYielding> gives = GiveWay();
  EXPECT_LT((gives[0].w_WF - Eigen::Vector3d(0.016, -0.012, 0.0)).norm(), kRounding)
      << "and never about z";
  EXPECT_LT(gives[1].w_WF.norm(), kRounding);
}

TEST_F(FootComplianceTest, PlannedPressureCountsAndNotThePlannedMoment) {
  // Half the load at the same place has half the moment.
  Feel(0, 100.0, {2.0, -5.0, 0.0});
  EXPECT_LT(GiveWay()[0].w_WF.norm(), kRounding);
}

TEST_F(FootComplianceTest, FootThatBearsTooMuchRisesAsTheOtherGoesDown) {
  Feel(0, 300.0, {6.0, -15.0, 0.0});
  Feel(1, 100.0, {0.0, 0.0, 0.0});
  const std::vector<FootYielding> gives = GiveWay();
  EXPECT_NEAR(gives[0].lift_mps, 0.01, kRounding);  // 100 N above its half of 400 N
  EXPECT_NEAR(gives[1].lift_mps, -0.01, kRounding);
}

TEST_F(FootComplianceTest, LoneFootBearsWhatThereIs) {
  feet_[1] = {};
  feet_[1].vertex_force_N.setZero(3, 2);
  Feel(0, 700.0, {14.0, -35.0, 0.0});
  Feel(1, 0.0, {9.0, 9.0, 0.0});  // of a foot in the air: its own weight, if it were not known
  const std::vector<FootYielding> gives = GiveWay();
  EXPECT_NEAR(gives[0].lift_mps, 0.0, kRounding);
  EXPECT_EQ(gives[1].lift_mps, 0.0);
  EXPECT_EQ(gives[1].w_WF.norm(), 0.0);
}

TEST_F(FootComplianceTest, FootThatIsDueAndNotFeltGoesDownLevel) {
  state_.feet[1].in_contact = false;
  Feel(1, 0.0, {9.0, 9.0, 0.0});
  const FootYielding gives = GiveWay()[1];
  EXPECT_NEAR(gives.lift_mps, -0.01, kRounding);  // half of the 200 N of the other foot
  EXPECT_EQ(gives.w_WF.norm(), 0.0);
}

TEST_F(FootComplianceTest, NobodyGivesWayFasterThanAFootLands) {
  Feel(0, 1e5, {1e5, 1e5, 0.0});
  const FootYielding gives = GiveWay()[0];
  EXPECT_NEAR(gives.lift_mps, 0.1, kRounding);
  EXPECT_NEAR(gives.w_WF.norm(), 0.5, kRounding);
}

TEST_F(FootComplianceTest, WithoutComplianceOrForcesNothingMoves) {
  Feel(0, 300.0, {20.0, 20.0, 0.0});
  params_ = {};
  EXPECT_EQ(GiveWay()[0].lift_mps, 0.0);
  EXPECT_EQ(GiveWay()[0].w_WF.norm(), 0.0);
  params_.foot_load_compliance_mps_per_N = kLift_mps_per_N;
  for (std::size_t i = 0; i < 2; ++i) Feel(i, 0.0, {0.0, 0.0, 0.0});
  EXPECT_EQ(GiveWay()[0].lift_mps, 0.0);
}

}  // namespace
}  // namespace sidestep::wbc::foot_compliance_test
