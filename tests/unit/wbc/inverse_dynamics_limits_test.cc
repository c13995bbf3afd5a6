// SPDX-License-Identifier: BSD-3-Clause
// What no answer may break, whatever is asked: the iCub in random states, with demands that nobody
// can meet, against the definitions of its limits.
#include <gtest/gtest.h>

#include "controller/types/friction_pyramid.h"
#include "controller/wbc/inverse_dynamics.h"
#include "tests/support/icub3_stance.h"
#include "tests/support/random_dense_qp.h"

namespace sidestep::wbc::inverse_dynamics_limits_test {
namespace {

constexpr double kTolerance = 1e-6;  // of a solver that keeps rows to 1e-9 of their size

/// A stance in motion, and a QP of it that is solved once more for what only the solver knows.
class InverseDynamicsLimitsTest : public testing::Test {
 protected:
  void Draw(double wildness) {
    const RobotState home = IcubAtHome(&stance_.body);
    stance_.state = home;
    RobotState& state = stance_.state;
    state.q_WB = numbers_.Turn(0.2 * wildness) * home.q_WB;
    state.v_WB = numbers_.Vector3(wildness);
    state.w_WB_B = numbers_.Vector3(2.0 * wildness);
    for (Eigen::Index i = 0; i < state.joint_position.size(); ++i) {
      state.joint_position[i] += 0.3 * wildness * numbers_.Uniform(-1.0, 1.0);
      state.joint_velocity[i] = 5.0 * wildness * numbers_.Uniform(-1.0, 1.0);
    }
    stance_.body.Update(state);
    stance_.body.FillDerived(&state);
    stance_.com.p_WC = state.p_WC + numbers_.Vector3(0.3 * wildness);
    stance_.com.v_WC = state.v_WC + numbers_.Vector3(3.0 * wildness);
    stance_.com.a_WC = numbers_.Vector3(100.0 * wildness);
    stance_.com.angular_momentum_rate_Nm = numbers_.Vector3(1000.0 * wildness);
    state.external_wrench = {numbers_.Vector3(300.0 * wildness), numbers_.Vector3(50.0 * wildness)};
    const int swinging = numbers_.Integer(0, 3);  // or none, or both
    for (int i = 0; i < 2; ++i) {
      const auto at = static_cast<std::size_t>(i);
      FootTarget& foot = stance_.feet[at];
      foot.planned_contact = foot.supports = i != swinging && swinging != 3;
      state.feet[at].in_contact = numbers_.Uniform(0.0, 1.0) < 0.8;
      foot.p_WF = state.feet[at].p_WF + numbers_.Vector3(0.5 * wildness);
      foot.contact.R_WF = numbers_.Turn(wildness).toRotationMatrix();
      foot.vertex_force_N.setRandom();
      for (double& entry : foot.vertex_force_N.reshaped()) {
        entry = 500.0 * wildness * numbers_.Uniform(-1.0, 1.0);
      }
    }
  }

  SeededNumbers numbers_{11};
  IcubStance stance_;
  InverseDynamicsParams params_;
  InverseDynamics dynamics_{stance_.robot, params_, stance_.body};
  ActuatorCommand command_;
};

TEST_F(InverseDynamicsLimitsTest, EveryDemandIsAnsweredWithinConesTorquesAndBounds) {
  const int nv = stance_.body.num_velocities();
  const Eigen::Matrix<double, 4, 3> pyramid = FrictionPyramid(params_.friction);
  JointLimits limits(stance_.robot, stance_.body);
  DenseQpSolver solver({100, 10, 120});
  int at_torque_limit = 0, at_cone = 0, at_bound = 0;
  for (int draw = 0; draw < 300; ++draw) {
    Draw(draw % 3 == 0 ? 0.05 : 1.0);
    const RobotState& state = stance_.state;
    const WbcReport report =
        dynamics_.Solve(state, stance_.body, stance_.com, stance_.feet, &command_);
    ASSERT_TRUE(report.ok) << draw << ": " << static_cast<int>(report.status);
    const Eigen::ArrayXd limit_Nm = stance_.body.torque_limit_Nm();
    const double torque_ratio = (command_.torque_Nm.array().abs() / limit_Nm).maxCoeff();
    EXPECT_LT(torque_ratio, 1.0 + kTolerance) << draw;
    at_torque_limit += torque_ratio > 1.0 - kTolerance ? 1 : 0;

    const Eigen::VectorXd x = solver.Solve(dynamics_.problem()).x;
    limits.Update(state, stance_.body, OnBase(state.external_wrench, state));
    for (Eigen::Index i = 0; i < stance_.body.num_actuators(); ++i) {
      const double a = x[stance_.body.actuated_velocity()[static_cast<std::size_t>(i)]];
      const double room = kTolerance * (1.0 + std::abs(a));
      EXPECT_GT(a, limits.lower()[i] - room) << draw << ", " << i;
      EXPECT_LT(a, limits.upper()[i] + room) << draw << ", " << i;
      at_bound += a > limits.upper()[i] - room || a < limits.lower()[i] + room ? 1 : 0;
    }
    for (Eigen::Index first = nv; first < x.size(); first += 3) {
      const Eigen::Vector3d force_N = x.segment<3>(first);
      const double excess_N = (pyramid * force_N).maxCoeff();
      EXPECT_LT(excess_N, kTolerance * (1.0 + force_N.norm())) << draw;
      at_cone += excess_N > -1e-3 && force_N.z() > 1.0 ? 1 : 0;
    }
  }
  EXPECT_GT(at_torque_limit, 50) << "nothing was asked";
  EXPECT_GT(at_cone, 50);
  EXPECT_GT(at_bound, 50);
}

// The bounds hold the accelerations; with them the speeds never pass what they are made for.
TEST_F(InverseDynamicsLimitsTest, SwingThatIsTooFastForItsJointsStaysWithinTheirSpeeds) {
  constexpr double kDt_s = 0.002;
  stance_.PlanWeightEvenly();
  stance_.Lift(1);
  stance_.feet[1].p_WF += Eigen::Vector3d(0.4, 0.0, 0.1);  // at once
  double fastest = 0.0;
  for (int tick = 0; tick < 100; ++tick) {
    RobotState& state = stance_.state;
    ASSERT_TRUE(dynamics_.Solve(state, stance_.body, stance_.com, stance_.feet, &command_).ok);
    const Eigen::VectorXd x = DenseQpSolver({100, 10, 120}).Solve(dynamics_.problem()).x;
    for (Eigen::Index i = 0; i < state.joint_position.size(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      state.joint_velocity[i] += kDt_s * x[stance_.body.actuated_velocity()[at]];
      state.joint_position[i] += kDt_s * state.joint_velocity[i];
      fastest = std::max(fastest, std::abs(state.joint_velocity[i]) /
                                      stance_.robot.joints[at].velocity_limit_radps);
    }
    stance_.body.Update(state);
    stance_.body.FillDerived(&state);
  }
  EXPECT_LT(fastest, 0.95 + kTolerance);
  EXPECT_GT(fastest, 0.9) << "it was not in a hurry";
}

}  // namespace
}  // namespace sidestep::wbc::inverse_dynamics_limits_test
