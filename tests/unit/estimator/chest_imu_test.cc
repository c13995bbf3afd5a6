// SPDX-License-Identifier: BSD-3-Clause
// iCub3's IMU is on its chest, three joints away from the base. A motion of base and joints is
// chosen; what the IMU measures comes from differences of the site's poses along it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/estimator/leg_odometry.h"
#include "tests/support/icub3.h"
#include "tests/support/reference_robot.h"

namespace sidestep::chest_imu_test {
namespace {

constexpr double kStep_s = 1e-4;  // of differences
constexpr Eigen::Index kTorsoJoints = 3;
const Eigen::Vector3d kGravity_mps2(0.0, 0.0, -9.81);

/// From rest at home; the torso's joints swing at 1 Hz, and the base if it is to.
class ChestImuTest : public testing::Test {
 protected:
  RobotState At(double time_s, bool base_moves) {
    RobotState state = home_;
    const double swing = 1.0 - std::cos(6.3 * time_s), other = 1.0 - std::cos(4.1 * time_s);
    state.joint_position.head<kTorsoJoints>() +=
        swing * Eigen::Vector3d(-0.1, 0.15, 0.0) + other * Eigen::Vector3d(0.05, -0.05, 0.3);
    state.joint_position[6] += 0.1 * other;  // an elbow
    if (!base_moves) return state;
    state.p_WB += swing * Eigen::Vector3d(0.05, 0.0, -0.01) + other * Eigen::Vector3d(0.0, 0.1, 0);
    const Eigen::Vector3d turn =
        swing * Eigen::Vector3d(0.1, 0.0, 0.2) + other * Eigen::Vector3d(-0.05, 0.15, 0.0);
    state.q_WB = Eigen::AngleAxisd(turn.norm(), turn.normalized()) * home_.q_WB;
    if (time_s == 0.0) state.q_WB = home_.q_WB;
    return state;
  }

  Eigen::Vector3d ImuPosition(double time_s, bool base_moves) {
    reference_.SetPoses(At(time_s, base_moves));
    return reference_.Position(robot_.imu);
  }

  Eigen::Matrix3d ImuAttitude(double time_s, bool base_moves) {
    reference_.SetPoses(At(time_s, base_moves));
    return reference_.Rotation(robot_.imu);
  }

  /// What the sensors read at `time_s`; the feet press with `normal_force_N` each.
  SensorFrame FrameAt(double time_s, bool base_moves, double normal_force_N) {
    SensorFrame frame;
    const RobotState state = At(time_s, base_moves);
    const Eigen::VectorXd later = At(time_s + kStep_s, base_moves).joint_position;
    const Eigen::VectorXd sooner = At(time_s - kStep_s, base_moves).joint_position;
    frame.joint_position = state.joint_position;
    frame.joint_velocity = (later - sooner) / (2.0 * kStep_s);
    const Eigen::Matrix3d R_WU = ImuAttitude(time_s, base_moves);
    frame.imu.q_WU = R_WU;
    frame.imu.gyro_radps = R_WU.transpose() *
                           SmallTurn_W(ImuAttitude(time_s - kStep_s, base_moves),
                                       ImuAttitude(time_s + kStep_s, base_moves)) /
                           (2.0 * kStep_s);
    const Eigen::Vector3d a_WU =
        (ImuPosition(time_s + kStep_s, base_moves) - 2.0 * ImuPosition(time_s, base_moves) +
         ImuPosition(time_s - kStep_s, base_moves)) /
        (kStep_s * kStep_s);
    frame.imu.accelerometer_mps2 = R_WU.transpose() * (a_WU - kGravity_mps2);
    frame.feet.resize(2);
    reference_.SetPoses(state);
    for (const std::string& name : robot_.force_torque) {
      const bool is_foot = name.find("foot") != std::string::npos;
      const Eigen::Vector3d force_W(0.0, 0.0, is_foot ? 0.5 * normal_force_N : 0.0);
      frame.force_torque.push_back(
          {reference_.Rotation(name).transpose() * force_W, Eigen::Vector3d::Zero()});
    }
    return frame;
  }

