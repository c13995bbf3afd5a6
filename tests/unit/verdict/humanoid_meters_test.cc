// SPDX-License-Identifier: BSD-3-Clause
// What a humanoid is judged by beside: soles, joints, motors, its own body.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "models/support/require.h"
#include "sim/verdict/joint_meter.h"
#include "sim/verdict/slip_meter.h"
#include "sim/verdict/sole_meter.h"
#include "sim/verdict/stance_meter.h"
#include "tests/unit/verdict/verdict_test_support.h"

namespace sidestep::humanoid_meters_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr double kMinLoad_N = 5.0;

/// A sole of 0.2 x 0.1 m, 0.02 m below F.
FootDescription BoxFoot() {
  FootDescription foot;
  foot.name = "foot";
  foot.sole_height_m = 0.02;
  foot.vertices_m.resize(3, 4);
  foot.vertices_m << 0.1, 0.1, -0.1, -0.1, 0.05, -0.05, 0.05, -0.05, -0.02, -0.02, -0.02, -0.02;
  return foot;
}

Eigen::Matrix3d About(const Eigen::Vector3d& axis, double angle_rad) {
  return Eigen::AngleAxisd(angle_rad, axis.normalized()).toRotationMatrix();
}

WorldTruth OnOneFoot(double tilt_rad, double force_N) {
  WorldTruth truth;
  truth.feet.resize(1);
  truth.feet[0].R_WF = About({1.0, 1.0, 0.0}, tilt_rad) * About(Eigen::Vector3d::UnitZ(), 0.7);
  truth.feet[0].f_F_W.z() = force_N;
  truth.feet[0].in_contact = force_N > 0.0;
  return truth;
}

TEST(SoleHeightTest, IsTheLowestCornersOverTheLevelStand) {
  FootTruth truth;
  truth.p_WF.z() = 0.02;
  EXPECT_NEAR(SoleHeight_m(BoxFoot(), truth), 0.0, 1e-15);
  truth.p_WF.z() = 0.07;
  EXPECT_NEAR(SoleHeight_m(BoxFoot(), truth), 0.05, 1e-15);
  // Toes down by 0.2 rad: by hand, the front edge is 0.1 sin lower and the sole's depth shrinks.
  truth.R_WF = About(Eigen::Vector3d::UnitY(), 0.2);
  EXPECT_NEAR(SoleHeight_m(BoxFoot(), truth), 0.07 - 0.1 * std::sin(0.2) - 0.02 * std::cos(0.2),
              1e-15);
  truth.R_WF = About(Eigen::Vector3d::UnitZ(), 1.0);
  EXPECT_NEAR(SoleHeight_m(BoxFoot(), truth), 0.05, 1e-15) << "yaw lowers nothing";
}

TEST(SoleHeightTest, PointFootIsWhereItsPointIs) {
  FootDescription foot;
  foot.sole_height_m = 0.015;
  foot.vertices_m = Eigen::Vector3d::Zero();
  FootTruth truth;
  truth.p_WF.z() = 0.055;
  truth.R_WF = About(Eigen::Vector3d::UnitX(), 0.4);
  EXPECT_NEAR(SoleHeight_m(foot, truth), 0.04, 1e-15);
}

// Shows a foot to a sole meter for as many ticks.
class WatchedSole {
 public:
  explicit WatchedSole(const FootDescription& foot) : meter_({foot}) {}
  void Add(double tilt_rad, double force_N, int ticks) {
    const WorldTruth truth = OnOneFoot(tilt_rad, force_N);
    for (int i = 0; i < ticks; ++i) {
      stances_[0].Add(tick_++, truth.feet[0]);
      meter_.Add(truth, stances_);
    }
  }
  double max_tilt_rad() const { return meter_.max_tilt_rad(); }

 private:
  Tick tick_{0};
  std::vector<StanceMeter> stances_{StanceMeter(kTick_s, kMinLoad_N)};
  SoleMeter meter_;
};

