// SPDX-License-Identifier: BSD-3-Clause
#include "controller/make_stages.h"

#include <gtest/gtest.h>

#include "controller/estimator/leg_odometry.h"
#include "controller/estimator/truth_estimator.h"
#include "controller/wbc/inverse_dynamics.h"
#include "controller/wbc/inverse_kinematics.h"
#include "models/support/require.h"
#include "tests/support/icub3.h"

namespace sidestep::make_stages_test {
namespace {

class MakeStagesTest : public testing::Test {
 protected:
  MakeStagesTest() { setup_.robot = ReadRobotDescription(FindRobot("hopper", "")); }

  template <typename Kind>
  bool Estimates() const {
    return dynamic_cast<Kind*>(MakeEstimator(setup_, RigidBody(setup_.robot)).get()) != nullptr;
  }

  template <typename Kind>
  bool Controls(const RigidBody& body) const {
    return dynamic_cast<Kind*>(MakeWholeBody(setup_, body).get()) != nullptr;
  }

  /// The hopper at home as its sensors read, pressed to the ground by `touch_N`.
  SensorFrame AtHome(double touch_N) const {
    RobotState home;
    RigidBody(setup_.robot).WriteHome(&home);
    SensorFrame frame;
    frame.imu.accelerometer_mps2 = {0.0, 0.0, kGravity_mps2};
    frame.joint_position = home.joint_position;
    frame.joint_velocity = home.joint_velocity;
    frame.feet = {{touch_N}};
    frame.truth =
        TruthSample{{1.0, 2.0, 3.0}, home.q_WB, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    return frame;
  }

  ControllerSetup setup_;
};

TEST_F(MakeStagesTest, TheEstimatorIsTheOneOfTheSetting) {
  setup_.control.estimator = EstimatorKind::kSensors;
  EXPECT_TRUE(Estimates<LegOdometry>());
  EXPECT_FALSE(Estimates<TruthEstimator>());
  setup_.control.estimator = EstimatorKind::kTruth;
  EXPECT_TRUE(Estimates<TruthEstimator>());
  EXPECT_FALSE(Estimates<LegOdometry>());
}

TEST_F(MakeStagesTest, OnSensorsTheTruthIsNotLookedAtAndOnTruthItIsNeeded) {
  RigidBody body(setup_.robot);
  SensorFrame frame = AtHome(9.81);
  setup_.control.estimator = EstimatorKind::kTruth;
  const auto told = MakeEstimator(setup_, body);
  EXPECT_EQ(told->Update(frame, &body).p_WB, Eigen::Vector3d(1.0, 2.0, 3.0));
  setup_.control.estimator = EstimatorKind::kSensors;
  const auto feels = MakeEstimator(setup_, body), blind = MakeEstimator(setup_, body);
  const Eigen::Vector3d felt = feels->Update(frame, &body).p_WB;
  EXPECT_LT(felt.norm(), 0.6) << "at home";
  frame.truth.reset();
  EXPECT_EQ(blind->Update(frame, &body).p_WB, felt);
  EXPECT_THROW(told->Update(frame, &body), ContractViolation);
}

TEST_F(MakeStagesTest, TheEstimatorTakesTheSettingsOfTheSetup) {
  for (const double threshold_N : {5.0, 20.0}) {
    setup_.control.estimation.contact_threshold_N = threshold_N;
    RigidBody body(setup_.robot);
    const auto estimator = MakeEstimator(setup_, body);
    EXPECT_EQ(estimator->Update(AtHome(9.81), &body).feet[0].in_contact, threshold_N < 9.81);
  }
}

TEST_F(MakeStagesTest, TorqueIsInverseDynamicsAndPositionInverseKinematics) {
  setup_.control.mode = ControlMode::kTorque;
  const RigidBody hopper(setup_.robot);
  EXPECT_TRUE(Controls<wbc::InverseDynamics>(hopper));
  EXPECT_FALSE(Controls<wbc::InverseKinematics>(hopper));
  setup_.robot = Icub3();
  setup_.control.mode = ControlMode::kPosition;
  const RigidBody icub(setup_.robot);
  EXPECT_TRUE(Controls<wbc::InverseKinematics>(icub));
  EXPECT_FALSE(Controls<wbc::InverseDynamics>(icub));
}

TEST(PlannedRobotTest, HasTheFeetOfTheRobotInTheirOrder) {
  RobotDescription robot = Icub3();
  robot.feet[1].force_shares = Eigen::Vector4d(0.1, 0.2, 0.3, 0.4);
  const mpc::RobotModel model = PlannedRobot(robot, 55.5);
  EXPECT_EQ(model.foot_names, (std::vector<std::string>{"left", "right"}));
  ASSERT_EQ(model.vertices_m.size(), 2U);
  ASSERT_EQ(model.force_shares.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(model.vertices_m[i], robot.feet[i].vertices_m);
    EXPECT_EQ(model.force_shares[i], robot.feet[i].force_shares);
  }
  EXPECT_NE(robot.feet[0].vertices_m, robot.feet[1].vertices_m) << "else order shows nothing";
}

TEST(PlannedRobotTest, LegsOfABodyReachFromAnkleToHipAtHome) {
  const RobotDescription robot = Icub3();
  const RigidBody body(robot);
  const mpc::RobotModel model = PlannedRobot(robot, body);
  EXPECT_EQ(model.mass_kg, body.mass_kg());
  ASSERT_EQ(model.legs.size(), 2U);
  RobotState home;
  home.feet.resize(2);
  body.FillDerived(&home);
  for (std::size_t i = 0; i < 2; ++i) {
    const Eigen::Vector3d r =
        home.p_WC - home.feet[i].p_WF + home.feet[i].R_WF * model.legs[i].offset_m;
    EXPECT_LT((r - (body.leg(i)->p_WHip - body.leg(i)->p_WAnkle)).norm(), 1e-12);
    EXPECT_LT(r.norm(), model.legs[i].length_m) << "knees are bent at home";
    EXPECT_GT(r.norm(), 0.8 * model.legs[i].length_m);
  }
}

TEST(PlannedRobotTest, MassAndGravityAreThoseToldAndGravityPointsDownOnItsOwn) {
  RobotDescription robot;
  robot.mass_kg = 3.0;  // given, but the argument counts
  robot.feet.resize(1);
  EXPECT_EQ(PlannedRobot(robot, 2.0).mass_kg, 2.0);
  EXPECT_EQ(PlannedRobot(robot, 2.0).gravity_mps2, Eigen::Vector3d(0.0, 0.0, -9.81));
  const Eigen::Vector3d moon(0.1, 0.0, -1.62);
  EXPECT_EQ(PlannedRobot(robot, 2.0, moon).gravity_mps2, moon);
}

}  // namespace
}  // namespace sidestep::make_stages_test
