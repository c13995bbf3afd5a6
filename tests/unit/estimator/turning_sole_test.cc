// SPDX-License-Identifier: BSD-3-Clause
// iCub3 stands on a corner of its left sole, which turns under a body that keeps still: joints move
// so that base and CoM need not. In closed form the foot's frame goes round the corner,
//   p_F(t) = p_corner + R(t) (p_F(0) - p_corner),
// and whoever takes that frame for a fixed point takes the base for moving.
#include <gtest/gtest.h>

#include <algorithm>

#include "controller/estimator/leg_odometry.h"
#include "tests/support/icub3.h"
#include "tests/support/reference_robot.h"

namespace sidestep::turning_sole_test {
namespace {

constexpr double kTick_s = 0.005;
constexpr int kTicks = 100;
constexpr double kRate_radps = 0.6;  // what a pushed iCub's sole turns with
const Eigen::Vector3d kCorner_F(0.105, 0.045, 0.0);
const Eigen::Vector3d kLoad_N(20.0, -30.0, 514.0);

struct Errors {
  double base_speed_mps{0.0}, com_speed_mps{0.0}, position_m{0.0};
};

class TurningSoleTest : public testing::Test {
 protected:
  TurningSoleTest() {
    params_.contact_threshold_N = 25.0;
    params_.accelerometer_noise_mps2 = 1.0;  // of models/icub3/robot.yaml
    params_.foot_velocity_noise_mps = 0.02;
  }

  /// Takes `moving_`'s joints to where the left sole has `p_WF`, `R_WF` and turns with `w_WF` about
  /// its corner, the base at rest at home.
  void MoveLeg(const Eigen::Vector3d& p_WF, const Eigen::Matrix3d& R_WF,
               const Eigen::Vector3d& w_WF) {
    Eigen::VectorXd twist(6);
    for (int iteration = 0; iteration < 5; ++iteration) {  // Newton's: quadratic from 3 mm
      body_.Update(moving_);
      const FootKinematics& foot = body_.feet()[0];
      twist << p_WF - foot.p_WF, SmallTurn_W(foot.R_WF, R_WF);
      moving_.joint_position += JointsFor(twist);
    }
    body_.Update(moving_);
    twist << (R_WF * -kCorner_F).cross(-w_WF), w_WF;
    moving_.joint_velocity = JointsFor(twist);
  }

  /// Joint velocities (least norm) that give the left sole this twist, [linear; angular] in W.
  Eigen::VectorXd JointsFor(const Eigen::VectorXd& twist) {
    const FrameJacobian& jacobian = body_.foot_jacobian(0);
    Eigen::MatrixXd J(6, body_.num_actuators());
    for (int i = 0; i < body_.num_actuators(); ++i) {
      const int at = body_.actuated_velocity()[static_cast<std::size_t>(i)];
      J.col(i) << jacobian.J.col(at), jacobian.J_rot.col(at);
    }
    return J.completeOrthogonalDecomposition().solve(twist);
  }

  /// The IMU at rest; the ground presses the left sole with kLoad_N at `p_F` of it.
  SensorFrame FrameWith(const Eigen::Vector3d& p_F) {
    SensorFrame frame;
    frame.joint_position = moving_.joint_position;
    frame.joint_velocity = moving_.joint_velocity;
    body_.Update(moving_);
    frame.imu.q_WU = body_.imu().R_WU;
    frame.imu.accelerometer_mps2 = body_.imu().R_WU.transpose() * Eigen::Vector3d(0, 0, 9.81);
    frame.feet.resize(2);
    const FootKinematics& foot = body_.feet()[0];
    const Eigen::Vector3d p_W = foot.p_WF + foot.R_WF * p_F;
    const auto& sites = body_.PredictForceTorque(Eigen::VectorXd::Zero(body_.num_velocities()));
    for (std::size_t i = 0; i < sites.size(); ++i) {
      Wrench reading = sites[i].unloaded;
      if (robot_.force_torque[i] == robot_.feet[0].force_torque[0]) {
        const Eigen::Matrix3d R_SW = sites[i].R_WS.transpose();
        reading.force_N += R_SW * kLoad_N;
        reading.torque_Nm += R_SW * (p_W - sites[i].p_WS).cross(kLoad_N);
      }
      frame.force_torque.push_back(reading);
    }
    return frame;
  }