TEST(SoleMeterTest, TiltCountsWhileTheFootStandsAndBearsLoad) {
  WatchedSole meter(BoxFoot());
  EXPECT_TRUE(std::isnan(meter.max_tilt_rad()));
  meter.Add(0.3, 4.0, 100);
  EXPECT_TRUE(std::isnan(meter.max_tilt_rad())) << "barely touching";
  meter.Add(0.0, 0.0, 100);
  meter.Add(0.3, 50.0, 10);
  EXPECT_TRUE(std::isnan(meter.max_tilt_rad())) << "the toes land first";
  meter.Add(0.02, 50.0, 1);
  meter.Add(0.05, 50.0, 1);
  meter.Add(0.01, 50.0, 1);
  EXPECT_NEAR(meter.max_tilt_rad(), 0.05, 1e-12) << "yaw is no tilt";
  meter.Add(0.3, 4.0, 100);
  EXPECT_NEAR(meter.max_tilt_rad(), 0.05, 1e-12) << "it rolls off without load";
}

TEST(SoleMeterTest, PointFootHasNoSole) {
  FootDescription foot;
  foot.vertices_m = Eigen::Vector3d::Zero();
  WatchedSole meter(foot);
  meter.Add(0.3, 50.0, 100);
  EXPECT_TRUE(std::isnan(meter.max_tilt_rad()));
}

std::vector<JointInfo> ThreeJoints() {
  JointInfo hip{"hip", false, -0.5, 1.0, 20.0};
  JointInfo wheel{"wheel"};
  JointInfo leg{"leg", true, 0.0, 0.3, 100.0};
  return {hip, wheel, leg};
}

// What the robot says of them: a speed's limit of the hip and, in a unit that is not its, the leg.
std::vector<JointDescription> DescribedJoints() {
  std::vector<JointDescription> joints(3);
  joints[0].velocity_limit_radps = 4.0;
  joints[2].velocity_limit_radps = 1.0;
  return joints;
}

WorldTruth JointsAt(const Eigen::Vector3d& position, const Eigen::Vector3d& torque,
                    int num_saturated = 0) {
  WorldTruth truth;
  truth.joint_position = position;
  truth.joint_velocity.setZero(3);
  truth.joint_torque_Nm = torque;
  truth.num_saturated = num_saturated;
  return truth;
}

TEST(JointMeterTest, MarginIsTheNearestEndOfAnyHingesRange) {
  JointMeter meter(ThreeJoints(), {}, kTick_s);
  EXPECT_TRUE(std::isnan(meter.min_margin_rad()));
  meter.Add(JointsAt({0.7, 50.0, 0.299}, Eigen::Vector3d::Zero()));
  EXPECT_NEAR(meter.min_margin_rad(), 0.3, 1e-12) << "a slide's range is in metres";
  meter.Add(JointsAt({-0.4, 0.0, 0.1}, Eigen::Vector3d::Zero()));
  EXPECT_NEAR(meter.min_margin_rad(), 0.1, 1e-12);
  meter.Add(JointsAt({1.02, 0.0, 0.1}, Eigen::Vector3d::Zero()));
  meter.Add(JointsAt({0.2, 0.0, 0.1}, Eigen::Vector3d::Zero()));
  EXPECT_NEAR(meter.min_margin_rad(), -0.02, 1e-12) << "beyond";
}

TEST(JointMeterTest, TorquesPeakEitherWayAndCompareWithTheirOwnLimit) {
  JointMeter meter(ThreeJoints(), {}, kTick_s);
  EXPECT_TRUE(std::isnan(meter.max_torque_ratio()));
  meter.Add(JointsAt(Eigen::Vector3d::Zero(), {-12.0, 300.0, 50.0}));
  meter.Add(JointsAt(Eigen::Vector3d::Zero(), {8.0, 10.0, -70.0}));
  EXPECT_NEAR(meter.max_torque_ratio(), 0.7, 1e-12) << "a motor without limit has no ratio";
  ASSERT_EQ(meter.records().size(), 3U);
  EXPECT_EQ(meter.records()[0].peak_torque_Nm, 12.0);
  EXPECT_EQ(meter.records()[1].peak_torque_Nm, 300.0);
  EXPECT_EQ(meter.records()[2].peak_torque_Nm, 70.0);
  EXPECT_EQ(meter.records()[2].joint.name, "leg");
}

