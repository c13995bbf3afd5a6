// SPDX-License-Identifier: BSD-3-Clause
// The small meters: slips, flights, solver answers and tilt.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "sim/verdict/fall_meter.h"
#include "sim/verdict/flight_meter.h"
#include "sim/verdict/plan_log.h"
#include "sim/verdict/slip_meter.h"
#include "sim/verdict/stance_meter.h"

namespace sidestep::meters_test {
namespace {

constexpr double kTick_s = 0.001;
constexpr double kMinLoad_N = 5.0;

FootTruth FootAt(double x_m, double force_N, bool in_contact = true) {
  FootTruth foot;
  foot.p_WF.x() = x_m;
  foot.f_F_W.z() = force_N;
  foot.in_contact = in_contact;
  return foot;
}

// A foot and what watches it.
class WatchedFoot {
 public:
  void Add(Tick tick, const FootTruth& foot) {
    stance_.Add(tick, foot);
    slip_.Add(foot, stance_);
  }
  const SlipMeter* operator->() const { return &slip_; }

 private:
  StanceMeter stance_{kTick_s, kMinLoad_N};
  SlipMeter slip_;
};

TEST(SlipMeterTest, SettlingOfTheFirstTenMillisecondsIsNoSlip) {
  WatchedFoot meter;
  for (Tick tick = 0; tick < 10; ++tick) meter.Add(tick, FootAt(SecondsAt(tick, 0.01), 50.0));
  for (Tick tick = 10; tick < 50; ++tick) meter.Add(tick, FootAt(0.5, 50.0));
  EXPECT_EQ(meter->max_slip_m(), 0.0);
  meter.Add(50, FootAt(0.503, 50.0));
  EXPECT_NEAR(meter->max_slip_m(), 0.003, 1e-15);
}

TEST(SlipMeterTest, UnloadedFootMayMove) {
  WatchedFoot meter;
  for (Tick tick = 0; tick < 50; ++tick) meter.Add(tick, FootAt(0.0, 50.0));
  meter.Add(50, FootAt(0.1, 4.0));
  EXPECT_EQ(meter->max_slip_m(), 0.0);
  meter.Add(51, FootAt(0.1, 6.0));
  EXPECT_NEAR(meter->max_slip_m(), 0.1, 1e-15) << "loaded again in the same stance, it has slid";
}

TEST(SlipMeterTest, NextStanceHasItsOwnAnchor) {
  WatchedFoot meter;
  for (Tick tick = 0; tick < 50; ++tick) meter.Add(tick, FootAt(0.0, 50.0));
  meter.Add(50, FootAt(0.002, 50.0));
  for (Tick tick = 51; tick < 150; ++tick) meter.Add(tick, FootAt(0.2, 0.0, false));
  EXPECT_EQ(meter->stance_slip_m(), 0.0);
  for (Tick tick = 150; tick < 200; ++tick) meter.Add(tick, FootAt(0.4, 50.0));
  EXPECT_EQ(meter->stance_slip_m(), 0.0);
  EXPECT_NEAR(meter->max_slip_m(), 0.002, 1e-15);
}

TEST(SlipMeterTest, FootThatChattersAcrossTheFloorSlips) {
  // Slides 1 mm a tick and loses contact on every fifth: the stance goes on through the bounces.
  WatchedFoot meter;
  for (Tick tick = 0; tick < 100; ++tick) {
    const bool in_contact = tick % 5 != 4;
    meter.Add(tick, FootAt(SecondsAt(tick, 0.001), in_contact ? 50.0 : 0.0, in_contact));
  }
  EXPECT_NEAR(meter->max_slip_m(), 0.001 * (98 - 10), 1e-12);
}

TEST(SlipMeterTest, FootThatIsDraggedUnderLoadSlipsAndOneThatOnlyScuffsDoesNot) {
  // Off the ground until tick 100; on it until 150, moving 1 mm a tick; off again.
  const auto slip_m = [](double force_N) {
    WatchedFoot meter;
    for (Tick tick = 0; tick < 200; ++tick) {
      const bool touches = tick >= 100 && tick < 150;
      meter.Add(tick, FootAt(0.001 * static_cast<double>(tick), touches ? force_N : 0.0, touches));
    }
    return meter->max_slip_m();
  };
  EXPECT_NEAR(slip_m(50.0), 0.001 * (149 - 110), 1e-12) << "its anchor is taken after 10 ms";
  EXPECT_EQ(slip_m(4.0), 0.0);
}

StanceMeter AfterTicks(const std::vector<FootTruth>& ticks) {
  StanceMeter stance(kTick_s, kMinLoad_N);
  for (std::size_t i = 0; i < ticks.size(); ++i) stance.Add(static_cast<Tick>(i), ticks[i]);
  return stance;
}

// `count` ticks of a foot.
std::vector<FootTruth> Ticks(std::size_t count, double force_N, bool in_contact) {
  return std::vector<FootTruth>(count, FootAt(0.0, force_N, in_contact));
}

std::vector<FootTruth> operator+(std::vector<FootTruth> left, const std::vector<FootTruth>& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

TEST(StanceMeterTest, BeginsWithLoadAndNotWithATouch) {
  EXPECT_FALSE(AfterTicks(Ticks(50, 4.0, true)).stands());
  const StanceMeter stance = AfterTicks(Ticks(50, 4.0, true) + Ticks(1, 6.0, true));
  EXPECT_TRUE(stance.stands());
  EXPECT_EQ(stance.num_stances(), 1);
  EXPECT_FALSE(AfterTicks(Ticks(50, 50.0, false)).stands()) << "a force without ground";
}

TEST(StanceMeterTest, ABounceBelongsToItAndAFlightEndsIt) {
  const auto stood = Ticks(20, 50.0, true);
  EXPECT_TRUE(AfterTicks(stood + Ticks(10, 0.0, false)).stands());
  EXPECT_FALSE(AfterTicks(stood + Ticks(11, 0.0, false)).stands());
  EXPECT_EQ(AfterTicks(stood + Ticks(10, 0.0, false) + stood).num_stances(), 1);
  EXPECT_EQ(AfterTicks(stood + Ticks(11, 0.0, false) + stood).num_stances(), 2);
}

TEST(StanceMeterTest, GoesOnWithoutLoadWhileTheFootTouches) {
  const StanceMeter stance = AfterTicks(Ticks(20, 50.0, true) + Ticks(300, 1.0, true));
  EXPECT_TRUE(stance.stands());
  EXPECT_FALSE(stance.bears_load());
}

TEST(StanceMeterTest, LoadIsSettledTenMillisecondsAfterTheStart) {
  EXPECT_FALSE(AfterTicks(Ticks(10, 50.0, true)).bears_settled_load());
  EXPECT_TRUE(AfterTicks(Ticks(11, 50.0, true)).bears_settled_load());
  EXPECT_FALSE(AfterTicks(Ticks(11, 50.0, true) + Ticks(1, 1.0, true)).bears_settled_load());
  const auto again = Ticks(30, 50.0, true) + Ticks(30, 0.0, false) + Ticks(10, 50.0, true);
  EXPECT_FALSE(AfterTicks(again).bears_settled_load()) << "each landing settles anew";
}

// A ballistic flight from tick 10 to 210 whose apex is `rise_m` above 0.5 m, wanted at 0.6 m.
double ApexError(double rise_m, Tick flight_ticks) {
  FlightMeter meter(kTick_s);
  for (Tick tick = 0; tick < 300; ++tick) {
    WorldTruth truth;
    truth.feet.resize(1);
    truth.feet[0].in_contact = tick < 10 || tick >= 10 + flight_ticks;
    const double u = 2.0 * static_cast<double>(tick - 10) / static_cast<double>(flight_ticks) - 1.0;
    const double hill = truth.feet[0].in_contact ? 0.0 : 1.0 - u * u;
    truth.p_WC.z() = 0.5 + rise_m * hill;
    meter.Add(truth, 0.5 + 0.1 * hill);
  }
  return meter.max_apex_error_m();
}

TEST(FlightMeterTest, ApexErrorIsTruthAgainstTheNominalOfTheSameFlight) {
  EXPECT_NEAR(ApexError(0.1, 200), 0.0, 1e-12);
  EXPECT_NEAR(ApexError(0.13, 200), 0.03, 1e-12);
  EXPECT_NEAR(ApexError(0.04, 200), 0.06, 1e-12);
}

TEST(FlightMeterTest, ShortLossOfContactIsNoFlight) {
  EXPECT_TRUE(std::isnan(ApexError(0.13, 40)));
}

TEST(ConeViolationTest, IsTheWorstOfAllVerticesAndOfBothSides) {
  FootTarget foot;
  EXPECT_EQ(ConeViolation_N(foot, 0.5), 0.0);
  foot.vertex_force_N.resize(3, 2);
  foot.vertex_force_N.col(0) << 2.0, -3.0, 10.0;  // |2| + |3| = 0.5 x 10: on the edge
  foot.vertex_force_N.col(1) << 0.0, 0.0, 4.0;
  EXPECT_NEAR(ConeViolation_N(foot, 0.5), 0.0, 1e-15);
  foot.vertex_force_N.col(0).x() = 2.5;
  EXPECT_NEAR(ConeViolation_N(foot, 0.5), 0.5, 1e-12);
  foot.vertex_force_N.col(1).z() = -3.0;
  EXPECT_NEAR(ConeViolation_N(foot, 0.5), 3.0, 1e-12);
}

TEST(TiltTest, IsMeasuredFromTheAttitudeAtTheStart) {
  Scenario scenario;
  scenario.robot.base_rpy_rad = {0.2, -0.3, 0.9};
  const Eigen::Quaterniond start = Eigen::AngleAxisd(0.9, Eigen::Vector3d::UnitZ()) *
                                   Eigen::AngleAxisd(-0.3, Eigen::Vector3d::UnitY()) *
                                   Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX());
  const Eigen::Vector3d up_B = UprightAxis(scenario.robot, scenario.plant);
  EXPECT_NEAR(TiltRad(start, up_B), 0.0, 1e-15);
  const Eigen::AngleAxisd turn(0.4, Eigen::Vector3d::UnitX());
  EXPECT_NEAR(TiltRad(turn * start, up_B), 0.4, 1e-12);
  scenario.plant = Plant::kCentroidal;
  EXPECT_EQ(UprightAxis(scenario.robot, scenario.plant), Eigen::Vector3d::UnitZ())
      << "a point mass has no attitude";
}

TEST(FallMeterTest, BaseThatIsBuiltTiltedHasNotFallen) {
  Scenario scenario;
  scenario.robot.base_rpy_rad.y() = -1.2;
  FallMeter meter(scenario.robot, scenario.plant, scenario.verdict);
  WorldTruth truth;
  truth.q_WB = Eigen::AngleAxisd(-1.2, Eigen::Vector3d::UnitY());
  meter.Add(0, truth);
  EXPECT_FALSE(meter.has_fallen());
  EXPECT_NEAR(meter.max_tilt_rad(), 0.0, 1e-12);
  truth.q_WB = Eigen::Quaterniond::Identity();
  meter.Add(1, truth);
  EXPECT_TRUE(meter.has_fallen());
}

TEST(TiltTest, KeepsItsDigitsNearUprightAndUpsideDown) {
  const auto tilt = [](double angle_rad) {
    return TiltRad(Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY())));
  };
  EXPECT_NEAR(tilt(1e-9), 1e-9, 1e-16);
  EXPECT_NEAR(tilt(3.0), 3.0, 1e-12);
}

}  // namespace
}  // namespace sidestep::meters_test
