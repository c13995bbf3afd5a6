// SPDX-License-Identifier: BSD-3-Clause
// What force/torque sensors feel of their own distal part: its weight by hand, and its inertia by
// differences of its momentum.
#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "controller/model/rigid_body.h"
#include "tests/support/icub3.h"
#include "tests/support/reference_robot.h"

namespace sidestep::force_torque_test {
namespace {

const Eigen::Vector3d kGravity_mps2(0.0, 0.0, -9.81);
constexpr double kStep_s = 1e-5;

// By hand: an arm's sensor carries its own distal part, the upper arm and the lower arm; a foot's a
// plate. robot.yaml and icub3.urdf.
const std::map<std::string, double> kDistalMass_kg{{"l_arm_ft", 0.2625 + 1.6203 + 1.384293},
                                                   {"r_arm_ft", 0.2625 + 1.6219 + 1.380403},
                                                   {"l_foot_front_ft", 0.17896},
                                                   {"l_foot_rear_ft", 0.17851},
                                                   {"r_foot_front_ft", 0.17964},
                                                   {"r_foot_rear_ft", 0.17874}};

/// Linear momentum and the angular one about a fixed point, in W.
struct Momentum {
  Eigen::Vector3d linear{Eigen::Vector3d::Zero()};
  Eigen::Vector3d angular{Eigen::Vector3d::Zero()};
};

class ForceTorqueTest : public testing::TestWithParam<int> {
 protected:
  /// Calls add(body, mass, CoM in W) for every body that hangs on the site.
  template <typename Add>
  void ForDistal(const std::string& site, Add&& add) {
    const mjModel* model = reference_.model();
    const int root = model->site_bodyid[reference_.Site(site)];
    for (int body = root; body < model->nbody; ++body) {
      int ancestor = body;
      while (ancestor > root) ancestor = model->body_parentid[ancestor];
      if (ancestor != root) continue;
      const Eigen::Map<const Eigen::Vector3d> p_WC(reference_.data()->xipos + 3 * body);
      add(body, model->body_mass[body], p_WC);
    }
  }

  /// Of all that hangs on the site while the robot is at `state`, by Jacobians of its bodies.
  Momentum DistalMomentum(const RobotState& state, const std::string& site,
                          const Eigen::Vector3d& about_W) {
    using RowMajor = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor>;
    reference_.SetPoses(state);
    const mjModel* model = reference_.model();
    mjData* data = reference_.data();
    const Eigen::Map<const Eigen::VectorXd> nu(data->qvel, model->nv);
    Momentum sum;
    RowMajor J(3, model->nv), J_rot(3, model->nv);
    ForDistal(site, [&](int body, double mass_kg, const Eigen::Vector3d& p_WC) {
      mj_jacBodyCom(model, data, J.data(), J_rot.data(), body);
      const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> R_WI(data->ximat +
                                                                                9 * body);
      const Eigen::Map<const Eigen::Vector3d> inertia(model->body_inertia + 3 * body);
      const Eigen::Vector3d linear = mass_kg * (J * nu);
      sum.linear += linear;
      sum.angular += (p_WC - about_W).cross(linear) +
                     R_WI * (inertia.asDiagonal() * (R_WI.transpose() * (J_rot * nu)));
    });
    return sum;
  }

  /// Where `state` is after `time_s` of the constant acceleration `nudot`, to second order.
  RobotState After(const RobotState& state, const Eigen::VectorXd& nudot, double time_s) {
    const Eigen::VectorXd& nu = body_.velocity();
    RobotState after = reference_.Moved(state, nu + 0.5 * time_s * nudot, time_s);
    after.v_WB += time_s * nudot.head<3>();
    after.w_WB_B += time_s * nudot.segment<3>(3);
    for (int i = 0; i < body_.num_actuators(); ++i) {
      const int at = body_.actuated_velocity()[static_cast<std::size_t>(i)];
      after.joint_velocity[i] += time_s * nudot[at];
    }
    return after;
  }

