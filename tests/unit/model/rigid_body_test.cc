// SPDX-License-Identifier: BSD-3-Clause
// Against MuJoCo's own forward dynamics, central differences along motions, and numbers by hand.
#include "controller/model/rigid_body.h"

#include <gtest/gtest.h>

#include <numbers>
#include <utility>

#include "models/support/config_error.h"
#include "tests/support/crooked_robot.h"
#include "tests/support/reference_robot.h"

namespace sidestep::rigid_body_test {
namespace {

constexpr double kStep = 1e-5;
// Central differences: kStep^2 times a third derivative of at most 100 here, and 1e-16 / kStep of
// rounding on numbers of size 10.
constexpr double kDifferenceTolerance = 2e-8;
constexpr double kRounding = 1e-11;

RobotDescription Hopper() {
  return ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) /
                              "models/hopper/robot.yaml");
}

/// A tilted, moving state in the joints' ranges.
RobotState MovingState(const RigidBody& body) {
  RobotState state;
  state.p_WB = {0.3, -0.2, 1.1};
  state.q_WB = Eigen::Quaterniond(0.7, 0.3, -0.4, 0.5).normalized();
  state.v_WB = {0.4, -0.7, 0.2};
  state.w_WB_B = {1.1, -0.6, 0.9};
  const int joints = body.num_actuators();
  state.joint_position = Eigen::VectorXd::LinSpaced(joints, 0.1, 0.4);
  state.joint_velocity = Eigen::VectorXd::LinSpaced(joints, -1.5, 0.8);
  state.feet.resize(body.num_feet());
  return state;
}

class RigidBodyTest : public testing::TestWithParam<const char*> {
 protected:
  RigidBodyTest()
      : robot_(std::string(GetParam()) == "hopper" ? Hopper() : CrookedRobot(folder_)),
        body_(robot_),
        reference_(robot_),
        state_(MovingState(body_)) {
    body_.Update(state_);
  }

  /// d/dt of `quantity` along the velocity `nu`.
  template <typename Quantity>
  Eigen::VectorXd Derivative(const Eigen::VectorXd& nu, Quantity&& quantity) {
    body_.Update(reference_.Moved(state_, nu, kStep));
    const Eigen::VectorXd after = quantity();
    body_.Update(reference_.Moved(state_, nu, -kStep));
    const Eigen::VectorXd before = quantity();
    body_.Update(state_);
    return (after - before) / (2.0 * kStep);
  }

  RobotState Derived() {
    RobotState derived = state_;
    body_.FillDerived(&derived);
    return derived;
  }

  TempFolder folder_;
  RobotDescription robot_;
  RigidBody body_;
  ReferenceRobot reference_;
  RobotState state_;
};

INSTANTIATE_TEST_SUITE_P(Robots, RigidBodyTest, testing::Values("hopper", "crooked"),
                         [](const auto& test) { return std::string(test.param); });

TEST_P(RigidBodyTest, FootJacobianIsTheDerivativeOfTheFootsPosition) {
  for (std::size_t foot = 0; foot < robot_.feet.size(); ++foot) {
    for (int i = 0; i < body_.num_velocities(); ++i) {
      const Eigen::VectorXd nu = Eigen::VectorXd::Unit(body_.num_velocities(), i);
      const Eigen::VectorXd column = Derivative(nu, [&] { return body_.feet()[foot].p_WF; });
      EXPECT_LT((body_.foot_jacobian(foot).J.col(i) - column).norm(), kDifferenceTolerance) << i;
    }
  }
}

TEST_P(RigidBodyTest, FootVelocityIsTheJacobianTimesTheVelocity) {
  for (std::size_t i = 0; i < body_.num_feet(); ++i) {
    const FootKinematics& foot = body_.feet()[i];
    EXPECT_LT((foot.v_WF - body_.foot_jacobian(i).J * body_.velocity()).norm(), kRounding);
    EXPECT_LT((foot.w_WF - body_.foot_jacobian(i).J_rot * body_.velocity()).norm(), kRounding);
    EXPECT_GT(foot.v_WF.norm(), 0.1) << "a foot at rest proves nothing";
  }
}

TEST_P(RigidBodyTest, FootBiasIsTheFootsAccelerationAtConstantVelocities) {
  const Eigen::VectorXd nu = body_.velocity();
  for (std::size_t foot = 0; foot < robot_.feet.size(); ++foot) {
    const Eigen::VectorXd acceleration =
        Derivative(nu, [&] { return Eigen::VectorXd(body_.foot_jacobian(foot).J * nu); });
    EXPECT_LT((body_.foot_bias(foot).linear_mps2 - acceleration).norm(), kDifferenceTolerance);
    EXPECT_GT(acceleration.norm(), 0.1) << "no acceleration proves nothing";
  }
}

