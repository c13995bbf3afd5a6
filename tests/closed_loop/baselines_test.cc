// SPDX-License-Identifier: BSD-3-Clause
// The baselines in the MPC's place: they walk, and recover from shoves that fixed footholds lose.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/closed_loop.h"

namespace sidestep {
namespace {

class BaselinesTest : public testing::TestWithParam<std::string> {
 protected:
  static ClosedLoopRun Run(std::vector<std::string> overrides) {
    overrides.push_back("control.stepping=" + GetParam());
    overrides.push_back(
        "expect={fall: false, gait_speed_mps: {min: 0.15}, wbc_failures: {max: 0}}");
    return ClosedLoopRun("icub_torque_push", overrides);
  }
};

INSTANTIATE_TEST_SUITE_P(All, BaselinesTest, testing::Values("dcm_qp", "capture_point"),
                         [](const auto& stepping) { return stepping.param; });

TEST_P(BaselinesTest, WalksUnpushed) {
  const ClosedLoopRun run = Run({"pushes=[]"});
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

/// 0.5 N s/kg to the left, under which fixed footholds fall.
const std::vector<std::string> kShove{
    "pushes=[{body: chest, impulse_Nspkg: 0.5, direction_rad: 1.5708, start_s: 5.3, duration_s: "
    "0.1}]"};

TEST(DcmQpTest, RecoversFromAShoveThatFixedFootholdsLose) {
  std::vector<std::string> overrides = kShove;
  overrides.insert(overrides.end(), {"control.stepping=dcm_qp", "expect={recovered: true}"});
  const ClosedLoopRun steps("icub_torque_push", overrides);
  EXPECT_EQ(steps.verdict.verdict_class, VerdictClass::kPass) << steps.Describe();
  overrides = kShove;
  overrides.insert(overrides.end(),
                   {"control.mpc.box_lower_m=[0, 0, 0]", "control.mpc.box_upper_m=[0, 0, 0]",
                    "control.planner.timing.error_m=0", "expect={recovered: true}"});
  const ClosedLoopRun stays("icub_torque_push", overrides);
  EXPECT_TRUE(stays.FailedBy(reason::kFall)) << stays.Describe();
}

// On its servos the iCub's quick walk is theirs too.
TEST_P(BaselinesTest, WalksOnServos) {
  const ClosedLoopRun run(
      "icub_quick_push",
      {"control.stepping=" + GetParam(), "pushes=[]", "duration_s=6",
       "expect={fall: false, gait_speed_mps: {min: 0.15}, wbc_failures: {max: 0}}"});
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

// A metre a second for a tenth of a second, nearly, forwards and to the left: on the plant that has
// no attitude, where spinning costs nothing, a robot that recovers must not have spun.
class CentroidalShoveTest : public testing::TestWithParam<const char*> {
 protected:
  static ClosedLoopRun Run(std::vector<std::string> overrides) {
    overrides.insert(
        overrides.end(),
        {"gait={type: walk, step_width_m: 0.2, swing_s: 0.35, double_support_s: 0.1, "
         "swing_height_m: 0.05, step_length_m: 0.1}",
         std::string("pushes=[{body: com, impulse_Nspkg: 0.9, at_phase: mid_swing, after_s: 2, "
                     "duration_s: 0.1, direction_rad: ") +
             GetParam() + "}]",
         "expect={recovered: true, max_angular_momentum_kgm2ps: {max: 0.3}}"});
    return ClosedLoopRun("two_legs", overrides);
  }
};

INSTANTIATE_TEST_SUITE_P(Directions, CentroidalShoveTest, testing::Values("0", "1.5708"),
                         [](const auto& direction) {
                           return std::string(direction.index == 0 ? "Forwards" : "ToTheLeft");
                         });

const std::vector<std::string> kFixedFootholds{"control.mpc.box_lower_m=[0, 0, 0]",
                                               "control.mpc.box_upper_m=[0, 0, 0]",
                                               "control.planner.timing.error_m=0"};

TEST_P(CentroidalShoveTest, TheBaselinesStepAndRecover) {
  for (const char* stepping : {"dcm_qp", "capture_point"}) {
    const ClosedLoopRun run = Run({std::string("control.stepping=") + stepping});
    EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << stepping << run.Describe();
  }
}

TEST_P(CentroidalShoveTest, WithTheirFootholdsFixedTheyDoNot) {
  for (const char* stepping : {"dcm_qp", "capture_point"}) {
    std::vector<std::string> overrides = kFixedFootholds;
    overrides.push_back(std::string("control.stepping=") + stepping);
    const ClosedLoopRun run = Run(overrides);
    EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kFail) << stepping;
    // It spins without bound; it need not fall, for nothing tilts on this plant.
    EXPECT_NE(run.Describe().find("EXPECTATION: recovered is false"), std::string::npos)
        << stepping << run.Describe();
  }
}

// The MPC's weight on the angular momentum keeps it from spinning, as a robot's trunk would.
TEST_P(CentroidalShoveTest, TheMpcFallsWithFixedFootholdsIfItMayNotSpin) {
  std::vector<std::string> overrides = kFixedFootholds;
  overrides.push_back("control.mpc.weights.angular_momentum=[1e5, 1e5, 1e5]");
  const ClosedLoopRun run = Run(overrides);
  EXPECT_TRUE(run.FailedBy(reason::kFall)) << run.Describe();
}

// The same, of the MPC as it ships: footholds that stay don't bear at 1.7 N s/kg what a step does.
TEST(CentroidalBaselineTest, TheQpRecoversFromAShoveThatTheMpcWithFixedFootholdsIsLostAt) {
  const std::vector<std::string> shove{
      "control.rate_hz=500", "duration_s=8",
      "gait=[{type: stand}, {type: walk, start_s: 1, step_length_m: 0.11, swing_s: 0.4, "
      "double_support_s: 0.1}]",
      "pushes=[{body: com, at_phase: mid_swing, after_s: 2, duration_s: 0.1, impulse_Nspkg: 1.7, "
      "direction_rad: 1.5708}]",
      "expect={recovered: true}"};
  std::vector<std::string> stepping = shove, fixed = shove;
  stepping.push_back("control.stepping=dcm_qp");
  fixed.insert(fixed.end(), kFixedFootholds.begin(), kFixedFootholds.end());
  const ClosedLoopRun by_qp("two_legs", stepping), by_mpc("two_legs", fixed);
  EXPECT_EQ(by_qp.verdict.verdict_class, VerdictClass::kPass) << by_qp.Describe();
  EXPECT_TRUE(by_mpc.FailedBy(reason::kFall)) << by_mpc.Describe();
}

}  // namespace
}  // namespace sidestep
