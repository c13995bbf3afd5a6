// SPDX-License-Identifier: BSD-3-Clause
#include "controller/estimator/truth_estimator.h"

#include <gtest/gtest.h>

#include "models/support/require.h"

namespace sidestep::truth_estimator_test {
namespace {

RobotDescription Hopper() {
  return ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) /
                              "models/hopper/robot.yaml");
}

SensorFrame Frame() {
  SensorFrame frame;
  frame.joint_position = Eigen::Vector3d(0.1, -0.2, 0.3);
  frame.joint_velocity = Eigen::Vector3d(1.0, 2.0, -0.5);
  frame.feet = {{2.0}};
  frame.truth = TruthSample{{1.0, 2.0, 0.6},
                            Eigen::Quaterniond(0.9, 0.1, -0.2, 0.3).normalized(),
                            {0.3, -0.2, 0.1},
                            {0.5, 0.6, -0.7}};
  return frame;
}

TEST(TruthEstimatorTest, BelievesTheTruthAndDerivesTheRestFromIt) {
  RigidBody body(Hopper()), other(Hopper());
  TruthEstimator estimator(Hopper(), EstimatorParams{}, ExternalWrenchKnowledge::kUnknown, 0.001,
                           body);
  const SensorFrame frame = Frame();
  const RobotState& state = estimator.Update(frame, &body);
  EXPECT_EQ(state.p_WB, frame.truth->p_WB);
  EXPECT_EQ(state.q_WB.coeffs(), frame.truth->q_WB.coeffs());
  EXPECT_EQ(state.v_WB, frame.truth->v_WB);
  EXPECT_EQ(state.w_WB_B, frame.truth->w_WB_B);
  EXPECT_EQ(state.joint_position, frame.joint_position);
  EXPECT_EQ(state.joint_velocity, frame.joint_velocity);
  RobotState derived = state;
  other.Update(state);
  other.FillDerived(&derived);
  EXPECT_EQ(state.p_WC, derived.p_WC);
  EXPECT_EQ(state.v_WC, derived.v_WC);
  EXPECT_EQ(state.feet[0].p_WF, derived.feet[0].p_WF);
}

TEST(TruthEstimatorTest, FootStandsAboveTheContactThreshold) {
  RigidBody body(Hopper());
  EstimatorParams params;
  params.contact_threshold_N = 2.0;
  TruthEstimator estimator(Hopper(), params, ExternalWrenchKnowledge::kUnknown, 0.001, body);
  SensorFrame frame = Frame();
  EXPECT_FALSE(estimator.Update(frame, &body).feet[0].in_contact) << "at the threshold";
  frame.feet[0].normal_force_N = 2.1;
  EXPECT_TRUE(estimator.Update(frame, &body).feet[0].in_contact);
}

TEST(TruthEstimatorTest, FrameWithoutTruthBreaksTheContract) {
  RigidBody body(Hopper());
  TruthEstimator estimator(Hopper(), EstimatorParams{}, ExternalWrenchKnowledge::kUnknown, 0.001,
                           body);
  SensorFrame frame = Frame();
  frame.truth.reset();
  EXPECT_THROW(estimator.Update(frame, &body), ContractViolation);
}

TEST(CentroidalEstimatorTest, BelievesTheReducedState) {
  CentroidalEstimator estimator(2, 4.0, 0.3, ExternalWrenchKnowledge::kUnknown);
  SensorFrame frame;
  frame.feet = {{5.0}, {0.1}};
  frame.centroidal = CentroidalSample{
      {0.1, 0.2, 0.5}, {4.0, -2.0, 1.0}, {0.1, 0.2, 0.3}, {{0.0, 0.1, 0.0}, {0.0, -0.1, 0.0}}};
  const RobotState& state = estimator.Update(frame);
  EXPECT_EQ(state.p_WC, frame.centroidal->p_WC);
  EXPECT_EQ(state.v_WC, Eigen::Vector3d(1.0, -0.5, 0.25));
  EXPECT_EQ(state.angular_momentum, frame.centroidal->angular_momentum);
  EXPECT_EQ(state.feet[1].p_WF, frame.centroidal->p_WF[1]);
  EXPECT_TRUE(state.feet[0].in_contact);
  EXPECT_FALSE(state.feet[1].in_contact);
}

TEST(CentroidalEstimatorTest, FrameWithoutReducedStateBreaksTheContract) {
  CentroidalEstimator estimator(1, 1.0, 0.3, ExternalWrenchKnowledge::kUnknown);
  EXPECT_THROW(estimator.Update(SensorFrame{}), ContractViolation);
}

}  // namespace
}  // namespace sidestep::truth_estimator_test
