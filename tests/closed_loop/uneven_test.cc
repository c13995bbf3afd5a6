// SPDX-License-Identifier: BSD-3-Clause
// The planar biped on ground that its controller is not told of, and where that ends.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/closed_loop.h"
#include "tests/support/watched_controller.h"

namespace sidestep {
namespace {

std::string Height(const std::string& height_m) { return "world.ground.0.height_m=" + height_m; }

TEST(UnevenTest, WalksOverAHoleAStepAndSlipperyGround) {
  for (const char* name : {"biped_walk_drop", "biped_walk_step", "biped_walk_slippery"}) {
    const ClosedLoopRun run(name);
    EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << name << ": " << run.Describe();
  }
}

// The same ground beside its way, for what it is made of must not matter.
TEST(UnevenTest, WalksPastAHoleAsOnLevelGround) {
  const ClosedLoopRun run("biped_walk_drop",
                          {"world.ground.0.from_y_m=0.5", "expect.max_tilt_rad={max: 0.03}"});
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

TEST(UnevenTest, WalksOverHolesAsDeepAsItSearches) {
  for (const char* height_m : {"-0.03", "-0.04"}) {
    const ClosedLoopRun run("biped_walk_drop", {Height(height_m)});
    EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << height_m << run.Describe();
  }
  // At its full depth it leans by 0.12 rad, more than the scenario's 2 cm ask for: the momentum of
  // falling over the other foot's toes goes into the trunk, and does with the exact state too.
  const ClosedLoopRun deepest("biped_walk_drop",
                              {Height("-0.06"), "expect.max_tilt_rad={max: 0.13}"});
  EXPECT_EQ(deepest.verdict.verdict_class, VerdictClass::kPass) << deepest.Describe();
}

// At 0.1 m/s a hole of 4 cm takes a foot 0.4 s, and the fall over the other one has not that long.
TEST(UnevenTest, FallsOverAHoleOfFourCentimetresThatItSearchesAtLandingSpeed) {
  const ClosedLoopRun run("biped_walk_drop",
                          {Height("-0.04"), "control.planner.search_acceleration_mps2=0"});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST(UnevenTest, WalksOverAStepThatItsFeetAreLiftedOver) {
  const ClosedLoopRun low("biped_walk_step", {Height("0.03")});
  EXPECT_EQ(low.verdict.verdict_class, VerdictClass::kPass) << low.Describe();
  const ClosedLoopRun high("biped_walk_step", {Height("0.04"), "gait.1.swing_height_m=0.06"});
  EXPECT_EQ(high.verdict.verdict_class, VerdictClass::kPass) << high.Describe();
}

// Feet are lifted by 4 cm: they trip over the edge, and steps that move catch it. Either way in 10
// of 10 seeds.
TEST(UnevenTest, TripsOverAStepAsHighAsItsFeetAreLiftedAndFallsIfItMayNotMoveItsSteps) {
  const ClosedLoopRun tripped("biped_walk_step",
                              {Height("0.04"), "expect={fall: false, max_tilt_rad: {min: 0.2}}"});
  EXPECT_EQ(tripped.verdict.verdict_class, VerdictClass::kPass) << tripped.Describe();
  const ClosedLoopRun held("biped_walk_step", {Height("0.04"), "control.mpc.box_lower_m=[0, 0, 0]",
                                               "control.mpc.box_upper_m=[0, 0, 0]"});
  EXPECT_TRUE(held.FailedBy(reason::kFall)) << held.Describe();
}

/// Largest error (m) of the believed CoM's height in the run of `name`, `duration_s` of it.
double LargestHeightError_m(const std::string& name, double duration_s,
                            const std::vector<std::string>& overrides = {}) {
  const Scenario scenario = ReadScenario(
      std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios" / (name + ".yaml"), overrides);
  double error_m = 0.0;
  RunWatched(scenario, duration_s,
             [&](const SensorFrame& frame, Controller* controller,
                 const WorldTruth& truth) -> const ControlTick& {
               const ControlTick& tick = controller->Update(frame);
               error_m = std::max(error_m, std::abs(tick.state.p_WC.z() - truth.p_WC.z()));
               return tick;
             });
  return error_m;
}

// Measured up to 1.3 mm over 2 cm and 0.8 mm in the deepest hole. Told of the floor at every
// bounce, the belief was 4 mm and 11 mm off, and steps came late.
TEST(UnevenTest, LearnsHowHighItsFeetStand) {
  EXPECT_LT(LargestHeightError_m("biped_walk_drop", 12.0), 0.003);
  EXPECT_LT(LargestHeightError_m("biped_walk_step", 12.0), 0.003);
  EXPECT_LT(LargestHeightError_m("biped_walk_drop", 12.0, {Height("-0.06")}), 0.003);
  EXPECT_GT(LargestHeightError_m("biped_walk_drop", 12.0, {"control.estimation.floor_noise_m=0"}),
            0.015)
      << "whoever takes the floor to be level falls for the hole";
}

// Measured 0.7 mm and 0.8 mm: a floor that is known a little keeps the height from drifting.
TEST(UnevenTest, OnLevelGroundTheHeightDoesNotDrift) {
  EXPECT_LT(LargestHeightError_m("biped_walk", 20.0), 0.002);
  EXPECT_LT(LargestHeightError_m("biped_walk", 60.0, {"duration_s=60"}), 0.002);
}

TEST(UnevenTest, SlidesOnSlipperyGroundThatItIsNotToldOf) {
  const ClosedLoopRun run("biped_walk_slippery",
                          {"control.mpc.friction=0.5", "control.inverse_dynamics.friction=0.6"});
  EXPECT_TRUE(run.FailedBy(reason::kExpectation)) << run.Describe();
}

}  // namespace
}  // namespace sidestep
