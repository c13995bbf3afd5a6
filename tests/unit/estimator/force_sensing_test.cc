// SPDX-License-Identifier: BSD-3-Clause
// Readings are made from known wrenches at places known by hand, on sensors that look every which
// way: what the sensor feels is its unloaded reading and the wrench, turned and moved.
#include "controller/estimator/force_sensing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "controller/estimator/truth_estimator.h"
#include "tests/support/box_biped.h"

namespace sidestep::force_sensing_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr double kRounding = 1e-9;

/// A sensor's site in the base, all joints at zero: by hand from the MJCF.
struct Site {
  std::size_t index;
  Eigen::Vector3d p_BS;
  Eigen::Quaterniond q_BS;
};
const Site kArm{0, {0.01, -0.15, 0.1}, {0.6, 0.8, 0.0, 0.0}};
const Site kLeftFront{1, {0.06, 0.09, -0.41}, {0.8, 0.36, -0.48, 0.0}};
const Site kLeftRear{2, {-0.05, 0.06, -0.41}, {0.0, 0.6, 0.0, 0.8}};
const Eigen::Vector3d kPalm_B(0.01, -0.15, 0.0);
const Eigen::Vector3d kLeftSole_B(0.0, 0.07, -0.45);

class ForceSensingTest : public testing::Test {
 protected:
  ForceSensingTest() {
    params_.contact_threshold_N = 25.0;
    params_.wrench_deadband_N = 5.0;
    sensing_ = ForceSensing(robot_, params_, kTick_s, body_);
    state_.p_WB = {0.3, -0.2, 0.6};
    state_.q_WB = Eigen::Quaterniond(0.9, 0.1, -0.2, 0.3).normalized();
    state_.joint_position.setZero(12);
    state_.joint_velocity.setZero(12);
    state_.feet.resize(2);
    body_.Update(state_);
    body_.FillDerived(&state_);
    frame_.feet.resize(2);
    for (const ForceTorqueKinematics& site :
         body_.PredictForceTorque(Eigen::VectorXd::Zero(body_.num_velocities()))) {
      frame_.force_torque.push_back(site.unloaded);
    }
  }

  /// Lets a wrench (in W, about the point p_B of the base) act beyond a sensor.
  void Load(const Site& site, const Wrench& wrench_W, const Eigen::Vector3d& p_B) {
    const Eigen::Matrix3d R_SW = (state_.q_WB * site.q_BS).toRotationMatrix().transpose();
    const Eigen::Vector3d arm_W = state_.q_WB * (p_B - site.p_BS);
    Wrench& reading = frame_.force_torque[site.index];
    reading.force_N += R_SW * wrench_W.force_N;
    reading.torque_Nm += R_SW * (wrench_W.torque_Nm + arm_W.cross(wrench_W.force_N));
  }

  const RobotState& Feed(int ticks) {
    for (int i = 0; i < ticks; ++i) sensing_.Update(frame_, &body_, &state_);
    return state_;
  }

  TempFolder folder_;
  const RobotDescription robot_{BoxBiped(folder_)};
  RigidBody body_{robot_};
  EstimatorParams params_;
  RobotState state_;
  SensorFrame frame_;
  ForceSensing sensing_{robot_, params_, kTick_s, body_};
};

TEST_F(ForceSensingTest, UnloadedReadingsAreNoTouchAtAll) {
  Feed(100);
  for (const FootState& foot : state_.feet) {
    EXPECT_LT(foot.wrench.force_N.norm(), kRounding);
    EXPECT_LT(foot.wrench.torque_Nm.norm(), kRounding);
    EXPECT_FALSE(foot.in_contact);
  }
  EXPECT_LT(sensing_.arms().force_N.norm(), kRounding);
  EXPECT_LT(sensing_.arms().torque_Nm.norm(), kRounding);
}

TEST_F(ForceSensingTest, WrenchAtTheHandIsRecoveredAboutTheCom) {
  const Wrench wrench_W{{7.0, -40.0, 11.0}, {0.5, -0.3, 0.8}};
  Load(kArm, wrench_W, kPalm_B);
  Feed(1);  // at once: nothing is smoothed here
  const Eigen::Vector3d p_WP = state_.p_WB + state_.q_WB * kPalm_B;
  const Eigen::Vector3d torque_Nm =
      wrench_W.torque_Nm + (p_WP - state_.p_WC).cross(wrench_W.force_N);
  EXPECT_LT((sensing_.arms().force_N - wrench_W.force_N).norm(), kRounding);
  EXPECT_LT((sensing_.arms().torque_Nm - torque_Nm).norm(), kRounding);
  EXPECT_GT((torque_Nm - wrench_W.torque_Nm).norm(), 1.0) << "without a lever it shows little";
}

