// SPDX-License-Identifier: BSD-3-Clause
// A base that moves in a plane: against MuJoCo's own forward dynamics and central differences.
#include <gtest/gtest.h>

#include "controller/model/rigid_body.h"
#include "models/support/require.h"
#include "tests/support/planar_robot.h"
#include "tests/support/reference_robot.h"

namespace sidestep::planar_rigid_body_test {
namespace {

constexpr double kStep = 1e-5;
constexpr double kDifferenceTolerance = 2e-8;  // as of the robots that float freely
constexpr double kRounding = 1e-11;

RobotDescription Shipped(const std::string& name) {
  return ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models" / name /
                              "robot.yaml");
}

class PlanarRigidBodyTest : public testing::TestWithParam<const char*> {
 protected:
  PlanarRigidBodyTest()
      : robot_(std::string(GetParam()) == "planar" ? PlanarRobot(folder_) : Shipped(GetParam())),
        body_(robot_),
        model_(CompileMjcf("<mujoco><include file=\"robot.xml\"/></mujoco>",
                           robot_.model->simulated_mjcf, robot_.model->file)),
        data_(MakeData(*model_)) {
    state_.p_WB = {0.3, 0.0, 1.1};
    state_.q_WB = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitY());
    state_.v_WB = {0.4, 0.0, 0.2};
    state_.w_WB_B = {0.0, -0.6, 0.0};
    state_.joint_position = Eigen::VectorXd::LinSpaced(body_.num_actuators(), 0.1, 0.4);
    state_.joint_velocity = Eigen::VectorXd::LinSpaced(body_.num_actuators(), -1.5, 0.8);
    state_.feet.resize(body_.num_feet());
    body_.Update(state_);
  }

  /// `state_` moved along the velocity `nu` for `time_s`, by hand: [x, z, pitch; joints].
  RobotState Moved(const Eigen::VectorXd& nu, double time_s) const {
    RobotState moved = state_;
    moved.p_WB += time_s * Eigen::Vector3d(nu[0], 0.0, nu[1]);
    moved.q_WB = Eigen::AngleAxisd(time_s * nu[2], Eigen::Vector3d::UnitY()) * state_.q_WB;
    for (int i = 0; i < body_.num_actuators(); ++i) {
      moved.joint_position[i] +=
          time_s * nu[body_.actuated_velocity()[static_cast<std::size_t>(i)]];
    }
    return moved;
  }

  template <typename Quantity>
  Eigen::VectorXd Derivative(const Eigen::VectorXd& nu, Quantity&& quantity) {
    body_.Update(Moved(nu, kStep));
    const Eigen::VectorXd after = quantity();
    body_.Update(Moved(nu, -kStep));
    const Eigen::VectorXd before = quantity();
    body_.Update(state_);
    return (after - before) / (2.0 * kStep);
  }

  RobotState Derived() {
    RobotState derived = state_;
    body_.FillDerived(&derived);
    return derived;
  }

  /// MuJoCo at `state_`, its base's coordinates by hand from the body's reference.
  void SetReference() {
    const int base = RequireId(*model_, mjOBJ_BODY, robot_.base);
    data_->qpos[0] = 0.3 - model_->body_pos[3 * base];
    data_->qpos[1] = 1.1 - model_->body_pos[3 * base + 2];
    data_->qpos[2] = 0.4;
    mju_copy(data_->qvel, body_.velocity().data(), model_->nv);
    for (int i = 0; i < model_->nu; ++i) {
      data_->qpos[model_->jnt_qposadr[model_->actuator_trnid[2 * i]]] = state_.joint_position[i];
    }
    mj_kinematics(model_.get(), data_.get());
    mj_comPos(model_.get(), data_.get());
  }

  TempFolder folder_;
  RobotDescription robot_;
  RigidBody body_;
  MjModelPtr model_;
  MjDataPtr data_;
  RobotState state_;
};

