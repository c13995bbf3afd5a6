// SPDX-License-Identifier: BSD-3-Clause
// How many shoves at the chest the torque-controlled iCub survives: eight directions at four
// moments of a step, in place and at 0.2 m/s, as shipped, by the clock, and with fixed footholds.
// Moments are those of the contacts in an unpushed run, sensors the scenario's, with their noise
// and biases. Long: label `cluster`.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "tests/support/closed_loop.h"
#include "tests/support/watched_controller.h"

namespace sidestep {
namespace {

constexpr const char* kScenario = "icub_torque_push";
constexpr double kMass_kg = 52.4;
constexpr int kDirections = 8;
constexpr double kSteady_s = 3.9;  // from here on moments are looked for
constexpr double kUnpushed_s = 6.5;
constexpr double kAfter_s = 4.0;
using Overrides = std::vector<std::string>;

const Overrides kByTheClock{"control.planner.timing.error_m=0"};
const Overrides kFixed{"control.planner.timing.error_m=0", "control.mpc.box_lower_m=[0, 0, 0]",
                       "control.mpc.box_upper_m=[0, 0, 0]"};
struct Walk {
  double swing_s, double_support_s, width_m;
};

struct Shove {
  double impulse;  // over the mass, N s/kg
  double duration_s;
  double first_rad{0.0};  // of the eight directions
  const char* body{"chest"};
};

Overrides operator+(Overrides left, const Overrides& right) {
  left.insert(left.end(), right.begin(), right.end());
  return left;
}

Overrides GaitOf(const Walk& walk, double speed_mps) {
  char text[200];
  std::snprintf(text, sizeof text,
                "gait={type: walk, step_length_m: %.4f, step_width_m: %g, swing_s: %g, "
                "double_support_s: %g, swing_height_m: 0.03, landing_speed_mps: 0.02}",
                speed_mps * (walk.swing_s + walk.double_support_s), walk.width_m, walk.swing_s,
                walk.double_support_s);
  return {text, "expect={fall: false}"};
}

// Just after the left foot lifts off, in the middle of its swing, 50 ms before it lands, and in the
// middle of the double support after it.
std::array<double, 4> MomentsOf(const Overrides& overrides) {
  const Scenario scenario = ReadScenario(
      std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios" / (std::string(kScenario) + ".yaml"),
      overrides + Overrides{"pushes=[]", "duration_s=" + std::to_string(kUnpushed_s)});
  double lift_off_s = 0.0, landing_s = 0.0, next_s = 0.0;
  std::array<bool, 2> stood{};
  RunWatched(scenario, kUnpushed_s,
             [&](const SensorFrame& frame, Controller* controller,
                 const WorldTruth& /*truth*/) -> const ControlTick& {
               const ControlTick& tick = controller->Update(frame);
               const double now_s = SecondsAt(frame.tick, scenario.world.step_s);
               const std::array stands{tick.feet[0].planned_contact, tick.feet[1].planned_contact};
               if (now_s > kSteady_s && lift_off_s == 0.0) {
                 if (stood[0] && !stands[0]) lift_off_s = now_s;
               } else if (lift_off_s > 0.0 && landing_s == 0.0) {
                 if (!stood[0] && stands[0]) landing_s = now_s;
               } else if (landing_s > 0.0 && next_s == 0.0) {
                 if (stood[1] && !stands[1]) next_s = now_s;
               }
               stood = stands;
               return tick;
             });
  EXPECT_GT(next_s, 0.0) << "it does not walk";
  return {lift_off_s + 0.01, 0.5 * (lift_off_s + landing_s), landing_s - 0.05,
          0.5 * (landing_s + next_s)};
}

int CountSurvived(const Overrides& overrides, const Shove& shove) {
  int survived = 0;
  for (const double start_s : MomentsOf(overrides)) {
    for (int i = 0; i < kDirections; ++i) {
      const double direction_rad = shove.first_rad + 2.0 * std::numbers::pi * i / kDirections;
      const double force_N = shove.impulse * kMass_kg / shove.duration_s;
      char text[200];
      std::snprintf(text, sizeof text,
                    "pushes=[{body: %s, force_N: [%.5g, %.5g, 0], start_s: %.4f, duration_s: %g}]",
                    shove.body, force_N * std::cos(direction_rad),
                    force_N * std::sin(direction_rad), start_s, shove.duration_s);
      const std::string end_s = std::to_string(start_s + shove.duration_s + kAfter_s);
      const ClosedLoopRun run(kScenario, overrides + Overrides{text, "duration_s=" + end_s});
      survived += run.verdict.verdict_class == VerdictClass::kPass ? 1 : 0;
    }
  }
  return survived;
}

// Of 64: in place and at 0.2 m/s.
int CountOf64(const char* what, const Walk& walk, const Shove& shove, const Overrides& overrides) {
  const int in_place = CountSurvived(GaitOf(walk, 0.0) + overrides, shove);
  const int walking = CountSurvived(GaitOf(walk, 0.2) + overrides, shove);
  std::printf("  %s: %d in place, %d at 0.2 m/s\n", what, in_place, walking);
  std::fflush(stdout);
  return in_place + walking;
}

constexpr Walk kQuick{0.3, 0.05, 0.24}, kSlower{0.4, 0.1, 0.16};
constexpr Shove kHard{0.5, 0.1}, kLong{1.0, 1.0};
constexpr Shove kTurned{0.5, 0.1, std::numbers::pi / 8};

TEST(IcubShovesTest, StepAdjustmentSavesWhatFixedFootholdsLose) {
  EXPECT_GE(CountOf64("as shipped", kQuick, kHard, {}), 58);
  EXPECT_LE(CountOf64("fixed footholds", kQuick, kHard, kFixed), 16);
  CountOf64("by the clock", kQuick, kHard, kByTheClock);
}

TEST(IcubShovesTest, BetweenTheDirectionsItIsNoWeaker) {
  EXPECT_GE(CountOf64("turned", kQuick, kTurned, {}), 55);
  CountOf64("turned, by the clock", kQuick, kTurned, kByTheClock);
  CountOf64("turned, fixed footholds", kQuick, kTurned, kFixed);
}

TEST(IcubShovesTest, BearsASecondOfOneNewtonSecondAKilogram) {
  EXPECT_EQ(CountOf64("1 s, 0.77 N s/kg", kQuick, {0.77, 1.0}, {}), 64);
  EXPECT_GE(CountOf64("1 s, 1.0 N s/kg", kQuick, kLong, {}), 56);
  CountOf64("1 s, 1.3 N s/kg", kQuick, {1.3, 1.0}, {});
}

TEST(IcubShovesTest, BearsALighterShoveInEveryCell) {
  EXPECT_EQ(CountOf64("0.35 N s/kg", kQuick, {0.35, 0.1}, {}), 64);
}

// At least 0.8 of what the chest survives.
TEST(IcubShovesTest, BearsShovesElsewhere) {
  EXPECT_GE(CountOf64("base, 0.6 N s/kg", kQuick, {0.6, 0.1, 0.0, "root_link"}, {}), 47);
  EXPECT_GE(CountOf64("left hand, 0.5 N s/kg", kQuick, {0.5, 0.1, 0.0, "l_hand"}, {}), 47);
}

TEST(IcubShovesTest, StepsThatComeSoonerPayInASlowerGait) {
  const int in_time = CountOf64("as shipped", kSlower, kHard, {});
  EXPECT_GT(in_time, CountOf64("by the clock", kSlower, kHard, kByTheClock));
}

}  // namespace
}  // namespace sidestep
