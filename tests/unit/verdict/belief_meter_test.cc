// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/belief_meter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sidestep::belief_meter_test {
namespace {

constexpr double kTick_s = 0.01;

class BeliefMeterTest : public testing::Test {
 protected:
  BeliefMeterTest() {
    belief_.feet.resize(1);
    truth_.pushes.resize(1);
  }

  /// The belief is off by `error_mps` for ticks `from` to `to`.
  void Show(BeliefMeter* meter, Tick from, Tick to, double error_mps) {
    truth_.v_WC = {0.5, -0.3, 0.1};
    belief_.v_WC = truth_.v_WC + error_mps * Eigen::Vector3d(0.6, 0.0, 0.8);
    for (Tick tick = from; tick <= to; ++tick) meter->Add(tick, truth_, belief_);
  }

  static Push From(double start_s, double duration_s) {
    Push push;
    push.start_s = start_s;
    push.duration_s = duration_s;
    return push;
  }

  WorldTruth truth_;
  RobotState belief_;
};

TEST_F(BeliefMeterTest, MeanSquaresAreOverTicksAndTheLargestIsTheLargest) {
  BeliefMeter meter({}, kTick_s);
  Show(&meter, 0, 2, 0.1);
  Show(&meter, 3, 3, 0.3);
  // By hand: (3 * 0.01 + 0.09) / 4 = 0.03.
  EXPECT_NEAR(meter.com_velocity_mps().rms(), std::sqrt(0.03), 1e-12);
  EXPECT_NEAR(meter.com_velocity_mps().max(), 0.3, 1e-12);
  EXPECT_TRUE(std::isnan(meter.pushed_com_velocity_mps().rms())) << "no push";
  EXPECT_TRUE(std::isnan(meter.pushed_com_velocity_mps().max()));
}

TEST_F(BeliefMeterTest, PushesWindowLastsUntilASecondAfterItsEnd) {
  BeliefMeter meter({From(1.0, 0.5)}, kTick_s);
  Show(&meter, 99, 99, 9.0);
  Show(&meter, 100, 250, 0.2);
  Show(&meter, 251, 251, 7.0);
  EXPECT_NEAR(meter.pushed_com_velocity_mps().max(), 0.2, 1e-12);
  EXPECT_NEAR(meter.pushed_com_velocity_mps().rms(), 0.2, 1e-12);
  EXPECT_NEAR(meter.com_velocity_mps().max(), 9.0, 1e-12);
}

TEST_F(BeliefMeterTest, WindowsThatOverlapCountATickOnce) {
  BeliefMeter meter({From(1.0, 0.5), From(1.2, 0.5)}, kTick_s);
  Show(&meter, 120, 120, 0.4);
  Show(&meter, 260, 260, 0.2);
  EXPECT_NEAR(meter.pushed_com_velocity_mps().rms(), std::sqrt((0.16 + 0.04) / 2.0), 1e-12);
}

TEST_F(BeliefMeterTest, PushIsHorizontalAndTheSumOfAll) {
  BeliefMeter meter({From(0.0, 1.0), From(0.0, 1.0)}, kTick_s);
  truth_.pushes.resize(2);
  truth_.pushes[0].force_W_N = {30.0, 0.0, 500.0};
  truth_.pushes[1].force_W_N = {0.0, 40.0, 0.0};
  Show(&meter, 0, 0, 0.0);
  EXPECT_NEAR(meter.push_N().max(), 50.0, 1e-12) << "it knows of none";
  belief_.external_wrench.force_N = {30.0, 36.0, -100.0};
  Show(&meter, 1, 1, 0.0);
  EXPECT_NEAR(meter.push_N().rms(), std::sqrt((2500.0 + 16.0) / 2.0), 1e-12);
}

TEST_F(BeliefMeterTest, WhoeverBelievesNothingIsNotMeasured) {
  BeliefMeter meter({From(0.0, 1.0)}, kTick_s);
  belief_.feet.clear();
  Show(&meter, 0, 10, 1.0);
  EXPECT_TRUE(std::isnan(meter.com_velocity_mps().max()));
  EXPECT_TRUE(std::isnan(meter.push_N().rms()));
}

}  // namespace
}  // namespace sidestep::belief_meter_test