TEST(JointMeterTest, SpeedsPeakEitherWayAndCompareWithTheLimitThatTheRobotTells) {
  JointMeter meter(ThreeJoints(), DescribedJoints(), kTick_s);
  WorldTruth truth = JointsAt(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero());
  for (const Eigen::Vector3d& velocity :
       {Eigen::Vector3d(1.0, 50.0, 2.0), Eigen::Vector3d(-3.0, 10.0, -1.5)}) {
    truth.joint_velocity = velocity;
    meter.Add(truth);
  }
  EXPECT_NEAR(meter.max_speed_ratio(), 0.75, 1e-12) << "wheel and leg have no limit in rad/s";
  EXPECT_EQ(meter.records()[0].peak_speed_radps, 3.0);
  EXPECT_EQ(meter.records()[0].speed_limit_radps, 4.0);
  EXPECT_EQ(meter.records()[1].peak_speed_radps, 50.0);
  EXPECT_TRUE(std::isinf(meter.records()[2].speed_limit_radps));
  JointMeter untold(ThreeJoints(), {}, kTick_s);
  untold.Add(truth);
  EXPECT_TRUE(std::isnan(untold.max_speed_ratio()));
}

TEST(JointMeterTest, RobotOfOtherJointsBreaksTheContract) {
  EXPECT_THROW(JointMeter(ThreeJoints(), std::vector<JointDescription>(2), kTick_s),
               ContractViolation);
  EXPECT_NO_THROW(JointMeter({}, DescribedJoints(), kTick_s)) << "a plant without joints";
}

TEST(JointMeterTest, SaturationAddsUpTheTicksOfAnyMotor) {
  JointMeter meter(ThreeJoints(), {}, kTick_s);
  for (int saturated : {0, 1, 2, 0, 1}) {
    meter.Add(JointsAt(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), saturated));
  }
  EXPECT_NEAR(meter.saturation_s(), 0.003, 1e-15);
}

TEST(JointMeterTest, TruthOfAnotherRobotBreaksTheContract) {
  JointMeter meter(ThreeJoints(), {}, kTick_s);
  WorldTruth truth;
  EXPECT_NO_THROW(meter.Add(truth)) << "a plant without joints";
  truth.joint_position.setZero(2);
  truth.joint_velocity.setZero(2);
  truth.joint_torque_Nm.setZero(2);
  EXPECT_THROW(meter.Add(truth), ContractViolation);
}

TEST(SlipMeterTest, FootThatRollsAboutItsEdgeDoesNotSlip) {
  // Rolls by 0.1 rad about its front edge, which stays: F is 0.1 m behind it and lifts.
  StanceMeter stance(kTick_s, kMinLoad_N);
  SlipMeter meter;
  for (Tick tick = 0; tick < 100; ++tick) {
    const double roll_rad = 0.001 * static_cast<double>(tick);
    FootTruth foot;
    foot.p_WF = {0.1 - 0.1 * std::cos(roll_rad), 0.0, 0.1 * std::sin(roll_rad)};
    foot.f_F_W.z() = 50.0;
    foot.in_contact = true;
    stance.Add(tick, foot);
    meter.Add(foot, stance);
  }
  EXPECT_LT(meter.max_slip_m(), 0.6e-3) << "1 - cos of 0.1 rad over 0.1 m";
}

