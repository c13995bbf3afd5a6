// SPDX-License-Identifier: BSD-3-Clause
// The planar biped on ground that its controller is not told of, and where that ends.

#include <gtest/gtest.h>

#include <string>

#include "tests/support/closed_loop.h"

namespace sidestep {
namespace {

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

// A late foot looks 2 cm down for the ground, and feet are lifted by 4 cm.
TEST(UnevenTest, FallsOverAHoleAndAStepOfFourCentimetres) {
  for (const char* name : {"biped_walk_drop", "biped_walk_step"}) {
    const std::string sign = std::string(name) == "biped_walk_drop" ? "-" : "";
    const ClosedLoopRun run(name, {"world.ground.0.height_m=" + sign + "0.04"});
    EXPECT_TRUE(run.FailedBy(reason::kFall)) << name << ": " << run.Describe();
  }
}

}  // namespace
}  // namespace sidestep
