// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/read_sections.h"

#include <gtest/gtest.h>

#include "tests/unit/scenario/scenario_fixture.h"

namespace sidestep::read_sections_test {
namespace {

using ReadSectionsTest = ScenarioFixture;

TEST_F(ReadSectionsTest, ReadsOneGaitOrAList) {
  EXPECT_EQ(Read(valid_).gait.size(), 1U);
  EXPECT_EQ(Read(valid_).gait[0].stance_s, 0.25);
  const Scenario scenario =
      Read(valid_, {"gait=[{type: stand}, {type: hop, start_s: 1.5, flight_s: 0.3}]"});
  ASSERT_EQ(scenario.gait.size(), 2U);
  EXPECT_EQ(scenario.gait[0].type, GaitType::kStand);
  EXPECT_EQ(scenario.gait[1].type, GaitType::kHop);
  EXPECT_EQ(scenario.gait[1].start_s, 1.5);
  EXPECT_EQ(scenario.gait[1].flight_s, 0.3);
}

TEST_F(ReadSectionsTest, OneFootHasNoStepWidthByDefaultAndTwoFeetHave) {
  EXPECT_EQ(Read(valid_, {"gait={type: hop}"}).gait[0].step_width_m, 0.0);
  const Scenario walker = Read(
      "sidestep: 1\nname: w\nrobot: walker\nplant: centroidal\nduration_s: 1\ngait: {type: "
      "walk}\n");
  EXPECT_EQ(walker.gait[0].step_width_m, GaitParams().step_width_m);
}

TEST_F(ReadSectionsTest, ReadsEveryKeyOfAPush) {
  const Push push = Read(valid_, {"pushes.0.profile=half_sine", "pushes.0.frame=body"}).pushes[0];
  EXPECT_EQ(push.body, "trunk");
  EXPECT_EQ(push.force_N, Eigen::Vector3d(0, 5, 0));
  EXPECT_EQ(push.start_s, 2.0);
  EXPECT_EQ(push.duration_s, 0.5);
  EXPECT_EQ(push.point_m, Eigen::Vector3d(0, 0, 0.1));
  EXPECT_EQ(push.profile, PushProfile::kHalfSine);
  EXPECT_EQ(push.frame, PushFrame::kBody);
}

TEST_F(ReadSectionsTest, ADirectionCountsFromXTowardsYInTheHeadingFrame) {
  const Scenario scenario = Read(valid_, {"pushes.1.direction_rad=1.5707963267948966"});
  EXPECT_EQ(scenario.pushes[1].frame, PushFrame::kHeading);
  EXPECT_NEAR(scenario.pushes[1].force_N.x(), 0.0, 1e-15);
  EXPECT_NEAR(scenario.pushes[1].force_N.y(), 2.0, 1e-15);
  EXPECT_EQ(scenario.pushes[1].force_N.z(), 0.0);
  EXPECT_EQ(scenario.pushes[0].frame, PushFrame::kWorld) << "the default with force_N";
}

TEST_F(ReadSectionsTest, ReadsExpectationsOfEveryForm) {
  const Scenario scenario =
      Read(valid_, {"expect={slip: true, mpc_failures: 0, energy_J: {min: 1, max: 2}}"});
  ASSERT_EQ(scenario.expect.size(), 3U);
  EXPECT_EQ(scenario.expect[0].metric, "slip");
  EXPECT_EQ(scenario.expect[0].is, true);
  EXPECT_FALSE(scenario.expect[0].min || scenario.expect[0].max);
  EXPECT_EQ(scenario.expect[1].min, 0.0);
  EXPECT_EQ(scenario.expect[1].max, 0.0);
  EXPECT_EQ(scenario.expect[2].min, 1.0);
  EXPECT_EQ(scenario.expect[2].max, 2.0);
  EXPECT_FALSE(Read(valid_).expect[1].min) << "max alone";
}

TEST_F(ReadSectionsTest, ReadsVideo) {
  const VideoParams video = Read(valid_).video;
  EXPECT_TRUE(video.enabled);
  EXPECT_EQ(video.size.width_px, 320);
  EXPECT_EQ(video.size.height_px, 240);
  EXPECT_EQ(video.fps, 25);
  EXPECT_EQ(video.camera, VideoCamera::kFixed);
  EXPECT_FALSE(Read(valid_, {"video=false"}).video.enabled);
  EXPECT_TRUE(Read(valid_, {"video=true"}).video.enabled);
}

TEST_F(ReadSectionsTest, GaitErrors) {
  EXPECT_EQ(ErrorOfEdit("stance_s: 0.25", "stanse_s: 0.25"),
            "a.yaml:11:19: error: gait.stanse_s is not a known key; did you mean 'stance_s'?");
  EXPECT_EQ(ErrorOfEdit("stance_s: 0.25", "stance_s: 0"),
            "a.yaml:11:29: error: gait.stance_s = 0 violates 0.02 <= stance_s <= 5");
  EXPECT_EQ(
      ErrorOfEdit("type: hop", "type: skip"),
      "a.yaml:11:14: error: gait.type = 'skip' is not known; known values: stand, walk, run, hop");
  EXPECT_EQ(ErrorOfSet("gait=[]"), "--set gait=[]: error: gait must hold at least one gait");
  EXPECT_EQ(ErrorOfSet("gait=hop"),
            "--set gait=hop: error: gait must be a map of keys or a list of them");
  EXPECT_EQ(
      ErrorOfSet("gait=[hop]"),
      "--set gait=[hop]: error: gait.0 must be a map of keys, not 'hop' (column 2 of the value)");
}

TEST_F(ReadSectionsTest, PushErrors) {
  EXPECT_EQ(ErrorOfSet("pushes={}"), "--set pushes={}: error: pushes must be a list, not a map");
  EXPECT_EQ(ErrorOfEdit("body: trunk, ", ""),
            "a.yaml:13:5: error: pushes.0.body is missing (required)");
  EXPECT_EQ(ErrorOfEdit("start_s: 2, ", ""),
            "a.yaml:13:5: error: pushes.0.start_s is missing (required)");
  EXPECT_EQ(ErrorOfEdit(", duration_s: 0.1", ""),
            "a.yaml:14:5: error: pushes.1.duration_s is missing (required)");
  EXPECT_EQ(ErrorOfEdit("start_s: 2", "start_s: -2"),
            "a.yaml:13:48: error: pushes.0.start_s = -2 violates 0 <= start_s <= 10000");
  EXPECT_EQ(ErrorOfEdit("duration_s: 0.1", "duration_s: 0"),
            "a.yaml:14:76: error: pushes.1.duration_s must be greater than 0");
  EXPECT_EQ(ErrorOfEdit("force_N: [0, 5, 0]", "force_N: 5"),
            "a.yaml:13:28: error: pushes.0.force_N must be a list of 3 numbers, not '5'");
  EXPECT_EQ(
      ErrorOfEdit("force_N: [0, 5, 0]", "force_N: [0, 1e6, 0]"),
      "a.yaml:13:32: error: pushes.0.force_N.1 = 1e+06 violates -1e+05 <= force_N.1 <= 1e+05");
  EXPECT_EQ(ErrorOfEdit("force_N: [0, 5, 0], ", ""),
            "a.yaml:13:5: error: pushes.0 needs force_N, or direction_rad and one of magnitude_N, "
            "magnitude_mg, impulse_Nspkg");
  EXPECT_EQ(ErrorOfEdit("force_N: [0, 5, 0]", "force_N: [0, 5, 0], magnitude_N: 5"),
            "a.yaml:13:52: error: pushes.0.magnitude_N and force_N exclude each other");
  EXPECT_EQ(ErrorOfEdit("force_N: [0, 5, 0]", "force_N: [0, 5, 0], direction_rad: 1"),
            "a.yaml:13:54: error: pushes.0.direction_rad and force_N exclude each other");
  EXPECT_EQ(ErrorOfEdit("magnitude_N: 2", "magnitude_N: 2, impulse_Nspkg: 1"),
            "a.yaml:14:49: error: pushes.1.impulse_Nspkg and magnitude_N exclude each other");
  EXPECT_EQ(ErrorOfEdit("start_s: 2", "start_s: 2, at_phase: 0.5"),
            "a.yaml:13:61: error: pushes.0.at_phase and start_s exclude each other");
  EXPECT_EQ(ErrorOfEdit("start_s: 2", "start_s: 2, foot: left"),
            "a.yaml:13:57: error: pushes.0.foot goes with at_phase, which is absent");
  EXPECT_EQ(ErrorOfEdit("start_s: 2", "at_phase: mid_swin"),
            "a.yaml:13:49: error: pushes.0.at_phase = 'mid_swin' is not known; did you mean "
            "'mid_swing'?");
  EXPECT_EQ(ErrorOfEdit("start_s: 2", "at_phase: 1.5"),
            "a.yaml:13:49: error: pushes.0.at_phase = 1.5 violates 0 <= at_phase <= 1");
  EXPECT_EQ(ErrorOfEdit("direction_rad: 0, ", ""),
            "a.yaml:14:5: error: pushes.1.direction_rad is missing (required)");
  EXPECT_EQ(ErrorOfEdit("magnitude_N: 2, ", ""),
            "a.yaml:14:5: error: pushes.1.magnitude_N is missing (required)");
  EXPECT_EQ(ErrorOfEdit("magnitude_N: 2", "magnitude_N: -2"),
            "a.yaml:14:31: error: pushes.1.magnitude_N = -2 violates 0 <= magnitude_N <= 1e+05");
  EXPECT_EQ(ErrorOfEdit("direction_rad: 0", "direction_rad: 90"),
            "a.yaml:14:49: error: pushes.1.direction_rad = 90 violates -7 <= direction_rad <= 7");
  EXPECT_EQ(ErrorOfEdit("direction_rad: 0", "direction_rad: 0, frame: world"),
            "a.yaml:14:59: error: pushes.1.frame must be heading, or absent, where direction_rad "
            "is given");
  EXPECT_EQ(ErrorOfEdit("point_m: [0, 0, 0.1]", "point_m: [0, 0, 100]"),
            "a.yaml:13:84: error: pushes.0.point_m.2 = 100 violates -10 <= point_m.2 <= 10");
  EXPECT_EQ(ErrorOfEdit("point_m: [0, 0, 0.1]", "profile: sine"),
            "a.yaml:13:77: error: pushes.0.profile = 'sine' is not known; known values: constant, "
            "half_sine");
  EXPECT_EQ(ErrorOfEdit("point_m: [0, 0, 0.1]", "frame: base"),
            "a.yaml:13:75: error: pushes.0.frame = 'base' is not known; known values: world, "
            "heading, body");
  EXPECT_EQ(ErrorOfEdit("point_m: [0, 0, 0.1]", "torque_Nm: 1"),
            "a.yaml:13:68: error: pushes.0.torque_Nm is not a known key; known keys: body, "
            "force_N, magnitude_N, magnitude_mg, impulse_Nspkg, direction_rad, start_s, at_phase, "
            "foot, after_s, duration_s, point_m, profile, frame");
}

TEST_F(ReadSectionsTest, ExpectationErrors) {
  EXPECT_EQ(ErrorOfSet("expect=[fall]"),
            "--set expect=[fall]: error: expect must be a map of keys, not a list");
  EXPECT_EQ(ErrorOfEdit("max_tilt_rad:", "max_tild_rad:"),
            "a.yaml:18:3: error: expect.max_tild_rad is not a known metric; did you mean "
            "'max_tilt_rad'?");
  EXPECT_EQ(ErrorOfEdit("  fall: false", "  fall: 0"),
            "a.yaml:17:9: error: expect.fall must be true or false, not '0'");
  EXPECT_EQ(ErrorOfEdit("{max: 0.5}", "true"),
            "a.yaml:18:17: error: expect.max_tilt_rad must be a number or {min, max}: this metric "
            "is not true or false");
  EXPECT_EQ(ErrorOfEdit("{max: 0.5}", "{}"),
            "a.yaml:18:17: error: expect.max_tilt_rad needs min, max or both");
  EXPECT_EQ(
      ErrorOfEdit("{max: 0.5}", "{max: 0.5, mean: 0.1}"),
      "a.yaml:18:28: error: expect.max_tilt_rad.mean is not a known key; known keys: min, max");
  EXPECT_EQ(ErrorOfEdit("{max: 0.5}", "{max: 0.5, min: 0.6}"),
            "a.yaml:18:17: error: expect.max_tilt_rad has min = 0.6 above max = 0.5");
  EXPECT_EQ(ErrorOfEdit("{max: 0.5}", "[0, 0.5]"),
            "a.yaml:18:17: error: expect.max_tilt_rad must be a number, not a list");
  EXPECT_EQ(ErrorOfEdit("{max: 0.5}", "small"),
            "a.yaml:18:17: error: expect.max_tilt_rad = 'small' is not a number");
  EXPECT_TRUE(ErrorOfSet("expect.elegance=1")
                  .starts_with("--set expect.elegance=1: error: expect.elegance is not a known "
                               "metric; known metrics: "
                               "fall, slip, fall_time_s, "))
      << "nothing is near: all are listed";
}

TEST_F(ReadSectionsTest, VideoErrors) {
  EXPECT_EQ(
      ErrorOfEdit("[320, 240]", "[320]"),
      "a.yaml:19:15: error: video.size must be a list of 2 integers, [width, height] in pixels");
  EXPECT_EQ(ErrorOfEdit("[320, 240]", "[321, 240]"),
            "a.yaml:19:16: error: video.size.0 = 321 must be even, as H.264 asks");
  EXPECT_EQ(ErrorOfEdit("[320, 240]", "[320, 10]"),
            "a.yaml:19:21: error: video.size.1 = 10 violates 64 <= size.1 <= 4096");
  EXPECT_EQ(ErrorOfEdit("[320, 240]", "320x240"),
            "a.yaml:19:15: error: video.size must be a list, not '320x240'");
  EXPECT_EQ(ErrorOfEdit("fps: 25", "fps: 0"),
            "a.yaml:19:32: error: video.fps = 0 violates 1 <= fps <= 240");
  EXPECT_EQ(ErrorOfEdit("fps: 25", "fps: 29.97"),
            "a.yaml:19:32: error: video.fps = '29.97' is not an integer");
  EXPECT_EQ(
      ErrorOfEdit("camera: fixed", "camera: drone"),
      "a.yaml:19:44: error: video.camera = 'drone' is not known; known values: follow, fixed");
  EXPECT_EQ(ErrorOfEdit("camera: fixed", "codec: av1"),
            "a.yaml:19:36: error: video.codec is not a known key; known keys: size, fps, camera");
  EXPECT_EQ(ErrorOfSet("video=no"), "--set video=no: error: video must be a map of keys, not 'no'");
}

}  // namespace
}  // namespace sidestep::read_sections_test
