// SPDX-License-Identifier: BSD-3-Clause
// A planar robot on point feet: its shipped scenarios, their negative controls, and that nothing of
// what is planned or done leaves the plane.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/closed_loop.h"
#include "tests/support/watched_controller.h"

namespace sidestep {
namespace {

const std::vector<std::string> kNoStepAdjustment{"control.mpc.box_lower_m=[0, 0, 0]",
                                                 "control.mpc.box_upper_m=[0, 0, 0]"};

TEST(RabbitTest, WalksFromItsSensors) {
  const ClosedLoopRun run("rabbit_walk");
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

TEST(RabbitTest, WalksOnWhenPushedForwardsAndBackwards) {
  const ClosedLoopRun run("rabbit_walk_push");
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

// Its points bear a moment between them: 8 cm apart, where the closing step leaves them.
TEST(RabbitTest, StopsAndStandsOnItsPoints) {
  const ClosedLoopRun run(
      "rabbit_walk",
      {"gait=[{type: walk, start_s: 0.0, step_length_m: 0.15, step_width_m: 0.12, swing_s: 0.35, "
       "double_support_s: 0.1, swing_height_m: 0.05, landing_speed_mps: 0.1}, "
       "{type: stand, start_s: 3.0, step_width_m: 0.12}]",
       "expect={fall: false, max_tilt_rad: {max: 0.1}}"});
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

TEST(RabbitTest, FallsWhenItDoesNothing) {
  const ClosedLoopRun run("rabbit_walk", {"control.mode=passive"});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST(RabbitTest, FallsEvenUnpushedWhenItMayNotMoveItsSteps) {
  const ClosedLoopRun run("rabbit_walk", kNoStepAdjustment);
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST(RabbitTest, FallsUnderTenTimesThePush) {
  const ClosedLoopRun run("rabbit_walk_push", {"pushes.0.force_N=[1200, 0, 0]"});
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

TEST(RabbitTest, NothingPlannedOrDoneLeavesThePlane) {
  const Scenario scenario = ReadScenario(
      std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios/rabbit_walk_push.yaml", {});
  double planned_N = 0.0, realised_N = 0.0, beside_m = 0.0, adjusted_m = 0.0;
  RunWatched(
      scenario, 8.0,
      [&](const SensorFrame& frame, Controller* controller,
          const WorldTruth& truth) -> const ControlTick& {
        const ControlTick& tick = controller->Update(frame);
        beside_m = std::max({beside_m, std::abs(tick.com.p_WC.y()), std::abs(truth.p_WC.y())});
        for (std::size_t i = 0; i < tick.feet.size(); ++i) {
          const FootTarget& foot = tick.feet[i];
          planned_N = std::max(planned_N, foot.vertex_force_N.row(1).cwiseAbs().maxCoeff());
          realised_N = std::max(realised_N, std::abs(truth.feet[i].f_F_W.y()));
          adjusted_m = std::max(
              adjusted_m, std::abs(foot.contact.adjusted_p_WF.x() - foot.contact.nominal_p_WF.x()));
        }
        return tick;
      });
  // The solvers' rounding on forces of 1000 N; what the floor does to a foot is symmetric.
  EXPECT_LT(planned_N, 1e-8);
  EXPECT_LT(realised_N, 1e-8);
  EXPECT_LT(beside_m, 1e-9);
  EXPECT_GT(adjusted_m, 0.05) << "a push that moves no step proves little";
}

}  // namespace
}  // namespace sidestep
