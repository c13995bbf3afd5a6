// SPDX-License-Identifier: BSD-3-Clause
// An estimator that is copied in mid-run: both go on bit for bit, each with a rigid body of its
// own.
#include <gtest/gtest.h>

#include <cmath>

#include "controller/estimator/leg_odometry.h"
#include "controller/estimator/truth_estimator.h"
#include "tests/support/box_biped.h"

namespace sidestep::estimator_copy_test {
namespace {

constexpr double kTick_s = 0.001;

class EstimatorCopyTest : public testing::TestWithParam<std::tuple<EstimatorKind, int>> {
 protected:
  EstimatorCopyTest() {
    params_.push_cutoff_hz = 3.0;
    params_.push_deadband_N = 0.0;
    params_.wrench_deadband_N = 0.0;
  }

  std::unique_ptr<StateEstimator> Make() const {
    const auto knowledge = ExternalWrenchKnowledge::kEstimated;
    if (std::get<0>(GetParam()) == EstimatorKind::kTruth) {
      return std::make_unique<TruthEstimator>(robot_, params_, knowledge, kTick_s, body_);
    }
    return std::make_unique<LegOdometry>(robot_, params_, knowledge, kTick_s, body_);
  }

  /// All in motion; feet and hands feel something else in every tick.
  SensorFrame Frame(int tick) const {
    const double t = 0.01 * tick;
    SensorFrame frame;
    frame.tick = tick;
    frame.imu.q_WU = Eigen::Quaterniond(1.0, 0.1 * std::sin(t), 0.2 * t, -0.1 * t).normalized();
    frame.imu.gyro_radps = {0.3 * std::sin(t), 0.2, -0.1};
    frame.imu.accelerometer_mps2 = {0.5, std::cos(3.0 * t), 9.81 - std::sin(2.0 * t)};
    const int joints = body_.num_actuators();
    frame.joint_position = Eigen::VectorXd::LinSpaced(joints, -0.2, 0.2) * std::sin(t);
    frame.joint_velocity = Eigen::VectorXd::LinSpaced(joints, -1.0, 1.5) * std::cos(t);
    frame.feet.resize(2);
    for (int i = 0; i < 5; ++i) {
      frame.force_torque.push_back(
          {{3.0 * i * std::sin(t), 2.0, 60.0 * std::sin(5.0 * t + i)}, {0.1, 0.2 * i, -0.3}});
    }
    frame.truth = TruthSample{{t, 0.0, 0.5}, frame.imu.q_WU, {1.0, 0.1 * t, 0.0}, {0.3, 0.2, t}};
    return frame;
  }

  static void ExpectSame(const RobotState& a, const RobotState& b) {
    EXPECT_EQ(a.p_WB, b.p_WB);
    EXPECT_EQ(a.q_WB.coeffs(), b.q_WB.coeffs());
    EXPECT_EQ(a.v_WB, b.v_WB);
    EXPECT_EQ(a.w_WB_B, b.w_WB_B);
    EXPECT_EQ(a.p_WC, b.p_WC);
    EXPECT_EQ(a.v_WC, b.v_WC);
    EXPECT_EQ(a.angular_momentum, b.angular_momentum);
    EXPECT_EQ(a.external_wrench.force_N, b.external_wrench.force_N);
    EXPECT_EQ(a.external_wrench.torque_Nm, b.external_wrench.torque_Nm);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(a.feet[i].in_contact, b.feet[i].in_contact);
      EXPECT_EQ(a.feet[i].wrench.force_N, b.feet[i].wrench.force_N);
      EXPECT_EQ(a.feet[i].wrench.torque_Nm, b.feet[i].wrench.torque_Nm);
      EXPECT_EQ(a.feet[i].p_WF, b.feet[i].p_WF);
    }
  }

  TempFolder folder_;
  const RobotDescription robot_{BoxBiped(folder_)};
  const RigidBody body_{robot_};
  EstimatorParams params_;
};

INSTANTIATE_TEST_SUITE_P(KindsAndTicks, EstimatorCopyTest,
                         testing::Combine(testing::Values(EstimatorKind::kSensors,
                                                          EstimatorKind::kTruth),
                                          testing::Values(0, 1, 37, 150)));

TEST_P(EstimatorCopyTest, EstimatorAndItsCloneGoOnAsOneThatWasNeverCopied) {
  const int copied_at = std::get<1>(GetParam());
  const std::unique_ptr<StateEstimator> never_copied = Make();
  std::unique_ptr<StateEstimator> original = Make();
  RigidBody reference_body(body_), original_body(body_);
  for (int tick = 0; tick < copied_at; ++tick) {
    never_copied->Update(Frame(tick), &reference_body);
    original->Update(Frame(tick), &original_body);
  }
  const std::unique_ptr<StateEstimator> clone = original->Clone();
  RigidBody clone_body(original_body);
  for (int tick = 0; tick < 50; ++tick) {  // the original goes its own way, and away
    original->Update(Frame(1000 - 7 * tick), &original_body);
  }
  original.reset();
  double felt_N = 0.0;
  for (int tick = copied_at; tick < copied_at + 200; ++tick) {
    const RobotState& expected = never_copied->Update(Frame(tick), &reference_body);
    ExpectSame(clone->Update(Frame(tick), &clone_body), expected);
    EXPECT_EQ(clone_body.mass_matrix(), reference_body.mass_matrix()) << tick;
    felt_N = std::max(felt_N, expected.external_wrench.force_N.norm());
  }
  EXPECT_GT(felt_N, 1.0) << "memory that holds nothing shows nothing";
}

}  // namespace
}  // namespace sidestep::estimator_copy_test
