// SPDX-License-Identifier: BSD-3-Clause
// A control tick of a walking humanoid, on its servos or by its joints' torques and from its own
// sensors, takes no memory once every size has been seen: nor do the ticks on which the structured
// MPC solves.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/scenario/read_scenario.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/watched_controller.h"

namespace sidestep::humanoid_tick_allocation_test {
namespace {

// One step of each foot: every shape of contacts within the horizon has been planned, or nearly.
constexpr double kWarmUp_s = 1.8;
constexpr double kCounted_s = 1.8;  // a step of each foot again

/// iCub3 on its quick walk, pushed at a hand while its ticks are counted. `how`: a mode, or how to
/// step by torques.
Scenario PushedWalk(const std::string& how, bool is_baseline) {
  Scenario scenario = ReadScenario(
      std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios/icub_walk_fast.yaml",
      is_baseline ? std::vector<std::string>{"control.mode=torque", "control.stepping=" + how}
                  : std::vector<std::string>{"control.mode=" + how});
  Push push;
  push.body = "r_hand";
  push.force_N = {0.0, 30.0, 0.0};
  push.start_s = kWarmUp_s + 0.1;
  push.duration_s = 0.5;
  scenario.pushes = {push};
  return scenario;
}

struct Counted {
  int ticks{0}, solves{0}, on_left{0}, on_right{0}, on_both{0}, pushed{0};

  void Add(const ControlTick& control) {
    const bool left = control.feet[0].planned_contact, right = control.feet[1].planned_contact;
    ++ticks;
    solves += control.mpc.ran ? 1 : 0;
    on_left += left && !right ? 1 : 0;
    on_right += right && !left ? 1 : 0;
    on_both += left && right ? 1 : 0;
    pushed += control.state.external_wrench.force_N.norm() > 0.0 ? 1 : 0;
  }
};

class HumanoidTickAllocationTest : public testing::TestWithParam<std::string> {
 protected:
  static bool IsBaseline() { return GetParam() == "dcm_qp" || GetParam() == "capture_point"; }
};

INSTANTIATE_TEST_SUITE_P(Modes, HumanoidTickAllocationTest,
                         testing::Values("position", "torque", "dcm_qp", "capture_point"),
                         [](const auto& mode) { return mode.param; });

TEST_P(HumanoidTickAllocationTest, WalkingAndPushedIcubTakesNoMemoryInAnyTick) {
  const Scenario scenario = PushedWalk(GetParam(), IsBaseline());
  ASSERT_EQ(scenario.control.mpc.backend, MpcBackend::kStructured);
  Counted counted;
  RunWatched(scenario, kWarmUp_s + kCounted_s,
             [&](const SensorFrame& frame, Controller* controller,
                 const WorldTruth& truth) -> const ControlTick& {
               const Tick tick = frame.tick;
               const std::int64_t before = CountAllocations();
               const ControlTick& control = controller->Update(frame);
               const std::int64_t taken = CountAllocations() - before;
               EXPECT_FALSE(truth.body_touches_ground) << "fell";
               if (SecondsAt(tick, scenario.world.step_s) >= kWarmUp_s) {
                 EXPECT_EQ(taken, 0) << "at tick " << tick;
                 counted.Add(control);
               }
               return control;
             });
  EXPECT_EQ(counted.ticks, std::lround(kCounted_s * scenario.control.rate_hz));
  EXPECT_EQ(counted.solves, IsBaseline() ? 0 : 36);
  EXPECT_GT(counted.on_left, 100);
  EXPECT_GT(counted.on_right, 100);
  EXPECT_GT(counted.on_both, 100);
  EXPECT_GT(counted.pushed, 50);
}

}  // namespace
}  // namespace sidestep::humanoid_tick_allocation_test