  /// Turns the sole about its corner and `axis`; it says that the ground presses at `felt_F`.
  Errors Turn(const Eigen::Vector3d& axis, const Eigen::Vector3d& felt_F, int ticks = kTicks) {
    LegOdometry odometry(robot_, params_, ExternalWrenchKnowledge::kUnknown, kTick_s,
                         odometry_body_);
    const FootState start = home_.feet[0];
    const Eigen::Vector3d p_W = start.p_WF + start.R_WF * kCorner_F;
    Errors errors;
    for (int tick = 0; tick <= ticks; ++tick) {
      const Eigen::Matrix3d turn =
          Eigen::AngleAxisd(kRate_radps * kTick_s * tick, axis).toRotationMatrix();
      const Eigen::Matrix3d R_WF = turn * start.R_WF;
      MoveLeg(p_W - R_WF * kCorner_F, R_WF, kRate_radps * axis);
      const SensorFrame frame = FrameWith(felt_F);
      body_.FillDerived(&moving_);  // its CoM hardly moves: that of the leg that does
      const RobotState& state = odometry.Update(frame, &odometry_body_);
      EXPECT_TRUE(state.feet[0].in_contact && !state.feet[1].in_contact) << tick;
      errors.base_speed_mps = std::max(errors.base_speed_mps, state.v_WB.norm());
      errors.com_speed_mps = std::max(errors.com_speed_mps, (state.v_WC - moving_.v_WC).norm());
      errors.position_m = std::max(errors.position_m, (state.p_WB - home_.p_WB).norm());
    }
    return errors;
  }

  const RobotDescription robot_{Icub3()};
  RigidBody body_{robot_};
  RigidBody odometry_body_{robot_};
  const RobotState home_{IcubAtHome(&body_)};
  RobotState moving_{home_};
  EstimatorParams params_;
};

// F goes round the corner with 0.6 rad/s * 0.114 m = 69 mm/s.
TEST_F(TurningSoleTest, SpinningOnItsCornerASoleMovesNeitherBaseNorCom) {
  const Errors errors = Turn(Eigen::Vector3d::UnitZ(), kCorner_F);
  // What is left: inertia of the foot's sensors, 3 mm/s^2 short of nothing, and Newton's residue.
  EXPECT_LT(errors.base_speed_mps, 1e-3);
  EXPECT_LT(errors.com_speed_mps, 1e-3);
  EXPECT_LT(errors.position_m, 5e-4);
}

TEST_F(TurningSoleTest, TippingOverItsCornerASoleMovesNeitherBaseNorCom) {
  const Errors errors = Turn(Eigen::Vector3d(-1.0, 1.0, 0.0).normalized(), kCorner_F);
  EXPECT_LT(errors.base_speed_mps, 1e-3);
  EXPECT_LT(errors.com_speed_mps, 1e-3);
  EXPECT_LT(errors.position_m, 5e-4);
}

TEST_F(TurningSoleTest, TakenToRestOnItsFrameTheSoleDragsTheBaseAlong) {
  const Errors errors = Turn(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero());
  EXPECT_GT(errors.base_speed_mps, 0.02) << "else the tests above show nothing";
  EXPECT_GT(errors.position_m, 0.01);
}

TEST_F(TurningSoleTest, SoleThatTurnsFastIsDoubtedAtFirst) {
  constexpr int kSoon = 8;  // ticks: in the long run an accelerometer can't gainsay a sole
  const auto dragged_mps = [&](double doubt_radps) {
    params_.foot_turn_doubt_radps = doubt_radps;
    return Turn(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(), kSoon).base_speed_mps;
  };
  EXPECT_LT(dragged_mps(0.2), 0.8 * dragged_mps(1e6));
}

}  // namespace
}  // namespace sidestep::turning_sole_test