  const RobotDescription robot_{Icub3()};
  RigidBody body_{robot_};
  ReferenceRobot reference_{robot_};
  const RobotState home_{IcubAtHome(&body_)};
};

TEST_F(ChestImuTest, BaseAttitudeAndRateComeThroughTheMovingJoints) {
  LegOdometry odometry(robot_, EstimatorParams{}, ExternalWrenchKnowledge::kUnknown, 0.005, body_);
  double fastest_joint_radps = 0.0;
  for (const double time_s : {0.1, 0.23, 0.4, 0.61, 0.8}) {
    const SensorFrame frame = FrameAt(time_s, true, 0.0);
    const RobotState state = odometry.Update(frame, &body_);
    const RobotState truth = At(time_s, true);
    const Eigen::Matrix3d R_WB = truth.q_WB.toRotationMatrix();
    EXPECT_LT(SmallTurn_W(R_WB, state.q_WB.toRotationMatrix()).norm(), 1e-9) << time_s;
    const Eigen::Vector3d w_WB = SmallTurn_W(At(time_s - kStep_s, true).q_WB.toRotationMatrix(),
                                             At(time_s + kStep_s, true).q_WB.toRotationMatrix()) /
                                 (2.0 * kStep_s);
    // Both rates are differences: kStep_s^2 times third derivatives below 100.
    EXPECT_LT((state.w_WB_B - R_WB.transpose() * w_WB).norm(), 2e-6) << time_s;
    EXPECT_GT((frame.imu.gyro_radps - reference_.Rotation(robot_.imu).transpose() * w_WB).norm(),
              0.1)
        << "the chest turns as the base does";
    fastest_joint_radps = std::max(fastest_joint_radps, frame.joint_velocity.cwiseAbs().maxCoeff());
  }
  EXPECT_GT(fastest_joint_radps, 1.0);
}

TEST_F(ChestImuTest, OffTheGroundTheBaseFollowsFromTheChestsAccelerations) {
  constexpr double kTick_s = 0.001;
  EstimatorParams params;
  params.contact_threshold_N = 25.0;
  LegOdometry odometry(robot_, params, ExternalWrenchKnowledge::kUnknown, kTick_s, body_);
  double speed_error_mps = 0.0, position_error_m = 0.0, speed_mps = 0.0;
  for (int tick = 0; tick <= 500; ++tick) {
    const double time_s = tick * kTick_s;
    const RobotState state = odometry.Update(FrameAt(time_s, true, 0.0), &body_);
    const Eigen::Vector3d v_WB =
        (At(time_s + kStep_s, true).p_WB - At(time_s - kStep_s, true).p_WB) / (2.0 * kStep_s);
    speed_error_mps = std::max(speed_error_mps, (state.v_WB - v_WB).norm());
    position_error_m = std::max(position_error_m, (state.p_WB - At(time_s, true).p_WB).norm());
    speed_mps = std::max(speed_mps, v_WB.norm());
    EXPECT_FALSE(state.feet[0].in_contact || state.feet[1].in_contact);
  }
  EXPECT_GT(speed_mps, 0.3);
  // First-order integration of an acceleration that changes by less than 10 m/s^2: half a tick of
  // it, 5 mm/s, and that for half a second.
  EXPECT_LT(speed_error_mps, 0.005);
  EXPECT_LT(position_error_m, 0.0025);
}

struct Drift {
  double speed_mps{0.0}, position_m{0.0}, turn_rad{0.0};
};

class StandingDriftTest : public ChestImuTest {
 protected:
  /// Largest errors within 2 s, standing while the torso swings; the accelerometer is 0.1 m/s^2
  /// off on every axis.
  Drift Stand(const EstimatorParams& params) {
    constexpr double kTick_s = 0.005;
    LegOdometry odometry(robot_, params, ExternalWrenchKnowledge::kUnknown, kTick_s, body_);
    Drift drift;
    for (int tick = 0; tick <= 400; ++tick) {
      SensorFrame frame = FrameAt(tick * kTick_s, false, 257.0);
      frame.imu.accelerometer_mps2 += Eigen::Vector3d(0.1, -0.1, 0.1);
      const RobotState& state = odometry.Update(frame, &body_);
      drift.speed_mps = std::max(drift.speed_mps, state.v_WB.norm());
      drift.position_m = std::max(drift.position_m, (state.p_WB - home_.p_WB).norm());
      drift.turn_rad = std::max(drift.turn_rad, state.q_WB.angularDistance(home_.q_WB));
      EXPECT_TRUE(state.feet[0].in_contact && state.feet[1].in_contact);
    }
    return drift;
  }
};

// Integrated alone, the bias is 0.35 m/s and 0.35 m after 2 s.
TEST_F(StandingDriftTest, StandingFeetHoldTheBaseThoughTheAccelerometerIsBiased) {
  const Drift drift = Stand(EstimatorParams{});
  // Measured 16 mm/s and 0.8 mm: in balance the filter takes 2.8 % of a tick's error from the feet,
  // so that the bias of 0.17 m/s^2 leaves 5 ms / 2.8 % of itself.
  EXPECT_LT(drift.speed_mps, 0.03);
  EXPECT_LT(drift.position_m, 0.002);
  EXPECT_LT(drift.turn_rad, 1e-9) << "the attitude is the IMU's";
}

TEST_F(StandingDriftTest, WithIcubsOwnSettingsHardlyAnythingIsLeftOfTheBias) {
  EstimatorParams params;  // of models/icub3/robot.yaml
  params.contact_threshold_N = 25.0;
  params.accelerometer_noise_mps2 = 10.0;
  params.foot_velocity_noise_mps = 0.003;
  const Drift drift = Stand(params);
  // Measured 2 um/s and 0.06 mm.
  EXPECT_LT(drift.speed_mps, 1e-5);
  EXPECT_LT(drift.position_m, 2e-4);
}

}  // namespace
}  // namespace sidestep::chest_imu_test
