// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/frames.h"

#include <gtest/gtest.h>

#include <utility>

#include "models/support/config_error.h"
#include "sim/render/camera_path.h"

namespace sidestep::render::frames_test {
namespace {

StateLog LogOf(int rows, double dt_s) {
  StateLog log;
  log.dt_s = dt_s;
  log.rows.resize(static_cast<std::size_t>(rows));
  return log;
}

Clip Whole(const StateLog& log) { return ClipOf(log, {}, {}, 1.0); }

// Ten seconds from 2 s on.
StateLog LateLog() {
  StateLog log = LogOf(1000, 0.01);
  log.rows.front().time_s = 2.0;
  return log;
}

TEST(FramesTest, ASlowFilmOfAPartHasMoreFramesThatAreCloser) {
  const Clip clip = ClipOf(LateLog(), 7.0, 11.0, 0.25);
  EXPECT_EQ(FrameCount(clip, 30), 4 * 4 * 30);
  EXPECT_DOUBLE_EQ(FrameTime_s(clip, 0, 30), 5.0) << "after the log's first row";
  EXPECT_DOUBLE_EQ(FrameTime_s(clip, 120, 30), 6.0);
}

TEST(FramesTest, APartIsCutToTheRunAndNoneIsRefused) {
  EXPECT_NEAR(ClipOf(LateLog(), 0.0, 99.0, 1.0).duration_s, 10.0, 1e-9);
  EXPECT_NEAR(ClipOf(LateLog(), {}, 3.0, 1.0).duration_s, 1.0, 1e-9);
  for (const auto& [from_s, to_s] : {std::pair{5.0, 5.0}, {6.0, 5.0}, {12.5, 13.0}, {0.0, 2.0}}) {
    EXPECT_THROW(ClipOf(LateLog(), from_s, to_s, 1.0), ConfigError) << from_s << " " << to_s;
  }
}

TEST(FramesTest, TheVideoLastsAsLongAsTheLog) {
  EXPECT_EQ(FrameCount(Whole(LogOf(1400, 0.01)), 30), 420);
  EXPECT_EQ(FrameCount(Whole(LogOf(50, 0.01)), 25), 13) << "12.5 frames round up";
  EXPECT_EQ(FrameCount(Whole(LogOf(1, 0.001)), 30), 1) << "a run cut at once still has a picture";
}

TEST(FramesTest, EachFrameShowsTheNearestRow) {
  const StateLog log = LogOf(100, 0.01);
  EXPECT_EQ(RowAt(log, 0.0), 0U);
  EXPECT_EQ(RowAt(log, 0.014), 1U);
  EXPECT_EQ(RowAt(log, 0.016), 2U);
  EXPECT_EQ(RowAt(log, 7.0), 99U);
  EXPECT_EQ(RowAt(log, -1.0), 0U);
}

TEST(FramesTest, SpansCoverAllFramesOnceInOrder) {
  for (const int jobs : {1, 2, 3, 7, 100}) {
    int next = 0;
    for (const FrameSpan& span : SplitFrames(10, jobs)) {
      EXPECT_EQ(span.first, next);
      EXPECT_GT(span.end, span.first);
      next = span.end;
    }
    EXPECT_EQ(next, 10) << jobs;
  }
  EXPECT_EQ(SplitFrames(10, 3).size(), 3U);
  EXPECT_EQ(SplitFrames(10, 100).size(), 10U) << "no span is empty";
}

TEST(CameraTest, TheFollowCameraKeepsUpWithASteadyWalk) {
  std::vector<Eigen::Vector3d> p_WC;
  for (int i = 0; i < 500; ++i) p_WC.emplace_back(0.002 * i, 0.0, 0.6);
  for (const std::size_t row : {0U, 10U, 250U, 499U}) {
    const CameraPose camera = CameraAt(VideoCamera::kFollow, p_WC, 0.01, row, 0.6, 4.0 / 3.0);
    EXPECT_NEAR(camera.look_at_W.x(), p_WC[row].x(), 1e-9) << row;
  }
}

TEST(CameraTest, TheFollowCameraDoesNotJumpWithTheRobot) {
  std::vector<Eigen::Vector3d> p_WC(400, Eigen::Vector3d(0, 0, 0.6));
  for (std::size_t i = 200; i < 400; ++i) p_WC[i].y() = 0.5;  // a jump of half a metre
  double largest_m = 0.0;
  double before_m = 0.0;
  for (std::size_t row = 0; row < 400; ++row) {
    const double y = CameraAt(VideoCamera::kFollow, p_WC, 0.01, row, 0.6, 4.0 / 3.0).look_at_W.y();
    largest_m = std::max(largest_m, std::abs(y - before_m));
    before_m = y;
  }
  EXPECT_LT(largest_m, 0.01);
  EXPECT_GT(before_m, 0.49);
}

TEST(CameraTest, TheFixedCameraNeverMovesAndStandsFartherBackForALongerWalk) {
  const std::vector<Eigen::Vector3d> walk{{0, 0, 0.6}, {1, 0, 0.6}, {2, 0, 0.6}};
  const CameraPose first = CameraAt(VideoCamera::kFixed, walk, 0.01, 0, 0.6, 4.0 / 3.0);
  const CameraPose last = CameraAt(VideoCamera::kFixed, walk, 0.01, 2, 0.6, 4.0 / 3.0);
  EXPECT_EQ(first.look_at_W, last.look_at_W);
  EXPECT_NEAR(first.look_at_W.x(), 1.0, 1e-12);
  const std::vector<Eigen::Vector3d> stand(3, Eigen::Vector3d(0, 0, 0.6));
  EXPECT_GT(first.distance_m,
            CameraAt(VideoCamera::kFixed, stand, 0.01, 0, 0.6, 4.0 / 3.0).distance_m + 1.0);
}

TEST(CameraTest, FromTheSideForwardIsToTheRightAndFromAboveIsAsInThePlot) {
  const std::vector<Eigen::Vector3d> stand(3, Eigen::Vector3d(0.0, 0.0, 0.6));
  const auto view = [&](CameraView from) {
    return CameraAt(VideoCamera::kFollow, stand, 0.01, 1, 0.6, 4.0 / 3.0, from);
  };
  // MuJoCo's camera looks along (cos, sin) of its azimuth; what is to its right is x for 90 deg.
  EXPECT_DOUBLE_EQ(view(CameraView::kSide).azimuth_deg, 90.0);
  EXPECT_DOUBLE_EQ(view(CameraView::kAbove).azimuth_deg, 90.0);
  EXPECT_LT(view(CameraView::kAbove).elevation_deg, -80.0);
  EXPECT_DOUBLE_EQ(view(CameraView::kFront).azimuth_deg, 180.0) << "looks against x";
}

}  // namespace
}  // namespace sidestep::render::frames_test
