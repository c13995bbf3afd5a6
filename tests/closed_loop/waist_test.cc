// SPDX-License-Identifier: BSD-3-Clause
// Where a model is rooted decides nothing: one machine stands, walks and goes the same way whether
// its base is below its waist or above it. The waist is six times softer than the legs.
#include <gtest/gtest.h>

#include "tests/support/closed_loop.h"
#include "tests/support/waist_humanoid.h"

namespace sidestep::waist_test {
namespace {

ClosedLoopRun RunRooted(WaistRoot root, const TempFolder& folder,
                        std::vector<std::string> overrides) {
  overrides.push_back("robot=" + WaistHumanoid(folder, root).string());
  return ClosedLoopRun("humanoid_walk", overrides);
}

TEST(WaistTest, ARobotRootedAboveItsWaistStandsAsOneRootedBelow) {
  for (const WaistRoot root : {WaistRoot::kPelvis, WaistRoot::kTrunk}) {
    const TempFolder folder;
    const ClosedLoopRun run = RunRooted(
        root, folder,
        {"duration_s=6", "gait={type: stand, step_width_m: 0.19}",
         "expect={fall: false, max_tilt_rad: {max: 0.01}, max_path_error_m: {max: 0.005}}"});
    EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
  }
}

TEST(WaistTest, ARobotRootedAboveItsWaistWalks) {
  const TempFolder folder;
  const ClosedLoopRun run = RunRooted(WaistRoot::kTrunk, folder, {});
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

TEST(WaistTest, AShoveThatARobotRootedBelowItsWaistBearsOneRootedAboveBearsToo) {
  for (const WaistRoot root : {WaistRoot::kPelvis, WaistRoot::kTrunk}) {
    const TempFolder folder;
    const ClosedLoopRun run =
        RunRooted(root, folder,
                  {"duration_s=10", "expect={fall: false}",
                   "pushes=[{body: trunk, impulse_Nspkg: 0.1, direction_rad: 1.57, "
                   "start_s: 4, duration_s: 0.1}]"});
    EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
  }
}

}  // namespace
}  // namespace sidestep::waist_test
