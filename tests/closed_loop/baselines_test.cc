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
  EXPECT_EQ(stays.verdict.verdict_class, VerdictClass::kFail) << stays.Describe();
}

}  // namespace
}  // namespace sidestep