  const RobotDescription robot_{Icub3()};
  RigidBody body_{robot_};
  ReferenceRobot reference_{robot_};
};

TEST_P(ForceTorqueTest, AtRestASensorFeelsTheWeightBelowIt) {
  RobotState state = MovingIcub(body_, GetParam());
  state.v_WB.setZero();
  state.w_WB_B.setZero();
  state.joint_velocity.setZero();
  body_.Update(state);
  const std::vector<ForceTorqueKinematics>& sites =
      body_.PredictForceTorque(Eigen::VectorXd::Zero(body_.num_velocities()));
  reference_.SetPoses(state);
  ASSERT_EQ(sites.size(), kDistalMass_kg.size());
  for (std::size_t i = 0; i < robot_.force_torque.size(); ++i) {
    const std::string& name = robot_.force_torque[i];
    const ForceTorqueKinematics& site = sites[i];
    EXPECT_LT((site.p_WS - reference_.Position(name)).norm(), 1e-12) << name;
    EXPECT_LT((site.R_WS - reference_.Rotation(name)).norm(), 1e-12) << name;
    const Eigen::Vector3d weight_N = kDistalMass_kg.at(name) * kGravity_mps2;
    // A URDF's masses survive being split and merged to 1e-9 kg.
    EXPECT_LT((site.R_WS * site.unloaded.force_N - weight_N).norm(), 1e-7) << name;
    Eigen::Vector3d torque_Nm = Eigen::Vector3d::Zero();
    ForDistal(name, [&](int, double mass_kg, const Eigen::Vector3d& p_WC) {
      torque_Nm += (p_WC - site.p_WS).cross(mass_kg * kGravity_mps2);
    });
    EXPECT_LT((site.R_WS * site.unloaded.torque_Nm - torque_Nm).norm(), 1e-9) << name;
  }
}

TEST_P(ForceTorqueTest, MovingItFeelsWeightLessTheRateOfTheMomentumBelowIt) {
  const RobotState state = MovingIcub(body_, GetParam());
  body_.Update(state);
  const int nv = body_.num_velocities();
  const Eigen::VectorXd nudot = 6.0 * Eigen::VectorXd::LinSpaced(nv, -1.0, 1.3).array().sin();
  const std::vector<ForceTorqueKinematics>& sites = body_.PredictForceTorque(nudot);
  const RobotState after = After(state, nudot, kStep_s);
  const RobotState before = After(state, nudot, -kStep_s);
  for (std::size_t i = 0; i < robot_.force_torque.size(); ++i) {
    const std::string& name = robot_.force_torque[i];
    const ForceTorqueKinematics& site = sites[i];
    const Momentum late = DistalMomentum(after, name, site.p_WS);
    const Momentum early = DistalMomentum(before, name, site.p_WS);
    reference_.SetPoses(state);
    // Newton and Euler: what the proximal part gives makes up what gravity does not explain.
    Eigen::Vector3d force_N = (early.linear - late.linear) / (2.0 * kStep_s);
    Eigen::Vector3d torque_Nm = (early.angular - late.angular) / (2.0 * kStep_s);
    ForDistal(name, [&](int, double mass_kg, const Eigen::Vector3d& p_WC) {
      force_N += mass_kg * kGravity_mps2;
      torque_Nm += (p_WC - site.p_WS).cross(mass_kg * kGravity_mps2);
    });
    // kStep_s^2 times derivatives of up to 10^4 here (3 rad/s and 6 rad/s^2 in series).
    EXPECT_LT((site.R_WS * site.unloaded.force_N - force_N).norm(), 1e-6) << name;
    EXPECT_LT((site.R_WS * site.unloaded.torque_Nm - torque_Nm).norm(), 1e-6) << name;
    EXPECT_GT((force_N - kDistalMass_kg.at(name) * kGravity_mps2).norm(), 0.1)
        << "no inertia proves nothing";
  }
}

TEST_P(ForceTorqueTest, PredictionLeavesTheRestOfTheModelAlone) {
  const RobotState state = MovingIcub(body_, GetParam());
  body_.Update(state);
  const Eigen::MatrixXd mass_matrix = body_.mass_matrix();
  const Eigen::VectorXd bias = body_.bias();
  const Eigen::Vector3d foot_bias_mps2 = body_.foot_bias(1).linear_mps2;
  body_.PredictForceTorque(Eigen::VectorXd::Constant(body_.num_velocities(), 50.0));
  EXPECT_EQ(body_.mass_matrix(), mass_matrix);
  EXPECT_EQ(body_.bias(), bias);
  body_.Update(state);
  EXPECT_EQ(body_.bias(), bias);
  EXPECT_EQ(body_.foot_bias(1).linear_mps2, foot_bias_mps2);
}

INSTANTIATE_TEST_SUITE_P(Variants, ForceTorqueTest, testing::Range(0, 2));

}  // namespace
}  // namespace sidestep::force_torque_test
