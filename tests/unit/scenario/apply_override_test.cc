// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/apply_override.h"

#include <gtest/gtest.h>

#include "tests/unit/scenario/scenario_fixture.h"

namespace sidestep::apply_override_test {
namespace {

using ApplyOverrideTest = ScenarioFixture;

TEST_F(ApplyOverrideTest, ReplacesANestedValue) {
  const Scenario scenario = Read(valid_, {"control.mpc.knots=20"});
  EXPECT_EQ(scenario.control.mpc.knots, 20);
  EXPECT_EQ(scenario.control.mpc.rate_hz, 20.0) << "its neighbours stay";
}

TEST_F(ApplyOverrideTest, ReplacesAnElementOfAList) {
  const Scenario scenario = Read(valid_, {"pushes.1.start_s=3", "pushes.0.force_N.1=-4"});
  EXPECT_EQ(scenario.pushes[0].start_s, 2.0);
  EXPECT_EQ(scenario.pushes[1].start_s, 3.0);
  EXPECT_EQ(scenario.pushes[0].force_N, Eigen::Vector3d(0, -4, 0));
}

TEST_F(ApplyOverrideTest, ReplacesAWholeList) {
  const Scenario scenario =
      Read(valid_, {"pushes=[{body: shank, force_N: [1, 2, 3], start_s: 1, duration_s: 0.2}]"});
  ASSERT_EQ(scenario.pushes.size(), 1U);
  EXPECT_EQ(scenario.pushes[0].body, "shank");
  EXPECT_TRUE(Read(valid_, {"pushes=[]"}).pushes.empty());
}

TEST_F(ApplyOverrideTest, AddsWhatTheFileLeavesToItsDefault) {
  EXPECT_EQ(Read(valid_, {"sensors.delay_s=0.004"}).sensors.delay_s, 0.004);
  EXPECT_EQ(Read(valid_, {"control.mpc.weights.com=[1, 2, 3]"}).control.mpc.weights.com,
            Eigen::Vector3d(1, 2, 3));
}

TEST_F(ApplyOverrideTest, TheLastOfTwoWins) {
  EXPECT_EQ(Read(valid_, {"seed=1", "seed=2"}).seed, 2U);
}

TEST_F(ApplyOverrideTest, AValueMayHoldAnEqualsSign) {
  EXPECT_EQ(Read(valid_, {"description=a=b"}).description, "a=b");
}

TEST_F(ApplyOverrideTest, ARobotPathIsRelativeToTheCurrentFolder) {
  const auto robot = std::filesystem::relative(FixtureRobots() / "mini/robot.yaml");
  EXPECT_EQ(Read(valid_, {"robot=" + robot.string()}).robot.file,
            FixtureRobots() / "mini/robot.yaml");
}

TEST_F(ApplyOverrideTest, RefusesWhatIsNoAssignment) {
  EXPECT_EQ(ErrorOfSet("seed"), "--set seed: error: must read key=value");
  EXPECT_EQ(ErrorOfSet("=1"), "--set =1: error: '' is no dotted path of keys");
  EXPECT_EQ(ErrorOfSet("world..friction=1"),
            "--set world..friction=1: error: 'world..friction' is no dotted path of keys");
  EXPECT_EQ(ErrorOfSet("world.=1"), "--set world.=1: error: 'world.' is no dotted path of keys");
  EXPECT_EQ(ErrorOfSet("seed="), "--set seed=: error: the value is empty");
}

TEST_F(ApplyOverrideTest, RefusesAValueThatIsNoYaml) {
  EXPECT_EQ(ErrorOfSet("pushes=[{body: trunk"),
            "--set pushes=[{body: trunk: error: YAML syntax: end of map flow not found");
  EXPECT_EQ(ErrorOfSet("world={friction: 1, friction: 2}"),
            "--set world={friction: 1, friction: 2}: error: key 'friction' appears twice; first at "
            "line 1 (column 15 of the value)");
}

TEST_F(ApplyOverrideTest, RefusesAPathThatLeadsNowhere) {
  EXPECT_EQ(ErrorOfSet("pushes.2.start_s=1"),
            "--set pushes.2.start_s=1: error: pushes has no element 2; it has 2 elements");
  EXPECT_EQ(ErrorOfSet("pushes.99999999999999999999.start_s=1"),
            "--set pushes.99999999999999999999.start_s=1: error: pushes has no element "
            "99999999999999999999; it has 2 elements");
  EXPECT_EQ(ErrorOfSet("pushes.first.start_s=1"),
            "--set pushes.first.start_s=1: error: pushes is a list; 'first' is no index of it");
  EXPECT_EQ(ErrorOfSet("pushes.-1.start_s=1"),
            "--set pushes.-1.start_s=1: error: pushes is a list; '-1' is no index of it");
  EXPECT_EQ(ErrorOfSet("seed.low=1"), "--set seed.low=1: error: seed is '7', which has no 'low'");
  EXPECT_EQ(
      ErrorOfSet("gait.0.type=hop"),
      "--set gait.0.type=hop: error: gait.0 is not a known key; known keys: type, start_s, "
      "step_length_m, step_width_m, swing_s, double_support_s, stance_s, flight_s, swing_height_m, "
      "landing_speed_mps, step_side_m");
}

TEST_F(ApplyOverrideTest, TheReadersErrorsNameTheOption) {
  EXPECT_EQ(ErrorOfSet("pushes.0.start_s=x"),
            "--set pushes.0.start_s=x: error: pushes.0.start_s = 'x' is not a number");
  EXPECT_EQ(ErrorOfSet("pushes.0.strt_s=1"),
            "--set pushes.0.strt_s=1: error: pushes.0.strt_s is not a known key; did you mean "
            "'start_s'?");
  EXPECT_EQ(ErrorOfSet("contrl.rate_hz=100"),
            "--set contrl.rate_hz=100: error: contrl is not a known key; did you mean 'control'?");
  EXPECT_EQ(ErrorOfSet("pushes=[{body: trunk, force_N: [0, 0], start_s: 1, duration_s: 1}]"),
            "--set pushes=[{body: trunk, force_N: [0, 0], start_s: 1, duration_s: 1}]: error: "
            "pushes.0.force_N must be a list of 3 numbers, not of 2 (column 25 of the value)");
  EXPECT_EQ(ErrorOfSet("pushes=[{body: trunk, force_N: [0, 0, 1], start_s: 1}]"),
            "--set pushes=[{body: trunk, force_N: [0, 0, 1], start_s: 1}]: error: "
            "pushes.0.duration_s is missing (required) (column 2 of the value)");
  EXPECT_EQ(ErrorOfSet("duration_s=3"),
            "a.yaml:14:5: error: pushes.1 ends at 4.1 s, after the scenario's duration_s = 3");
}

}  // namespace
}  // namespace sidestep::apply_override_test