TEST_P(RigidBodyTest, ComJacobianIsTheDerivativeOfTheComsPosition) {
  for (int i = 0; i < body_.num_velocities(); ++i) {
    const Eigen::VectorXd nu = Eigen::VectorXd::Unit(body_.num_velocities(), i);
    const Eigen::VectorXd column = Derivative(nu, [&] { return Derived().p_WC; });
    EXPECT_LT((body_.com_jacobian().col(i) - column).norm(), kDifferenceTolerance) << i;
  }
  EXPECT_LT((Derived().v_WC - body_.com_jacobian() * body_.velocity()).norm(), kRounding);
}

TEST_P(RigidBodyTest, ComBiasIsTheComsAccelerationAtConstantVelocities) {
  const Eigen::VectorXd nu = body_.velocity();
  const Eigen::VectorXd acceleration =
      Derivative(nu, [&] { return Eigen::VectorXd(body_.com_jacobian() * nu); });
  EXPECT_LT((body_.com_bias_mps2() - acceleration).norm(), kDifferenceTolerance);
}

TEST_P(RigidBodyTest, TranslatedItIsWhatTheMovedStateMakesIt) {
  const Eigen::Vector3d p(5.0, -3.0, 2.0), v(-1.5, 0.8, 2.5);
  body_.Translate(p, v);
  const RobotState translated = Derived();

  state_.p_WB += p;
  state_.v_WB += v;
  RigidBody moved(robot_);
  moved.Update(state_);
  RobotState expected = state_;
  moved.FillDerived(&expected);
  EXPECT_LT((translated.p_WC - expected.p_WC).norm(), kRounding);
  EXPECT_LT((translated.v_WC - expected.v_WC).norm(), kRounding);
  EXPECT_LT((translated.angular_momentum - expected.angular_momentum).norm(), kRounding);
  EXPECT_LT((body_.imu().p_WU - moved.imu().p_WU).norm(), kRounding);
  EXPECT_LT((body_.imu().v_WU - moved.imu().v_WU).norm(), kRounding);
  EXPECT_LT((body_.velocity() - moved.velocity()).norm(), kRounding);
  EXPECT_LT((body_.mass_matrix() - moved.mass_matrix()).norm(), kRounding);
  EXPECT_LT((body_.bias() - moved.bias()).norm(), kRounding);
  EXPECT_LT((body_.com_bias_mps2() - moved.com_bias_mps2()).norm(), kRounding);
  for (std::size_t i = 0; i < robot_.feet.size(); ++i) {
    EXPECT_LT((translated.feet[i].p_WF - expected.feet[i].p_WF).norm(), kRounding);
    EXPECT_LT((translated.feet[i].v_WF - expected.feet[i].v_WF).norm(), kRounding);
    EXPECT_LT((body_.foot_jacobian(i).J - moved.foot_jacobian(i).J).norm(), kRounding);
    EXPECT_LT((body_.foot_jacobian(i).J_rot - moved.foot_jacobian(i).J_rot).norm(), kRounding);
    EXPECT_LT((body_.foot_bias(i).linear_mps2 - moved.foot_bias(i).linear_mps2).norm(), kRounding);
  }
}

TEST_P(RigidBodyTest, EquationOfMotionHoldsForMuJoCosOwnAcceleration) {
  reference_.Set(state_);
  const mjModel* model = reference_.model();
  mjData* data = reference_.data();
  const int nv = body_.num_velocities();
  Eigen::VectorXd torque_Nm(model->nu);
  Eigen::VectorXd generalised = Eigen::VectorXd::Zero(nv);
  for (int i = 0; i < model->nu; ++i) {
    torque_Nm[i] = data->ctrl[i] = 1.0 + i;
    generalised[body_.actuated_velocity()[static_cast<std::size_t>(i)]] += torque_Nm[i];
  }
  mj_kinematics(model, data);
  mj_comPos(model, data);
  const double no_torque[3] = {};
  for (std::size_t foot = 0; foot < robot_.feet.size(); ++foot) {
    const Eigen::Vector3d force_N(2.0, -3.0, 7.0 + static_cast<double>(foot));
    const int site = mj_name2id(model, mjOBJ_SITE, robot_.feet[foot].frame.c_str());
    mj_applyFT(model, data, force_N.data(), no_torque, data->site_xpos + 3 * site,
               model->site_bodyid[site], data->qfrc_applied);
    generalised += body_.foot_jacobian(foot).J.transpose() * force_N;
  }
  mj_forward(model, data);
  const Eigen::Map<const Eigen::VectorXd> qacc(data->qacc, nv);
  const Eigen::VectorXd residual = body_.mass_matrix() * qacc + body_.bias() - generalised;
  // qacc goes through MuJoCo's factorisation: rounding times the condition number of M.
  EXPECT_LT(residual.norm(), 1e-9);
}

TEST_P(RigidBodyTest, AngularMomentumIsTheBasesRowsMovedToTheCom) {
  const RobotState derived = Derived();
  const Eigen::Vector3d about_base_B = body_.mass_matrix().middleRows<3>(3) * body_.velocity();
  const Eigen::Vector3d moved = (derived.p_WC - state_.p_WB).cross(body_.mass_kg() * derived.v_WC);
  EXPECT_LT((derived.angular_momentum - (state_.q_WB * about_base_B - moved)).norm(), kRounding);
  EXPECT_GT(derived.angular_momentum.norm(), 1e-3);
}

