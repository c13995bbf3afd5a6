// SPDX-License-Identifier: BSD-3-Clause
// Whole-body control of a base that moves in a plane: its torques carried out by MuJoCo's forward
// dynamics in flight, and with both feet pinned where they stand.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "controller/model/upright.h"
#include "controller/wbc/inverse_dynamics.h"
#include "controller/wbc/inverse_kinematics.h"
#include "models/robot_description/sagittal_plane.h"
#include "tests/support/planar_robot.h"

namespace sidestep::wbc::planar_whole_body_test {
namespace {

RobotDescription Rabbit() {
  return InItsPlane(ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) /
                                         "models/rabbit/robot.yaml"));
}

class PlanarWholeBodyTest : public testing::Test {
 protected:
  PlanarWholeBodyTest() : robot_(Rabbit()), body_(robot_) {
    body_.WriteHome(&state_);
    state_.feet.resize(2);
    Refresh();
    com_ = {state_.p_WC, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    feet_.assign(2, {});
    for (std::size_t i = 0; i < 2; ++i) {
      state_.feet[i].in_contact = true;
      feet_[i].planned_contact = feet_[i].supports = true;
      feet_[i].p_WF = state_.feet[i].p_WF;
      feet_[i].vertex_force_N = Eigen::Vector3d(0.0, 0.0, 0.5 * 9.81 * body_.mass_kg());
    }
  }

  void Refresh() {
    body_.Update(state_);
    body_.FillDerived(&state_);
  }

  bool Solve() {
    InverseDynamics dynamics(robot_, params_, body_);
    return dynamics.Solve(state_, body_, com_, feet_, &command_).ok;
  }

  Eigen::VectorXd GeneralisedTorque() const {
    Eigen::VectorXd generalised = Eigen::VectorXd::Zero(body_.num_velocities());
    for (std::size_t i = 0; i < 4; ++i) {
      generalised[body_.actuated_velocity()[i]] = command_.torque_Nm[static_cast<Eigen::Index>(i)];
    }
    return generalised;
  }

  /// [nudot; ground's forces on the left and the right foot, x and z each] with both feet pinned.
  Eigen::VectorXd CarryOut() const {
    const Eigen::Index nv = body_.num_velocities();
    Eigen::MatrixXd J(4, nv);
    Eigen::Vector4d bias;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto row = 2 * static_cast<Eigen::Index>(i);
      J.row(row) = body_.foot_jacobian(i).J.row(0);
      J.row(row + 1) = body_.foot_jacobian(i).J.row(2);
      bias[row] = body_.foot_bias(i).linear_mps2.x();
      bias[row + 1] = body_.foot_bias(i).linear_mps2.z();
    }
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(nv + 4, nv + 4);
    system.topLeftCorner(nv, nv) = body_.mass_matrix();
    system.topRightCorner(nv, 4) = -J.transpose();
    system.bottomLeftCorner(4, nv) = J;
    Eigen::VectorXd right(nv + 4);
    right << GeneralisedTorque() - body_.bias(), -bias;
    return system.fullPivLu().solve(right);
  }

  RobotDescription robot_;
  RigidBody body_;
  InverseDynamicsParams params_;
  RobotState state_;
  ComTarget com_;
  std::vector<FootTarget> feet_;
  ActuatorCommand command_;
};

TEST_F(PlanarWholeBodyTest, StandingFeetApartItsWeightHoldsItStill) {
  ASSERT_TRUE(Solve());
  const Eigen::VectorXd solution = CarryOut();
  EXPECT_LT(solution.head(7).norm(), 1e-2) << "home has the CoM over the middle to a micrometre";
  EXPECT_NEAR(solution[8] + solution[10], 9.81 * 40.0, 0.1);
}

TEST_F(PlanarWholeBodyTest, ComAcceleratesAsAsked) {
  com_.a_WC = {0.2, 0.0, 0.5};
  params_.planned_force_weight = 1e-6;
  params_.attitude_weight = params_.posture_weight = params_.leg_posture_weight = 0.0;
  params_.angular_momentum_weight = 0.0;
  ASSERT_TRUE(Solve());
  const Eigen::VectorXd nudot = CarryOut().head(7);
  const Eigen::Vector3d a_WC = body_.com_jacobian() * nudot + body_.com_bias_mps2();
  EXPECT_LT((a_WC - com_.a_WC).norm(), 0.01);
}

// Legs without a task leave the base's pitch to the attitude task: what it asks for, MuJoCo shows.
TEST_F(PlanarWholeBodyTest, InFlightTheBaseTurnsAsItsAttitudeTaskAsks) {
  state_.p_WB.z() = 2.0;
  state_.q_WB = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY());
  state_.w_WB_B.y() = 0.3;
  for (std::size_t i = 0; i < 2; ++i) {
    state_.feet[i].in_contact = feet_[i].planned_contact = feet_[i].supports = false;
  }
  Refresh();
  params_.swing_weight = 0.0;
  params_.attitude_weight = 1e6;
  params_.posture_weight = params_.leg_posture_weight = 1e-8;
  ASSERT_TRUE(Solve());
  const MjModelPtr model = CompileMjcf("<mujoco><include file=\"robot.xml\"/></mujoco>",
                                       robot_.model->simulated_mjcf, robot_.model->file);
  const MjDataPtr data = MakeData(*model);
  data->qpos[1] = 2.0;
  data->qpos[2] = 0.1;
  data->qvel[2] = 0.3;
  for (int i = 0; i < 4; ++i) {
    data->qpos[3 + i] = state_.joint_position[i];
    data->ctrl[i] = command_.torque_Nm[i];
  }
  mj_forward(model.get(), data.get());
  // By hand: 40 (-0.1) - 10 0.3 = -7 rad/s^2.
  EXPECT_NEAR(data->qacc[2], -7.0, 1e-3);
  const Eigen::VectorXd nudot = body_.mass_matrix().lu().solve(GeneralisedTorque() - body_.bias());
  EXPECT_LT((nudot - Eigen::Map<const Eigen::VectorXd>(data->qacc, 7)).norm(), 1e-9 * nudot.norm());
}

// Of a robot with servos: exact tasks have no rows out of the plane, which nothing could meet.
TEST_F(PlanarWholeBodyTest, InverseKinematicsMovesTheComWithBothFeetDown) {
  for (const char* joint : {"left_hip", "left_knee", "right_hip", "right_knee"}) {
    robot_.joints.push_back({joint, 100.0, 1.0, 5.0, 1.0});
  }
  params_ = {};
  constexpr double kPeriod_s = 0.01;
  InverseKinematics kinematics(robot_, InverseKinematicsParams{}, kPeriod_s);
  com_.v_WC = {0.0, 0.0, -0.05};
  for (FootTarget& foot : feet_) foot.contact.R_WF = state_.feet[0].R_WF;
  feet_[1].contact.R_WF = state_.feet[1].R_WF;
  const WbcReport report = kinematics.Solve(state_, body_, com_, feet_, &command_);
  EXPECT_NE(report.status, QpStatus::kNotSolved);
  ASSERT_EQ(command_.joint_velocity.size(), 4);
  EXPECT_TRUE(command_.joint_velocity.allFinite());
}

}  // namespace
}  // namespace sidestep::wbc::planar_whole_body_test
