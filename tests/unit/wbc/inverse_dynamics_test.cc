// SPDX-License-Identifier: BSD-3-Clause
// The torques are carried out by models of their own: MuJoCo's forward dynamics in flight; on the
// ground a foot that is pinned where it stands, or MuJoCo's contact.
#include "controller/wbc/inverse_dynamics.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <limits>

#include "models/mjcf/quaternion.h"

namespace sidestep::wbc::inverse_dynamics_test {
namespace {

constexpr double kGravity_mps2 = 9.81;
constexpr double kWeight_N = 9.81;  // of 1 kg

RobotDescription Hopper() {
  return ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) /
                              "models/hopper/robot.yaml");
}

/// A stiff trunk owns the angular momentum, as the hopper's robot.yaml has it.
InverseDynamicsParams StiffTrunk() {
  InverseDynamicsParams params;
  params.com_stiffness_per_s2 = 100.0;
  params.com_damping_per_s = 20.0;
  params.com_weight = 1.0;
  params.angular_momentum_weight = 0.0;
  params.attitude_stiffness_per_s2 = 200.0;
  params.attitude_damping_per_s = 30.0;
  params.attitude_weight = 0.1;
  params.swing_weight = 1.0;
  params.stand_weight = 10.0;
  params.posture_stiffness_per_s2 = 0.0;
  params.posture_damping_per_s = 0.0;
  params.leg_posture_weight = 1e-4;
  params.planned_force_weight = 0.1;
  return params;
}

/// What the robot does under a command while its foot is pinned.
struct Pinned {
  Eigen::VectorXd nudot;
  Eigen::Vector3d force_N;  ///< Ground on foot.
  Eigen::Vector3d a_WC;
};

class InverseDynamicsTest : public testing::Test {
 protected:
  InverseDynamicsTest() : robot_(Hopper()), body_(robot_) {
    state_.p_WB.z() = robot_.base_height_m;
    state_.joint_position = Eigen::Vector3d(0.0, 0.0, robot_.home.at("leg"));
    state_.joint_velocity.setZero(3);
    state_.feet.resize(1);
    state_.feet[0].in_contact = true;
    Refresh();
    Stand();
  }

  /// To be called after a change of state.
  void Refresh() {
    body_.Update(state_);
    body_.FillDerived(&state_);
  }

