// SPDX-License-Identifier: BSD-3-Clause
// Force/torque sensors and the accelerometer average over the steps of a control period.
#include <gtest/gtest.h>

#include <numbers>

#include "sim/sensors/sensor_suite.h"

namespace sidestep::averaging_test {
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

class DeltaVelocityTest : public testing::Test {
 protected:
  /// A unit with this attitude that feels `specific_force_mps2`, in its own axes.
  static WorldTruth Feels(const Eigen::Vector3d& specific_force_mps2,
                          const Eigen::Quaterniond& q_WU = Eigen::Quaterniond::Identity()) {
    WorldTruth truth;
    truth.imu.q_WU = q_WU;
    truth.imu.accelerometer_mps2 = specific_force_mps2;
    return truth;
  }

  Eigen::Vector3d Read(const WorldTruth& truth) {
    return sensors_.Read(truth, tick_++).imu.accelerometer_mps2;
  }

  SensorSuite sensors_{SensorSetup{}};
  Tick tick_{0};
};

TEST_F(DeltaVelocityTest, ReadingIsTheMeanOfTheStepsSinceTheLast) {
  sensors_.Accumulate(Feels({100.0, 0.0, 0.0}));
  Read(Feels({0.0, 0.0, 0.0}));
  for (const double x_mps2 : {-50.0, 80.0, 0.0}) sensors_.Accumulate(Feels({x_mps2, 1.0, 9.0}));
  EXPECT_LT((Read(Feels({0.0, 1.0, 9.0})) - Eigen::Vector3d(10.0, 1.0, 9.0)).norm(), 1e-12);
}

TEST_F(DeltaVelocityTest, TurningUnitTellsTheMeanInTheAxesThatItEndsWith) {
  // It turns a quarter about z while W's x is where it is pushed to: x of U first, -y in the end.
  const Eigen::Quaterniond quarter(
      Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitZ()));
  sensors_.Accumulate(Feels({2.0, 0.0, 9.0}));
  sensors_.Accumulate(Feels({0.0, -4.0, 9.0}, quarter));
  const WorldTruth end = Feels({0.0, -4.0, 9.0}, quarter);
  EXPECT_LT((Read(end) - Eigen::Vector3d(0.0, -3.0, 9.0)).norm(), 1e-12);
}

TEST_F(DeltaVelocityTest, WithoutAStepItIsWhatIsFeltNow) {
  EXPECT_EQ(Read(Feels({7.0, 0.0, 1.0})), Eigen::Vector3d(7.0, 0.0, 1.0));
  sensors_.Accumulate(Feels({100.0, 0.0, 0.0}));
  Read(Feels({0.0, 0.0, 0.0}));
  EXPECT_EQ(Read(Feels({9.0, 0.0, 0.0})).x(), 9.0);
}

}  // namespace
}  // namespace sidestep::averaging_test
