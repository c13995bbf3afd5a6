// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/capture_point.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sidestep::capture_point_test {
namespace {

// w = sqrt(9.81 / 0.4905) = sqrt(20) rad/s
constexpr double kHeight_m = 0.4905;

ComReference Nominal() { return {{1.0, 0.5, kHeight_m}, {0.2, 0.0, 0.0}, {0.0, 0.0, 0.0}}; }

TEST(CapturePointTest, TimeConstantIsOneOverThePendulumsRate) {
  EXPECT_NEAR(PendulumTimeConstant_s(kHeight_m), 1.0 / std::sqrt(20.0), 1e-15);
  EXPECT_EQ(PendulumTimeConstant_s(0.0), std::sqrt(0.1 / 9.81)) << "no lower than 0.1 m";
}

TEST(CapturePointTest, ErrorAddsPlaceAndSpeedOverRate) {
  RobotState state;
  state.p_WC = {1.03, 0.5, 0.3};
  state.v_WC = {0.2, -0.1 * std::sqrt(20.0), 2.0};
  // By hand: 3 cm ahead; 10 cm / w of speed to the right; height and its speed don't count.
  EXPECT_LT(
      (CapturePointError(state, Nominal(), kHeight_m) - Eigen::Vector3d(0.03, -0.1, 0.0)).norm(),
      1e-15);
}

TEST(CapturePointTest, RobotThatMovesAsItShouldHasNoError) {
  RobotState state;
  state.p_WC = Nominal().p_WC;
  state.v_WC = Nominal().v_WC;
  EXPECT_EQ(CapturePointError(state, Nominal(), kHeight_m), Eigen::Vector3d::Zero());
}

}  // namespace
}  // namespace sidestep::capture_point_test