  /// Targets that ask the robot to stay as it is, its weight on the foot.
  void Stand() {
    com_ = {state_.p_WC, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    feet_.assign(1, {});
    feet_[0].planned_contact = feet_[0].supports = true;
    feet_[0].p_WF = state_.feet[0].p_WF;
    feet_[0].vertex_force_N = Eigen::Vector3d(0.0, 0.0, kWeight_N);
  }

  /// Targets of a foot in the air that stays where it is.
  void Fly() {
    state_.feet[0].in_contact = false;
    feet_[0].planned_contact = feet_[0].supports = false;
    feet_[0].p_WF = state_.feet[0].p_WF;
    feet_[0].v_WF = state_.feet[0].v_WF;
    feet_[0].vertex_force_N.setZero();
  }

  WbcReport Solve() {
    InverseDynamics dynamics(robot_, params_, body_);
    return dynamics.Solve(state_, body_, com_, feet_, &command_);
  }

  /// Solves M nudot + h = S^T tau + J^T f with J nudot + Jdot nu = 0.
  Pinned CarryOut() const {
    const Eigen::Index nv = body_.num_velocities();
    const Jacobian3& J = body_.foot_jacobian(0).J;
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(nv + 3, nv + 3);
    system.topLeftCorner(nv, nv) = body_.mass_matrix();
    system.topRightCorner(nv, 3) = -J.transpose();
    system.bottomLeftCorner(3, nv) = J;
    Eigen::VectorXd right(nv + 3);
    right << -body_.bias(), -body_.foot_bias(0).linear_mps2;
    for (std::size_t i = 0; i < 3; ++i) {
      right[body_.actuated_velocity()[i]] += command_.torque_Nm[static_cast<Eigen::Index>(i)];
    }
    const Eigen::VectorXd solution = system.fullPivLu().solve(right);
    const Eigen::VectorXd nudot = solution.head(nv);
    return {nudot, solution.tail<3>(), body_.com_jacobian() * nudot + body_.com_bias_mps2()};
  }

  /// Accelerations of MuJoCo's forward dynamics without ground.
  Eigen::VectorXd CarryOutInFlight() const {
    const MjModelPtr model = CompileMjcf("<mujoco><include file=\"robot.xml\"/></mujoco>",
                                         robot_.model->simulated_mjcf, robot_.model->file);
    const MjDataPtr data = MakeData(*model);
    Eigen::Map<Eigen::Vector3d>(data->qpos) = state_.p_WB;
    ToMuJoCo(state_.q_WB, data->qpos + 3);
    Eigen::Map<Eigen::Vector3d>(data->qpos + 7) = state_.joint_position;
    Eigen::Map<Eigen::Vector3d>(data->qvel) = state_.v_WB;
    Eigen::Map<Eigen::Vector3d>(data->qvel + 3) = state_.w_WB_B;
    Eigen::Map<Eigen::Vector3d>(data->qvel + 6) = state_.joint_velocity;
    Eigen::Map<Eigen::Vector3d>(data->ctrl) = command_.torque_Nm;
    mj_forward(model.get(), data.get());
    return Eigen::Map<const Eigen::VectorXd>(data->qacc, model->nv);
  }

  RobotDescription robot_;
  RigidBody body_;
  InverseDynamicsParams params_{StiffTrunk()};
  RobotState state_;
  ComTarget com_;
  std::vector<FootTarget> feet_;
  ActuatorCommand command_;
};

TEST_F(InverseDynamicsTest, StandingHopperIsHeldStillByItsWeight) {
  EXPECT_TRUE(Solve().ok);
  const Pinned pinned = CarryOut();
  // The QP's own tolerance of 1e-9 or so, times a condition number of the mass matrix.
  EXPECT_LT((pinned.force_N - Eigen::Vector3d(0.0, 0.0, kWeight_N)).norm(), 1e-5);
  EXPECT_LT(pinned.nudot.norm(), 1e-4);
}

TEST_F(InverseDynamicsTest, ComIsAcceleratedTowardsItsTarget) {
  com_.p_WC.z() += 0.01;
  com_.v_WC.z() = 0.05;
  com_.a_WC.z() = 0.5;
  feet_[0].vertex_force_N(2, 0) += 2.5;  // what that takes, so that the force task agrees
  EXPECT_TRUE(Solve().ok);
  // By hand: 0.5 + 100 * 0.01 + 20 * 0.05 = 2.5.
  EXPECT_NEAR(CarryOut().a_WC.z(), 2.5, 1e-3);
}

TEST_F(InverseDynamicsTest, PlannedForceGivesWayToTheComTask) {
  feet_[0].vertex_force_N.setZero();
  EXPECT_TRUE(Solve().ok);
  // The force weighs 0.1 a (mg)^2, which is 1e-3 a N^2, and the CoM 1 a (m/s^2)^2: of 1 kg, the
  // force loses but 0.1 %.
  EXPECT_NEAR(CarryOut().force_N.z(), kWeight_N, 2e-3 * kWeight_N);
}

TEST_F(InverseDynamicsTest, LeaningBaseIsTurnedBack) {
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    for (const double lean_rad : {0.15, -0.15}) {
      state_.q_WB = Eigen::AngleAxisd(lean_rad, Eigen::Vector3d::Unit(axis));
      state_.joint_position[axis] = -lean_rad;  // the leg stays upright
      Refresh();
      Stand();
      EXPECT_TRUE(Solve().ok);
      EXPECT_LT(CarryOut().nudot[3 + axis] * lean_rad, -0.1) << axis << ", " << lean_rad;
      state_.joint_position[axis] = 0.0;
    }
  }
}

TEST_F(InverseDynamicsTest, TurningBaseIsSlowedDown) {
  state_.w_WB_B = {0.0, 0.5, 0.0};
  state_.joint_velocity[1] = -0.5;
  Refresh();
  Stand();
  EXPECT_TRUE(Solve().ok);
  EXPECT_LT(CarryOut().nudot[4], -0.1);
}

// Neither of the base nor of a site of the torso: the leg must not be swung for it.
TEST_F(InverseDynamicsTest, OnAPointNoTaskTurnsTheTrunkAboutTheVertical) {
  const auto torques_Nm = [&](const std::string& torso, double yaw_rate_radps) -> Eigen::VectorXd {
    RobotDescription robot = robot_;
    robot.torso = torso;
    RigidBody body(robot);
    RobotState state = state_;
    state.joint_position.head<2>() << 0.3, 0.2;  // the leg has a way about the vertical
    state.w_WB_B = {0.0, 0.0, yaw_rate_radps};
    body.Update(state);
    body.FillDerived(&state);
    InverseDynamics control(robot, StiffTrunk(), body);
    std::vector<FootTarget> feet = feet_;
    feet[0].p_WF = state.feet[0].p_WF;
    const ComTarget com{state.p_WC, state.v_WC, Eigen::Vector3d::Zero()};
    ActuatorCommand command;
    EXPECT_TRUE(control.Solve(state, body, com, feet, &command).ok);
    return command.torque_Nm;
  };
  for (const double yaw_rate_radps : {0.0, 0.3}) {
    EXPECT_LT((torques_Nm("", yaw_rate_radps) - torques_Nm("imu", yaw_rate_radps)).norm(), 1e-5)
        << yaw_rate_radps;
  }
}

TEST_F(InverseDynamicsTest, AskedForTooMuchTorquesStayWithinTheirLimits) {
  for (const Eigen::Vector3d& a_WC :
       {Eigen::Vector3d(0.0, 0.0, 1e4), Eigen::Vector3d(1e4, -1e4, 1e3)}) {
    com_.a_WC = a_WC;
    EXPECT_TRUE(Solve().ok);
    const Eigen::ArrayXd excess_Nm = command_.torque_Nm.cwiseAbs() - body_.torque_limit_Nm();
    EXPECT_LT(excess_Nm.maxCoeff(), 1e-6);
    EXPECT_GT(excess_Nm.maxCoeff(), -1e-6) << "asked for that much, a limit is reached";
  }
}