TEST(HumanoidJudgeTest, TellsSolesJointsBodyAndHeights) {
  Scenario scenario = OneFootScenario();
  scenario.robot.feet[0] = BoxFoot();
  scenario.robot.joints = DescribedJoints();
  Judge judge = JudgeOf(scenario, ThreeJoints());
  Watch(judge, scenario, 100, [](Tick tick, WorldTruth& truth, ControlTick&) {
    const double wave = std::sin(std::numbers::pi * static_cast<double>(tick) / 100.0);
    truth.p_WB.z() = 0.6 + 0.05 * wave;
    truth.feet[0].R_WF = About(Eigen::Vector3d::UnitX(), 0.02 * wave);
    truth.joint_position = Eigen::Vector3d(0.5 + 0.1 * wave, 0.0, 0.1);
    truth.joint_velocity = Eigen::Vector3d(-3.0 * wave, 0.0, 100.0);
    truth.joint_torque_Nm = Eigen::Vector3d(10.0 * wave, 0.0, 0.0);
    truth.num_saturated = tick >= 40 && tick < 60 ? 1 : 0;
    truth.self_contact_depth_m = 0.003 * wave;
  });
  const RunOutcome outcome = judge.Conclude();
  EXPECT_NEAR(NumberOf(outcome, "max_base_height_m"), 0.65, 1e-12);
  EXPECT_NEAR(NumberOf(outcome, "min_base_height_m"), 0.6, 1e-12);
  EXPECT_NEAR(NumberOf(outcome, "max_sole_tilt_rad"), 0.02, 1e-12);
  EXPECT_NEAR(NumberOf(outcome, "min_joint_margin_rad"), 0.4, 1e-12);
  EXPECT_NEAR(NumberOf(outcome, "max_torque_ratio"), 0.5, 1e-12);
  EXPECT_NEAR(NumberOf(outcome, "max_joint_speed_ratio"), 0.75, 1e-12) << "of the one with a limit";
  EXPECT_NEAR(NumberOf(outcome, "torque_saturation_s"), 0.02, 1e-12);
  EXPECT_NEAR(NumberOf(outcome, "max_self_penetration_m"), 0.003, 1e-12);
  ASSERT_EQ(outcome.joints.size(), 3U);
  EXPECT_NEAR(outcome.joints[0].peak_torque_Nm, 10.0, 1e-12);
}

TEST(HumanoidJudgeTest, WhatAFallenRobotDoesIsNotCounted) {
  Scenario scenario = OneFootScenario();
  scenario.robot.feet[0] = BoxFoot();
  const RunOutcome outcome =
      OutcomeOf(scenario, 200, [](Tick tick, WorldTruth& truth, ControlTick&) {
        if (tick < 100) return;
        truth.p_WB.z() = 0.1;
        truth.feet[0].R_WF = About(Eigen::Vector3d::UnitX(), 0.5);
        truth.self_contact_depth_m = 0.01;
      });
  EXPECT_EQ(NumberOf(outcome, "max_sole_tilt_rad"), 0.0);
  EXPECT_EQ(NumberOf(outcome, "max_self_penetration_m"), 0.0);
}

TEST(HumanoidJudgeTest, ClearanceOfABoxFootIsThatOfItsLowestCorner) {
  Scenario scenario = OneFootScenario();
  scenario.robot.feet[0] = BoxFoot();
  const RunOutcome outcome =
      OutcomeOf(scenario, 400, [](Tick tick, WorldTruth& truth, ControlTick&) {
        const bool swings = tick >= 100 && tick < 300;
        truth.feet[0].in_contact = !swings;
        if (!swings) return;
        const double phase = std::numbers::pi * static_cast<double>(tick - 100) / 200.0;
        truth.feet[0].p_WF.z() += 0.05 * std::sin(phase);
        truth.feet[0].R_WF = About(Eigen::Vector3d::UnitY(), 0.1);  // toes down
      });
  // By hand: at the apex the toes' edge is lower by 0.1 sin, the sole's depth all but the same.
  EXPECT_NEAR(NumberOf(outcome, "min_swing_clearance_m"),
              0.05 - 0.1 * std::sin(0.1) + 0.02 * (1.0 - std::cos(0.1)), 1e-5);
}

}  // namespace
}  // namespace sidestep::humanoid_meters_test
