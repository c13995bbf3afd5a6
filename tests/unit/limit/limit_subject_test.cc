// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/limit_subject.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "sim/scenario/read_scenario.h"
#include "tests/support/temp_folder.h"

namespace sidestep::limit::limit_subject_test {
namespace {

Scenario Shipped(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return ReadScenario(std::string(SIDESTEP_SOURCE_DIR) + "/scenarios/" + name + ".yaml", overrides);
}

TEST(LimitSubjectTest, ThePendulumIsTheRobotsAndTheGaitsOwn) {
  const LimitSubject subject = LimitSubjectOf(Shipped("icub_torque_push"));
  EXPECT_EQ(subject.gait, GaitType::kWalk);
  EXPECT_FALSE(subject.is_planar);
  const LimitParams& params = subject.params;
  EXPECT_DOUBLE_EQ(params.omega_per_s, std::sqrt(9.81 / 0.543));
  EXPECT_DOUBLE_EQ(params.sole_half_length_m, 0.105);
  EXPECT_DOUBLE_EQ(params.sole_half_width_m, 0.045);
  EXPECT_NEAR(params.cop_inset_m, 0.01, 1e-9);
  EXPECT_EQ(params.step_length_m, 0.1);
  EXPECT_EQ(params.step_width_m, 0.16);
  EXPECT_EQ(params.swing_s, 0.4);
  EXPECT_EQ(params.double_support_s, 0.1);
  EXPECT_EQ(params.swing_speed_mps, 1.2);
  EXPECT_EQ(params.least_swing_s, 0.25);
  EXPECT_EQ(params.least_rest_s, 0.1);
  EXPECT_EQ(params.least_support_s, 0.05);
  EXPECT_DOUBLE_EQ(params.nearest_m, 0.11);
  // Twice what a leg of 0.5 m covers at 0.4 m; aside the hips, 0.08 m apart, on top.
  EXPECT_GT(params.reach_m, 0.4);
  EXPECT_LT(params.reach_m, 0.8);
  EXPECT_GT(params.farthest_m, params.reach_m + 0.05);
  EXPECT_LT(params.farthest_m, params.reach_m + 0.25);
}

TEST(LimitSubjectTest, ThePlannersLeastWidthGoesBeforeTheSoles) {
  const Scenario scenario = Shipped(
      "two_legs", {"control.planner.min_step_width_m=0.13", "gait={type: walk}", "pushes=[]"});
  EXPECT_EQ(LimitSubjectOf(scenario).params.nearest_m, 0.13);
}

TEST(LimitSubjectTest, WithoutAModelStepsReachAsFarAsTheBox) {
  const Scenario scenario =
      Shipped("two_legs", {"control.mpc.box_lower_m=[-0.25, 0, 0]", "gait={type: walk}",
                           "control.mpc.box_upper_m=[0.3, 0.2, 0]", "pushes=[]"});
  const LimitParams params = LimitSubjectOf(scenario).params;
  EXPECT_DOUBLE_EQ(params.reach_m, 0.3);
  EXPECT_DOUBLE_EQ(params.farthest_m, 0.16 + 0.2);
  EXPECT_EQ(params.swing_speed_mps, 2.0) << "it is not told";
}

TEST(LimitSubjectTest, APlanarRobotAndAHopperAreTold) {
  EXPECT_TRUE(LimitSubjectOf(Shipped("biped_walk")).is_planar);
  const LimitSubject hopper = LimitSubjectOf(Shipped("hopper_push"));
  EXPECT_EQ(hopper.gait, GaitType::kHop);
  EXPECT_DOUBLE_EQ(hopper.params.reach_m, 0.8 * 0.51) << "friction, not the leg of 0.75 m";
}

TEST(LimitSubjectTest, TheGaitIsTheOneOfTheFirstPush) {
  const std::string gaits =
      "gait=[{type: walk, swing_s: 0.4}, {type: walk, start_s: 3, swing_s: 0.5}]";
  EXPECT_EQ(LimitSubjectOf(Shipped("two_legs", {gaits, "pushes=[]"})).params.swing_s, 0.5);
  const std::string push = "pushes=[{body: com, force_N: [1, 0, 0], start_s: 1, duration_s: 0.1}]";
  EXPECT_EQ(LimitSubjectOf(Shipped("two_legs", {gaits, push})).params.swing_s, 0.4);
}

TEST(LimitSubjectTest, WhatHasNoLimitIsRefused) {
  const TempFolder folder;
  const auto error_of = [&](const std::vector<std::string>& overrides) {
    return folder.ErrorOf([&] { LimitSubjectOf(Shipped("two_legs", overrides)); });
  };
  const std::string what = ".yaml: error: limit knows walks, stands on two feet and hops, not ";
  EXPECT_NE(error_of({"gait={type: run}", "pushes=[]"}).find(what + "runs"), std::string::npos);
  EXPECT_NE(error_of({"gait={type: walk, step_side_m: 0.1}", "pushes=[]"}).find("walks sideways"),
            std::string::npos);
  EXPECT_NE(folder
                .ErrorOf([&] {
                  LimitSubjectOf(Shipped("one_leg", {"gait={type: stand}", "pushes=[]"}));
                })
                .find("a stand on one"),
            std::string::npos);
}

}  // namespace
}  // namespace sidestep::limit::limit_subject_test
