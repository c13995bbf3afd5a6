// SPDX-License-Identifier: BSD-3-Clause
// Force/torque sensors average over the steps of a control period.
#include <gtest/gtest.h>

#include "sim/sensors/sensor_suite.h"

namespace sidestep::force_averaging_test {
namespace {

WorldTruth Under(double force_N) {
  WorldTruth truth;
  truth.force_torque = {{{force_N, 1.0, -force_N}, {0.0, 2.0 * force_N, 0.5}}};
  return truth;
}

class ForceAveragingTest : public testing::Test {
 protected:
  Wrench Read(double force_N) { return sensors_.Read(Under(force_N), tick_++).force_torque[0]; }

  SensorSuite sensors_{SensorSetup{}};
  Tick tick_{0};
};

TEST_F(ForceAveragingTest, ReadingIsTheMeanOfTheStepsSinceTheLast) {
  sensors_.Accumulate(Under(100.0));
  Read(0.0);
  for (const double force_N : {3.0, -1.0, 10.0}) sensors_.Accumulate(Under(force_N));
  const Wrench mean = Read(10.0);  // by hand: 12 / 3 = 4, and nothing of the 100 before
  EXPECT_LT((mean.force_N - Eigen::Vector3d(4.0, 1.0, -4.0)).norm(), 1e-12);
  EXPECT_LT((mean.torque_Nm - Eigen::Vector3d(0.0, 8.0, 0.5)).norm(), 1e-12);
}

TEST_F(ForceAveragingTest, WithoutAStepItIsWhatActsNow) {
  EXPECT_EQ(Read(7.0).force_N.x(), 7.0);
  sensors_.Accumulate(Under(100.0));
  Read(0.0);
  EXPECT_EQ(Read(9.0).force_N.x(), 9.0);
}

}  // namespace
}  // namespace sidestep::force_averaging_test