INSTANTIATE_TEST_SUITE_P(Robots, PlanarRigidBodyTest, testing::Values("planar", "rabbit", "biped"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(PlanarRigidBodyTest, ThreeVelocitiesMoveTheBase) {
  EXPECT_EQ(body_.num_base_velocities(), 3);
  EXPECT_EQ(body_.num_velocities(), 3 + body_.num_actuators());
  EXPECT_EQ(body_.velocity().head<3>(), Eigen::Vector3d(0.4, 0.2, -0.6));
}

TEST_P(PlanarRigidBodyTest, JacobiansAreTheDerivativesOfFeetAndCom) {
  for (int i = 0; i < body_.num_velocities(); ++i) {
    const Eigen::VectorXd nu = Eigen::VectorXd::Unit(body_.num_velocities(), i);
    const Eigen::VectorXd com = Derivative(nu, [&] { return Derived().p_WC; });
    EXPECT_LT((body_.com_jacobian().col(i) - com).norm(), kDifferenceTolerance) << i;
    for (std::size_t foot = 0; foot < robot_.feet.size(); ++foot) {
      const Eigen::VectorXd moved = Derivative(nu, [&] { return body_.feet()[foot].p_WF; });
      EXPECT_LT((body_.foot_jacobian(foot).J.col(i) - moved).norm(), kDifferenceTolerance) << i;
    }
  }
  EXPECT_LT((Derived().v_WC - body_.com_jacobian() * body_.velocity()).norm(), kRounding);
}

TEST_P(PlanarRigidBodyTest, BiasesAreAccelerationsAtConstantVelocities) {
  const Eigen::VectorXd nu = body_.velocity();
  const Eigen::VectorXd com =
      Derivative(nu, [&] { return Eigen::VectorXd(body_.com_jacobian() * nu); });
  EXPECT_LT((body_.com_bias_mps2() - com).norm(), kDifferenceTolerance);
  for (std::size_t foot = 0; foot < robot_.feet.size(); ++foot) {
    const Eigen::VectorXd acceleration =
        Derivative(nu, [&] { return Eigen::VectorXd(body_.foot_jacobian(foot).J * nu); });
    EXPECT_LT((body_.foot_bias(foot).linear_mps2 - acceleration).norm(), kDifferenceTolerance);
    EXPECT_GT(acceleration.norm(), 0.1) << "no acceleration proves nothing";
  }
}

TEST_P(PlanarRigidBodyTest, EquationOfMotionHoldsForMuJoCosOwnAcceleration) {
  SetReference();
  const int nv = body_.num_velocities();
  Eigen::VectorXd generalised = Eigen::VectorXd::Zero(nv);
  for (int i = 0; i < model_->nu; ++i) {
    data_->ctrl[i] = 1.0 + 0.5 * i;  // within every motor's range
    generalised[body_.actuated_velocity()[static_cast<std::size_t>(i)]] += data_->ctrl[i];
  }
  const double no_torque[3] = {};
  for (std::size_t foot = 0; foot < robot_.feet.size(); ++foot) {
    const Eigen::Vector3d force_N(2.0, -3.0, 7.0 + static_cast<double>(foot));
    const int site = RequireId(*model_, mjOBJ_SITE, robot_.feet[foot].frame);
    mj_applyFT(model_.get(), data_.get(), force_N.data(), no_torque, data_->site_xpos + 3 * site,
               model_->site_bodyid[site], data_->qfrc_applied);
    generalised += body_.foot_jacobian(foot).J.transpose() * force_N;
  }
  mj_forward(model_.get(), data_.get());
  const Eigen::Map<const Eigen::VectorXd> qacc(data_->qacc, nv);
  const Eigen::VectorXd residual = body_.mass_matrix() * qacc + body_.bias() - generalised;
  EXPECT_LT(residual.norm(), 1e-9) << "rounding times the condition number of M";
}

TEST_P(PlanarRigidBodyTest, AngularMomentumIsTheJacobiansAndThePlanes) {
  const Eigen::Vector3d h = Derived().angular_momentum;
  EXPECT_LT((body_.angular_momentum_jacobian() * body_.velocity() - h).norm(), kRounding);
  EXPECT_EQ(h.x(), 0.0);
  EXPECT_EQ(h.z(), 0.0);
  EXPECT_GT(std::abs(h.y()), 1e-3);
  const Eigen::VectorXd nu = body_.velocity();
  const Eigen::VectorXd rate =
      Derivative(nu, [&] { return Eigen::VectorXd(body_.angular_momentum_jacobian() * nu); });
  EXPECT_LT((body_.angular_momentum_bias_Nm() - rate).norm(), kDifferenceTolerance);
}

TEST_P(PlanarRigidBodyTest, BaseInertiaIsAboutTheAxisThatTurns) {
  Eigen::Matrix3d expected = Eigen::Matrix3d::Zero();
  expected(1, 1) = body_.mass_matrix()(2, 2);
  EXPECT_EQ(body_.base_inertia(), expected);
}

TEST_P(PlanarRigidBodyTest, StatesBesideThePlaneCountAsThoseInIt) {
  RobotState beside = state_;
  beside.p_WB.y() = 0.2;
  beside.v_WB.y() = -0.3;
  beside.w_WB_B += Eigen::Vector3d(0.5, 0.0, 0.7);
  beside.external_wrench = {{1, 2, 3}, {4, 5, 6}};
  RigidBody other(robot_);
  other.Update(beside);
  EXPECT_EQ(other.velocity(), body_.velocity());
  EXPECT_EQ(other.feet()[0].p_WF, body_.feet()[0].p_WF);
  other.Project(&beside);
  EXPECT_EQ(beside.p_WB, state_.p_WB);
  EXPECT_EQ(beside.v_WB, state_.v_WB);
  EXPECT_EQ(beside.w_WB_B, state_.w_WB_B);
  EXPECT_EQ(beside.external_wrench.force_N, Eigen::Vector3d(1, 0, 3));
  EXPECT_EQ(beside.external_wrench.torque_Nm, Eigen::Vector3d(0, 5, 0));
}

TEST_P(PlanarRigidBodyTest, TranslatedItIsWhatTheMovedStateMakesIt) {
  const Eigen::Vector3d p(5.0, 0.0, 2.0), v(-1.5, 0.0, 2.5);
  body_.Translate(p, v);
  const RobotState translated = Derived();
  state_.p_WB += p;
  state_.v_WB += v;
  RigidBody moved(robot_);
  moved.Update(state_);
  EXPECT_LT((body_.velocity() - moved.velocity()).norm(), kRounding);
  EXPECT_LT((body_.bias() - moved.bias()).norm(), kRounding);
  EXPECT_LT((body_.feet()[1].p_WF - moved.feet()[1].p_WF).norm(), kRounding);
  moved.FillDerived(&state_);
  EXPECT_LT((translated.p_WC - state_.p_WC).norm(), kRounding);
  EXPECT_LT((translated.v_WC - state_.v_WC).norm(), kRounding);
  EXPECT_THROW(body_.Translate(Eigen::Vector3d::UnitY(), v), ContractViolation);
}

TEST_P(PlanarRigidBodyTest, HomeIsInThePlaneWithTheFeetAboutTheOrigin) {
  RobotState home = state_;
  body_.WriteHome(&home);
  body_.Update(home);
  const Eigen::Vector3d midpoint = 0.5 * (body_.feet()[0].p_WF + body_.feet()[1].p_WF);
  EXPECT_LT(midpoint.head<2>().norm(), kRounding);
  EXPECT_EQ(home.p_WB.y(), 0.0);
  EXPECT_EQ(home.p_WB.z(), robot_.base_height_m);
}

}  // namespace
}  // namespace sidestep::planar_rigid_body_test