TEST_P(RigidBodyTest, BaseInertiaGivesTheMomentumOfALockedRobotsSpin) {
  RobotState spinning = state_;
  spinning.v_WB.setZero();
  spinning.joint_velocity.setZero();
  body_.Update(spinning);
  RobotState derived = spinning;
  body_.FillDerived(&derived);
  const Eigen::Vector3d about_base =
      derived.angular_momentum +
      (derived.p_WC - spinning.p_WB).cross(body_.mass_kg() * derived.v_WC);
  EXPECT_LT((about_base - spinning.q_WB * (body_.base_inertia() * spinning.w_WB_B)).norm(),
            kRounding);
}

TEST_P(RigidBodyTest, GravityIsInTheBiasAndPullsTheWholeMassDown) {
  RobotState still = state_;
  still.v_WB.setZero();
  still.w_WB_B.setZero();
  still.joint_velocity.setZero();
  body_.Update(still);
  const Eigen::Vector3d holding_N(0.0, 0.0, 9.81 * body_.mass_kg());
  EXPECT_LT((body_.bias().head<3>() - holding_N).norm(), kRounding);
  EXPECT_LT(body_.com_bias_mps2().norm(), kRounding);
}

TEST_P(RigidBodyTest, JointsAndTorqueLimitsAreInTheOrderOfTheActuators) {
  const mjModel* model = reference_.model();
  for (int i = 0; i < model->nu; ++i) {
    const int joint = model->actuator_trnid[2 * i];
    EXPECT_EQ(body_.actuated_velocity()[static_cast<std::size_t>(i)], model->jnt_dofadr[joint]);
    EXPECT_EQ(body_.velocity()[model->jnt_dofadr[joint]], state_.joint_velocity[i]);
    EXPECT_EQ(body_.torque_limit_Nm()[i], model->actuator_ctrlrange[2 * i + 1]);
  }
}

TEST(RigidBodyHopperTest, HopperWeighsOneKilogram) {
  EXPECT_NEAR(RigidBody(Hopper()).mass_kg(), 1.0, kRounding);
}

TEST(RigidBodyHopperTest, HomePostureHasFootAndComWhereTheDescriptionSays) {
  const RobotDescription robot = Hopper();
  RigidBody body(robot);
  RobotState state;
  state.p_WB.z() = robot.base_height_m;
  state.joint_position.setZero(3);
  state.joint_position[2] = robot.home.at("leg");
  state.joint_velocity.setZero(3);
  state.feet.resize(1);
  body.Update(state);
  body.FillDerived(&state);
  EXPECT_NEAR(state.feet[0].p_WF.z(), robot.feet[0].sole_height_m, kRounding);
  // The description rounds to centimetres.
  EXPECT_NEAR(state.p_WC.z(), robot.com_height_m, 0.015);
}

// The base is rolled by 90 degrees about x: its z axis is -y of the world. The leg, folded forward
// by the hip's pitch of 90 degrees, points to -x of both.
TEST(RigidBodyHopperTest, AngularVelocityIsInTheBaseAndLinearVelocityInTheWorld) {
  RigidBody body(Hopper());
  RobotState state;
  state.q_WB = Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitX());
  state.joint_position = Eigen::Vector3d(0.0, 0.5 * std::numbers::pi, 0.15);
  state.joint_velocity.setZero(3);
  state.w_WB_B = {0.0, 0.0, 1.0};
  state.v_WB = {0.0, 0.0, 2.0};
  body.Update(state);
  EXPECT_LT((body.feet()[0].p_WF - Eigen::Vector3d(-0.5, 0.0, 0.0)).norm(), kRounding);
  // By hand: (0, 0, 2) + (0, -1, 0) x (-0.5, 0, 0) = (0, 0, 1.5).
  EXPECT_LT((body.feet()[0].v_WF - Eigen::Vector3d(0.0, 0.0, 1.5)).norm(), kRounding);
}

TEST(RigidBodyHopperTest, NamesThatTheMjcfLacksAreConfigErrors) {
  const auto error_of = [](auto&& spoil) -> std::string {
    RobotDescription robot = Hopper();
    spoil(robot);
    try {
      const RigidBody body(robot);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_EQ(error_of([](RobotDescription& robot) { robot.base = "torso"; }),
            "error: the robot's MJCF has no body called 'torso'");
  EXPECT_EQ(error_of([](RobotDescription& robot) { robot.imu = "gyroscope"; }),
            "error: the robot's MJCF has no site called 'gyroscope'");
  EXPECT_EQ(error_of([](RobotDescription& robot) { robot.feet[0].frame = "toe"; }),
            "error: the robot's MJCF has no site called 'toe'");
  EXPECT_EQ(error_of([](RobotDescription& robot) {
              robot.file = "toy/robot.yaml";
              robot.model.reset();
            }),
            "toy/robot.yaml: error: needs an mjcf or a urdf");
}

}  // namespace
}  // namespace sidestep::rigid_body_test
