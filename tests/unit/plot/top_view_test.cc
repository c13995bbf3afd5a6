// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/top_view.h"

#include <gtest/gtest.h>

#include "sim/plot/plot_script.h"

namespace sidestep::top_view_test {
namespace {

using plot::PlotData;
using plot::Sample;
using plot::View;

// A CoM that goes straight, without feet.
PlotData Straight(double x_m, double y_m) {
  PlotData data;
  for (const char* path : {"truth_path", "reference_path"}) {
    data.curves.Add(path, {Sample{0.0, 0.0}, Sample{x_m, y_m}});
  }
  return data;
}

TEST(TopViewTest, BothAxesHaveOneScaleAndFillThePanel) {
  const View view = plot::FittedView(Straight(1.0, 0.8));
  const Eigen::Vector2d panel_em = plot::PanelSize_em(plot::Canvas(), view.rows, 1);
  EXPECT_EQ(view.rows, 1);
  EXPECT_NEAR(view.x.length() / panel_em.x(), view.m_per_em, 1e-12);
  EXPECT_NEAR(view.y.length() / panel_em.y(), view.m_per_em, 1e-12);
}

TEST(TopViewTest, ALongWalkIsBrokenIntoRowsThatHoldItAll) {
  const View view = plot::FittedView(Straight(9.0, 0.2));
  EXPECT_GT(view.rows, 1);
  EXPECT_NEAR(view.x.length(), view.rows * view.length_m, 1e-9);
  EXPECT_LT(view.x.min, 0.0);
  EXPECT_GT(view.x.max, 9.0);
  EXPECT_EQ(plot::FittedView(Straight(0.2, 9.0)).rows, 1) << "rows don't help a walk sideways";
}

TEST(TopViewTest, ThePushsArrowComesFromWhereThePushDoes) {
  const plot::PushMark to_the_left{0.5, 0.2, 0.0, 40.0};
  const Eigen::Vector2d tail = plot::TailOf(to_the_left, 0.1);
  EXPECT_DOUBLE_EQ(tail.x(), 0.5);
  EXPECT_LT(tail.y(), 0.2);
  PlotData data = Straight(1.0, 0.0);
  data.push_marks = {to_the_left};
  EXPECT_LT(plot::FittedView(data).y.min, plot::TailOf(to_the_left, 0.01).y());
}

TEST(TopViewTest, AFootThatNeverLandedIsWhereItWasTo) {
  Footstep step;
  step.adjusted_p_WF << 1.0, 2.0, 0.0;
  EXPECT_DOUBLE_EQ(plot::PlaceOf(step).x(), 1.0);
  step.realised_p_WF = Eigen::Vector3d(3.0, 4.0, 0.0);
  EXPECT_DOUBLE_EQ(plot::PlaceOf(step).x(), 3.0);
}

}  // namespace
}  // namespace sidestep::top_view_test