TEST_F(ForceSensingTest, BothPlatesOfAFootAddUpAboutItsSole) {
  const Wrench front_W{{3.0, -2.0, 80.0}, {0.2, 0.4, -0.1}};
  const Wrench rear_W{{-1.0, 5.0, 30.0}, {0.0, -0.2, 0.3}};
  const Eigen::Vector3d toe_B(0.1, 0.1, -0.45), heel_B(-0.1, 0.04, -0.45);
  Load(kLeftFront, front_W, toe_B);
  Load(kLeftRear, rear_W, heel_B);
  frame_.feet[0].normal_force_N = 500.0;  // of a touch sensor that this foot does not go by
  const FootState& left = Feed(1).feet[0];
  const Eigen::Vector3d torque_Nm =
      front_W.torque_Nm + (state_.q_WB * (toe_B - kLeftSole_B)).cross(front_W.force_N) +
      rear_W.torque_Nm + (state_.q_WB * (heel_B - kLeftSole_B)).cross(rear_W.force_N);
  EXPECT_LT((left.wrench.force_N - Eigen::Vector3d(2.0, 3.0, 110.0)).norm(), kRounding)
      << "at once: a foot's wrench is not smoothed";
  EXPECT_LT((left.wrench.torque_Nm - torque_Nm).norm(), kRounding);
  EXPECT_LT(state_.feet[1].wrench.force_N.norm(), kRounding) << "the other foot feels nothing";
  EXPECT_LT(sensing_.arms().force_N.norm(), kRounding) << "nor do the arms";
}

TEST_F(ForceSensingTest, FootStandsWhenItIsPressedUpwardsBeyondTheThreshold) {
  const auto stands_under = [&](const Eigen::Vector3d& force_N) {
    const SensorFrame before = frame_;
    Load(kLeftFront, {0.5 * force_N, Eigen::Vector3d::Zero()}, kLeftSole_B);
    Load(kLeftRear, {0.5 * force_N, Eigen::Vector3d::Zero()}, kLeftSole_B);
    const bool stands = Feed(1).feet[0].in_contact;
    frame_ = before;
    EXPECT_FALSE(state_.feet[1].in_contact);
    return stands;
  };
  EXPECT_FALSE(stands_under({0.0, 0.0, 24.9}));
  EXPECT_TRUE(stands_under({0.0, 0.0, 25.1}));
  EXPECT_FALSE(stands_under({100.0, -100.0, 20.0})) << "a push aside is no ground";
  EXPECT_FALSE(stands_under({0.0, 0.0, -100.0})) << "nor is being pulled down";
}

TEST_F(ForceSensingTest, FootWithATouchSensorFeelsItsNormalForceAlone) {
  RobotDescription touching = robot_;
  touching.feet[0].force_torque.clear();
  ForceSensing sensing(touching, params_, kTick_s, body_);
  Load(kLeftFront, {{9.0, 9.0, 90.0}, Eigen::Vector3d::Zero()}, kLeftSole_B);
  frame_.feet[0].normal_force_N = 33.0;
  sensing.Update(frame_, &body_, &state_);
  EXPECT_EQ(state_.feet[0].wrench.force_N, Eigen::Vector3d(0.0, 0.0, 33.0));
  EXPECT_EQ(state_.feet[0].wrench.torque_Nm, Eigen::Vector3d::Zero());
  EXPECT_TRUE(state_.feet[0].in_contact);
}

// The shoulder speeds up at 20 rad/s^2: 0.8 kg on 0.25 m are 4 N that nobody exerts.
TEST_F(ForceSensingTest, InertiaOfAMovingArmIsNotTakenForAPush) {
  constexpr double kAcceleration_radps2 = 20.0;
  TruthEstimator estimator(robot_, params_, ExternalWrenchKnowledge::kEstimated, kTick_s, body_);
  RigidBody truth(robot_);
  const Eigen::VectorXd still = Eigen::VectorXd::Zero(truth.num_velocities());
  Eigen::VectorXd nudot = still;
  nudot[truth.actuated_velocity()[0]] = kAcceleration_radps2;
  const Eigen::Vector3d force_N(6.0, -8.0, 3.0);
  frame_.truth = TruthSample{state_.p_WB, state_.q_WB, state_.v_WB, state_.w_WB_B};
  double inertia_N = 0.0;
  Eigen::Vector3d felt_N;
  for (int tick = 0; tick < 200; ++tick) {
    const double time_s = tick * kTick_s;
    state_.joint_velocity[0] = -2.0 + kAcceleration_radps2 * time_s;
    state_.joint_position[0] = 0.4 - 2.0 * time_s + 0.5 * kAcceleration_radps2 * time_s * time_s;
    frame_.joint_position = state_.joint_position;
    frame_.joint_velocity = state_.joint_velocity;
    truth.Update(state_);
    const std::vector<ForceTorqueKinematics>& sites = truth.PredictForceTorque(nudot);
    for (std::size_t i = 0; i < 5; ++i) frame_.force_torque[i] = sites[i].unloaded;
    const ForceTorqueKinematics& arm = sites[kArm.index];
    frame_.force_torque[kArm.index].force_N += arm.R_WS.transpose() * force_N;
    const Eigen::Vector3d moving_N = arm.unloaded.force_N;
    truth.PredictForceTorque(still);
    inertia_N = (moving_N - arm.unloaded.force_N).norm();
    felt_N = estimator.Update(frame_, &body_).external_wrench.force_N;
  }
  EXPECT_GT(inertia_N, 3.0) << "hardly any inertia";
  // After twelve time constants of the smoothing, what was wrong at the start is gone.
  EXPECT_LT((felt_N - force_N).norm(), 1e-3);
}

}  // namespace
}  // namespace sidestep::force_sensing_test
