// SPDX-License-Identifier: BSD-3-Clause
#include "sim/world/centroidal_world.h"

#include <gtest/gtest.h>

#include "models/support/config_error.h"
#include "models/support/require.h"
#include "sim/world/make_world.h"
#include "tests/unit/world/centroidal_test_support.h"

namespace sidestep::centroidal_world_test {
namespace {

constexpr double kGravity_mps2 = 9.81;
constexpr double kRoundOff = 1e-12;  // of a thousand additions of numbers around one

// Both feet stand and every vertex pushes up with the same force.
ActuatorCommand Standing(const CentroidalWorld& world, double total_N) {
  ActuatorCommand command;
  for (const FootTruth& foot : world.truth().feet) {
    Eigen::Matrix3Xd force_N = Eigen::Matrix3Xd::Zero(3, 4);
    force_N.row(2).setConstant(total_N / 8.0);
    command.centroidal_feet.push_back({foot.p_WF, force_N, true});
  }
  return command;
}

void StepTo(CentroidalWorld& world, Tick end) {
  for (Tick tick = 0; tick < end; ++tick) world.Step(tick);
}

TEST(CentroidalWorldTest, FallsByTheLawWithoutForces) {
  CentroidalWorld world = MakeCentroidalWorld(TwoFeetScenario());
  world.Apply({});
  StepTo(world, 300);
  EXPECT_NEAR(world.truth().p_WC.z(), 0.5 - 0.5 * kGravity_mps2 * 0.09, kRoundOff);
  EXPECT_NEAR(world.truth().v_WC.z(), -kGravity_mps2 * 0.3, kRoundOff);
  EXPECT_EQ(world.truth().v_WC.head<2>().norm(), 0.0);
}

TEST(CentroidalWorldTest, FlightKeepsHorizontalAndAngularMomentum) {
  Scenario scenario = TwoFeetScenario();
  Push push;
  push.body = "com";
  push.force_N = {10.0, -4.0, 0.0};
  push.point_m = {0.0, 0.0, 0.3};
  push.duration_s = 0.05;
  scenario.pushes = {push};
  CentroidalWorld world = MakeCentroidalWorld(scenario);
  StepTo(world, 50);
  const WorldTruth after_push = world.truth();
  EXPECT_GT(after_push.angular_momentum.norm(), 0.1);
  for (Tick tick = 50; tick < 250; ++tick) world.Step(tick);
  EXPECT_TRUE(world.truth().angular_momentum.isApprox(after_push.angular_momentum, kRoundOff));
  EXPECT_TRUE(world.truth().v_WC.head<2>().isApprox(after_push.v_WC.head<2>(), kRoundOff));
}

TEST(CentroidalWorldTest, ManySmallTicksEqualOneLongOneUnderAConstantLoad) {
  CentroidalState state{{0.1, -0.2, 0.6}, {0.4, 0.3, -0.5}, {0.05, -0.02, 0.01}};
  CentroidalLoad load;
  load.force_N = Eigen::Vector3d(3.0, -2.0, 25.0);
  load.point_W = Eigen::Vector3d(0.05, 0.1, 0.0);
  load.com_force_N = {1.0, 2.0, -3.0};
  load.com_torque_Nm = {0.1, 0.0, -0.2};
  const CentroidalState once = Advance(state, load, 2.0, 0.4);
  for (int i = 0; i < 400; ++i) state = Advance(state, load, 2.0, 0.001);
  EXPECT_LT((state.p_WC - once.p_WC).norm(), kRoundOff);
  EXPECT_LT((state.v_WC - once.v_WC).norm(), kRoundOff);
  EXPECT_LT((state.angular_momentum - once.angular_momentum).norm(), kRoundOff);
}

TEST(CentroidalWorldTest, AngularMomentumAgreesWithAWorkedExample) {
  // m = 1, f = (0, 0, 9.81) at (0.2, 0, 0) holds the weight; the CoM starts at x = 0 with 1 m/s.
  // hdot_y = -(0.2 - t) 9.81, so after 0.1 s h_y = -9.81 (0.02 - 0.005) = -0.14715.
  const CentroidalState start{{0.0, 0.0, 0.5}, {1.0, 0.0, 0.0}, Eigen::Vector3d::Zero()};
  CentroidalLoad load;
  load.force_N = Eigen::Vector3d(0.0, 0.0, kGravity_mps2);
  load.point_W = Eigen::Vector3d(0.2, 0.0, 0.0);
  const CentroidalState end = Advance(start, load, 1.0, 0.1);
  EXPECT_LT((end.angular_momentum - Eigen::Vector3d(0.0, -0.14715, 0.0)).norm(), 1e-15);
  EXPECT_LT((end.p_WC - Eigen::Vector3d(0.1, 0.0, 0.5)).norm(), 1e-15);
}

TEST(CentroidalWorldTest, SideForceBelowComRollsIt) {
  // By hand: (-0.5 z^) x (1 y^) = 0.5 x^, so 1 N at the ground to the left for 10 ms gives
  // h_x = 0.005.
  const CentroidalState start{{0.0, 0.0, 0.5}, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  CentroidalLoad load;
  load.force_N = Eigen::Vector3d(0.0, 1.0, 0.0);
  load.point_W = Eigen::Vector3d::Zero();
  load.com_force_N = {0.0, 0.0, kGravity_mps2};
  EXPECT_NEAR(Advance(start, load, 1.0, 0.01).angular_momentum.x(), 0.005, 1e-15);
}

TEST(CentroidalWorldTest, StandsWhileTheFeetCarryTheWeight) {
  CentroidalWorld world = MakeCentroidalWorld(TwoFeetScenario());
  world.Apply(Standing(world, 2.0 * kGravity_mps2));
  StepTo(world, 500);
  EXPECT_LT((world.truth().p_WC - Eigen::Vector3d(0.0, 0.0, 0.5)).norm(), kRoundOff);
  EXPECT_LT(world.truth().angular_momentum.norm(), kRoundOff);
  EXPECT_NEAR(world.truth().feet[0].f_F_W.z(), kGravity_mps2, kRoundOff);
}

TEST(CentroidalWorldTest, PushImpulseOverMassIsTheVelocityGained) {
  Scenario scenario = TwoFeetScenario();
  Push push;
  push.body = "com";
  push.force_N = {0.0, 6.0, 0.0};
  push.start_s = 0.1;
  push.duration_s = 0.2;
  scenario.pushes = {push};
  CentroidalWorld world = MakeCentroidalWorld(scenario);
  world.Apply(Standing(world, 2.0 * kGravity_mps2));
  StepTo(world, 100);
  EXPECT_EQ(world.truth().v_WC.y(), 0.0);
  EXPECT_EQ(world.truth().pushes[0].force_W_N.y(), 6.0) << "the push acts from this tick on";
  for (Tick tick = 100; tick < 400; ++tick) world.Step(tick);
  EXPECT_NEAR(world.truth().v_WC.y(), 6.0 * 0.2 / 2.0, kRoundOff);
  EXPECT_EQ(world.truth().pushes[0].force_W_N.y(), 0.0);
}

TEST(CentroidalWorldTest, PushAtAFootTurnsTheBody) {
  Scenario scenario = TwoFeetScenario();
  Push push;
  push.body = "left";
  push.force_N = {1.0, 0.0, 0.0};
  push.duration_s = 0.001;
  scenario.pushes = {push};
  CentroidalWorld world = MakeCentroidalWorld(scenario);
  world.Apply(Standing(world, 2.0 * kGravity_mps2));
  world.Step(0);
  // By hand: lever (0, 0.1, -0.5) x (1, 0, 0) = (0, -0.5, -0.1) N m, for one millisecond. Within
  // it the CoM runs off the feet's 19.6 N by a dt^2 / 6 = 8e-8 m: another 1.6e-9.
  const Eigen::Vector3d expected(0.0, -0.5e-3, -0.1e-3);
  EXPECT_LT((world.truth().angular_momentum - expected).norm(), 2e-9);
}

TEST(CentroidalWorldTest, FloorShortensATangentialForceToItsCone) {
  const Eigen::Vector3d inside(1.0, -1.0, 10.0);
  EXPECT_EQ(ClampToFrictionCone(inside, 0.5), inside);
  const Eigen::Vector3d clipped = ClampToFrictionCone({6.0, 8.0, 10.0}, 0.5);
  EXPECT_LT((clipped - Eigen::Vector3d(3.0, 4.0, 10.0)).norm(), 1e-12);
  EXPECT_EQ(ClampToFrictionCone({1.0, 0.0, -3.0}, 0.5), Eigen::Vector3d::Zero());
}

TEST(CentroidalWorldTest, PlantAppliesWhatTheFloorGivesAndReportsIt) {
  CentroidalWorld world = MakeCentroidalWorld(TwoFeetScenario());
  ActuatorCommand command = Standing(world, 16.0);
  command.centroidal_feet[1].force_N.row(0).setConstant(100.0);
  world.Apply(command);
  world.Step(0);
  EXPECT_NEAR(world.truth().feet[1].f_F_W.x(), 0.5 * 8.0, kRoundOff);
  EXPECT_NEAR(world.truth().v_WC.x(), 4.0 / 2.0 * 0.001, kRoundOff);
}

TEST(CentroidalWorldTest, StandingFootStaysWhereItLandedWhateverTheCommandSays) {
  CentroidalWorld world = MakeCentroidalWorld(TwoFeetScenario());
  ActuatorCommand command = Standing(world, 16.0);
  command.centroidal_feet[0].in_contact = false;
  command.centroidal_feet[0].p_WF = {0.3, 0.1, 0.05};
  world.Apply(command);
  world.Step(0);
  EXPECT_EQ(world.truth().feet[0].p_WF.x(), 0.3);
  EXPECT_EQ(world.truth().feet[0].f_F_W.norm(), 0.0) << "a foot in the air gets no force";

  command.centroidal_feet[0].in_contact = true;
  command.centroidal_feet[0].p_WF = {0.4, 0.1, 0.0};
  world.Apply(command);
  command.centroidal_feet[0].p_WF = {0.7, 0.1, 0.0};
  world.Apply(command);
  world.Step(1);
  EXPECT_EQ(world.truth().feet[0].p_WF.x(), 0.4);
}

TEST(CentroidalWorldTest, ForceThatIsNoNumberEndsTheRun) {
  CentroidalWorld world = MakeCentroidalWorld(TwoFeetScenario());
  ActuatorCommand command = Standing(world, 16.0);
  command.centroidal_feet[0].force_N(2, 0) = std::numeric_limits<double>::quiet_NaN();
  world.Apply(command);
  world.Step(0);
  EXPECT_FALSE(world.is_valid());
  EXPECT_EQ(world.invalid_reason(), "the centroidal state is not finite");
}

TEST(CentroidalWorldTest, CommandOfAnotherShapeIsRefused) {
  CentroidalWorld world = MakeCentroidalWorld(TwoFeetScenario());
  ActuatorCommand command = Standing(world, 16.0);
  command.centroidal_feet[0].force_N.setZero(3, 3);
  EXPECT_THROW(world.Apply(command), ContractViolation);
  command.centroidal_feet.pop_back();
  EXPECT_THROW(world.Apply(command), ContractViolation);
}

TEST(CentroidalWorldTest, UnknownBodyOfAPushIsAUsersMistake) {
  Scenario scenario = TwoFeetScenario();
  scenario.pushes.resize(1);
  scenario.pushes[0].body = "elbow";
  EXPECT_THROW(MakeCentroidalWorld(scenario), ConfigError);
}

}  // namespace
}  // namespace sidestep::centroidal_world_test
