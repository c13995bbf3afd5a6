// SPDX-License-Identifier: BSD-3-Clause
// How many shoves humanoids survive: eight directions at four moments of a step, in place and at
// 0.2 m/s, as shipped, by the clock, and with fixed footholds; on servos pushes of a second.
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

constexpr int kDirections = 8;
constexpr double kSteady_s = 3.9;  // from here on moments are looked for
constexpr double kUnpushed_s = 6.5;
constexpr double kAfter_s = 4.0;
using Overrides = std::vector<std::string>;

const Overrides kByTheClock{"control.planner.timing.error_m=0"};
const Overrides kFixed{"control.planner.timing.error_m=0", "control.mpc.box_lower_m=[0, 0, 0]",
                       "control.mpc.box_upper_m=[0, 0, 0]"};
struct Robot {
  const char* scenario;  // of its own settings and sensors
  double mass_kg;
};

constexpr Robot kICub{"icub_torque_push", 52.4}, kOnServos{"icub_quick_push", 52.4},
    kHumanoid{"humanoid_torque_push", 60.0};

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
std::array<double, 4> MomentsOf(const Robot& robot, const Overrides& overrides) {
  const Scenario scenario =
      ReadScenario(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios" /
                       (std::string(robot.scenario) + ".yaml"),
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

// Of pushes: after which the verdict is a pass, and after which the robot stands but may have
// slipped.
struct Count {
  int passed{0};
  int stood{0};
};

// At the first `moments` of those.
Count CountSurvived(const Robot& robot, const Overrides& overrides, const Shove& shove,
                    std::size_t moments = 4) {
  Count count;
  const std::array<double, 4> starts_s = MomentsOf(robot, overrides);
  for (std::size_t moment = 0; moment < moments; ++moment) {
    const double start_s = starts_s[moment];
    for (int i = 0; i < kDirections; ++i) {
      const double direction_rad = shove.first_rad + 2.0 * std::numbers::pi * i / kDirections;
      const double force_N = shove.impulse * robot.mass_kg / shove.duration_s;
      char text[200];
      std::snprintf(text, sizeof text,
                    "pushes=[{body: %s, force_N: [%.5g, %.5g, 0], start_s: %.4f, duration_s: %g}]",
                    shove.body, force_N * std::cos(direction_rad),
                    force_N * std::sin(direction_rad), start_s, shove.duration_s);
      const std::string end_s = std::to_string(start_s + shove.duration_s + kAfter_s);
      const ClosedLoopRun run(robot.scenario, overrides + Overrides{text, "duration_s=" + end_s});
      count.passed += run.verdict.verdict_class == VerdictClass::kPass ? 1 : 0;
      count.stood += run.FailedBy(reason::kFall) ? 0 : 1;
    }
  }
  return count;
}

// Of 64: in place and at 0.2 m/s.
int CountOf64(const char* what, const Walk& walk, const Shove& shove, const Overrides& overrides,
              const Robot& robot = kICub) {
  const int in_place = CountSurvived(robot, GaitOf(walk, 0.0) + overrides, shove).passed;
  const int walking = CountSurvived(robot, GaitOf(walk, 0.2) + overrides, shove).passed;
  std::printf("  %s: %d in place, %d at 0.2 m/s\n", what, in_place, walking);
  std::fflush(stdout);
  return in_place + walking;
}

// Of 32: pushes of a second on servos, at chest and right hand, as the left foot lifts off and in
// the middle of its swing, at 0.2 m/s.
Count CountOf32(const char* what, double force_N, double first_rad, const Overrides& overrides) {
  constexpr Walk kWalk{0.4, 0.1, 0.24};
  Count all;
  for (const char* body : {"chest", "r_hand"}) {
    const Shove shove{force_N / kOnServos.mass_kg, 1.0, first_rad, body};
    const Count count = CountSurvived(kOnServos, GaitOf(kWalk, 0.2) + overrides, shove, 2);
    all.passed += count.passed;
    all.stood += count.stood;
  }
  std::printf("  %s, %g N: %d stand, %d of them within the slip allowed\n", what, force_N,
              all.stood, all.passed);
  std::fflush(stdout);
  return all;
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

TEST(ServoShovesTest, AQuickGaitStepsWhereFixedFootholdsFall) {
  const Overrides fixed{"control.mpc.box_lower_m=[0, 0, 0]", "control.mpc.box_upper_m=[0, 0, 0]",
                        "control.planner.follow=path"};
  const Overrides stiff{"control.inverse_kinematics.foot_moment_compliance_radps_per_Nm=0",
                        "control.inverse_kinematics.foot_load_compliance_mps_per_N=0",
                        "control.inverse_kinematics.swing_attitude_weight=0"};
  EXPECT_GE(CountOf32("as shipped", 60.0, 0.0, {}).stood, 28);
  EXPECT_GE(CountOf32("turned", 60.0, std::numbers::pi / 8, {}).stood, 28);
  CountOf32("fixed footholds", 60.0, 0.0, fixed);
  CountOf32("fixed footholds, stiff soles", 60.0, 0.0, fixed + stiff);
  const Count hard = CountOf32("as shipped", 80.0, 0.0, {});
  const Count hard_fixed = CountOf32("fixed footholds", 80.0, 0.0, fixed);
  EXPECT_GE(hard.stood, hard_fixed.stood + 8);
  EXPECT_GE(hard.passed, hard_fixed.passed + 8);
  EXPECT_GT(CountOf32("as shipped", 100.0, 0.0, {}).stood,
            CountOf32("fixed footholds", 100.0, 0.0, fixed).stood);
}

TEST(HumanoidShovesTest, BearsALighterShoveInEveryCell) {
  constexpr Walk kWalk{0.3, 0.05, 0.2};
  EXPECT_EQ(CountOf64("0.3 N s/kg", kWalk, {0.3, 0.1, 0.0, "chest_frame"}, {}, kHumanoid), 64);
  CountOf64("0.5 N s/kg", kWalk, {0.5, 0.1, 0.0, "chest_frame"}, {}, kHumanoid);
}

}  // namespace
}  // namespace sidestep
