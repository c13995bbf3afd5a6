// SPDX-License-Identifier: BSD-3-Clause
#include "controller/planner/com_spline.h"

#include <gtest/gtest.h>

namespace sidestep::com_spline_test {
namespace {

constexpr double kDuration_s = 0.4;
constexpr double kRounding = 1e-12;
// An acceleration is a sum of terms of 1000 here, at the far end.
constexpr double kAccelerationRounding = 1e-10;

const ComReference kFrom{{0.1, -0.2, 0.5}, {0.3, 0.1, -0.2}, {1.0, -2.0, 0.5}};
const ComReference kTo{{0.4, 0.3, 0.6}, {-0.2, 0.5, 0.1}, {-1.5, 0.7, 2.0}};

void ExpectSame(const ComReference& is, const ComReference& wanted) {
  EXPECT_LT((is.p_WC - wanted.p_WC).norm(), kRounding);
  EXPECT_LT((is.v_WC - wanted.v_WC).norm(), kRounding);
  EXPECT_LT((is.a_WC - wanted.a_WC).norm(), kAccelerationRounding);
}

TEST(ComSplineTest, EndsAreExactInPositionVelocityAndAcceleration) {
  ExpectSame(QuinticAt(kFrom, kTo, kDuration_s, 0.0), kFrom);
  ExpectSame(QuinticAt(kFrom, kTo, kDuration_s, kDuration_s), kTo);
}

TEST(ComSplineTest, VelocityAndAccelerationAreDerivatives) {
  constexpr double kStep_s = 1e-5;
  for (const double time_s : {0.05, 0.2, 0.37}) {
    const ComReference before = QuinticAt(kFrom, kTo, kDuration_s, time_s - kStep_s);
    const ComReference at = QuinticAt(kFrom, kTo, kDuration_s, time_s);
    const ComReference after = QuinticAt(kFrom, kTo, kDuration_s, time_s + kStep_s);
    // The step squared times derivatives of up to 10^4 here.
    EXPECT_LT(((after.p_WC - before.p_WC) / (2.0 * kStep_s) - at.v_WC).norm(), 1e-6);
    EXPECT_LT(((after.v_WC - before.v_WC) / (2.0 * kStep_s) - at.a_WC).norm(), 1e-6);
  }
}

TEST(ComSplineTest, HalfwayFromRestToRestIsTheMidpointAtFifteenEighthsOfTheMeanSpeed) {
  const ComReference from{{0.0, 0.0, 0.5}, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  const ComReference to{{0.4, 0.0, 0.5}, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  const ComReference half = QuinticAt(from, to, kDuration_s, 0.5 * kDuration_s);
  EXPECT_LT((half.p_WC - Eigen::Vector3d(0.2, 0.0, 0.5)).norm(), kRounding);
  EXPECT_NEAR(half.v_WC.x(), 15.0 / 8.0 * 0.4 / kDuration_s, kRounding);
}

TEST(ComSplineTest, OutsideItsDurationItRestsAtTheEnds) {
  const ComReference early = QuinticAt(kFrom, kTo, kDuration_s, -0.1);
  const ComReference late = QuinticAt(kFrom, kTo, kDuration_s, kDuration_s + 0.1);
  ExpectSame(early, {kFrom.p_WC, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  ExpectSame(late, {kTo.p_WC, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
}

}  // namespace
}  // namespace sidestep::com_spline_test