TEST_F(InverseDynamicsTest, AskedForTooMuchForceStaysInTheFrictionPyramid) {
  // Such a force turns the base, whose attitude would otherwise be the bound.
  params_.attitude_weight = 0.0;
  for (const double angle_rad : {0.0, 0.8, 2.0, -2.5}) {
    com_.a_WC = Eigen::Vector3d(50.0 * std::cos(angle_rad), 50.0 * std::sin(angle_rad), 0.0);
    EXPECT_TRUE(Solve().ok);
    const Eigen::Vector3d force_N = CarryOut().force_N;
    const double slope = (std::abs(force_N.x()) + std::abs(force_N.y())) / force_N.z();
    EXPECT_GT(force_N.z(), 0.0);
    // A soft task holds the foot, so the pinned foot's force differs a little from the solver's.
    EXPECT_LT(slope, 1.05 * params_.friction) << angle_rad;
    EXPECT_GT(slope, 0.8 * params_.friction) << "the pyramid was no bound";
    EXPECT_GT(force_N.head<2>().dot(com_.a_WC.head<2>()), 0.0);
  }
}

TEST_F(InverseDynamicsTest, FootInFlightGetsTheAccelerationAskedFor) {
  params_.attitude_weight = 0.0;  // nothing competes: three joints, three accelerations
  params_.leg_posture_weight = 1e-8;
  state_.q_WB = Eigen::Quaterniond(0.98, 0.1, -0.15, 0.05).normalized();
  state_.joint_position = Eigen::Vector3d(0.2, -0.3, 0.2);
  state_.joint_velocity = Eigen::Vector3d(0.5, 1.0, -0.4);
  state_.w_WB_B = {0.3, -0.4, 0.6};
  state_.v_WB = {0.2, 0.1, -0.5};
  Refresh();
  Fly();
  feet_[0].a_WF = {3.0, -2.0, 4.0};
  feet_[0].p_WF += Eigen::Vector3d(0.001, 0.0, -0.002);
  feet_[0].v_WF += Eigen::Vector3d(0.0, 0.05, 0.0);
  EXPECT_TRUE(Solve().ok);
  // By hand, with gains 900 and 60: (3 + 0.9, -2 + 3, 4 - 1.8).
  const Eigen::Vector3d a_WF =
      body_.foot_jacobian(0).J * CarryOutInFlight() + body_.foot_bias(0).linear_mps2;
  // The base's weight of 1e-4 takes its share of accelerations of some m/s^2.
  EXPECT_LT((a_WF - Eigen::Vector3d(3.9, 1.0, 2.2)).norm(), 2e-3);
}

TEST_F(InverseDynamicsTest, InFlightTheComFallsWhateverIsAsked) {
  Fly();
  com_.a_WC.setConstant(50.0);
  EXPECT_TRUE(Solve().ok);
  const Eigen::Vector3d a_WC = body_.com_jacobian() * CarryOutInFlight() + body_.com_bias_mps2();
  EXPECT_LT((a_WC - Eigen::Vector3d(0.0, 0.0, -kGravity_mps2)).norm(), 1e-9);
  const ActuatorCommand asked = command_;
  com_.a_WC.setZero();
  Solve();
  EXPECT_LT((asked.torque_Nm - command_.torque_Nm).norm(), 1e-9) << "nothing moves the CoM";
}

TEST_F(InverseDynamicsTest, FootThatTheSensorDoesNotFeelCarriesNoForce) {
  state_.feet[0].in_contact = false;  // meant to stand, but in the air
  EXPECT_TRUE(Solve().ok);
  EXPECT_LT(command_.torque_Nm[2], 1.0) << "the leg does not push 9.8 N into the air";
}

TEST_F(InverseDynamicsTest, FailedSolveIsToldAndKeepsThePreviousCommand) {
  InverseDynamics dynamics(robot_, params_, body_);
  EXPECT_TRUE(dynamics.Solve(state_, body_, com_, feet_, &command_).ok);
  const Eigen::VectorXd before = command_.torque_Nm;
  com_.a_WC.x() = std::numeric_limits<double>::quiet_NaN();
  const WbcReport report = dynamics.Solve(state_, body_, com_, feet_, &command_);
  EXPECT_FALSE(report.ok);
  EXPECT_EQ(report.status, QpStatus::kNumericalError);
  EXPECT_EQ(command_.torque_Nm, before);
  com_.a_WC.x() = 0.0;
  EXPECT_TRUE(dynamics.Solve(state_, body_, com_, feet_, &command_).ok) << "it recovers";
}

TEST_F(InverseDynamicsTest, FailedFirstSolveCommandsZeroTorque) {
  com_.a_WC.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(Solve().ok);
  EXPECT_EQ(command_.torque_Nm, Eigen::VectorXd::Zero(3));
}

}  // namespace
}  // namespace sidestep::wbc::inverse_dynamics_test
