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
    return {"icub_torque_push", overrides};
  }
};

INSTANTIATE_TEST_SUITE_P(All, BaselinesTest, testing::Values("dcm_qp", "capture_point"),
                         [](const auto& stepping) { return stepping.param; });

TEST_P(BaselinesTest, WalksUnpushed) {
  const ClosedLoopRun run = Run({"pushes=[]"});
  EXPECT_EQ(run.verdict.verdict_class, VerdictClass::kPass) << run.Describe();
}

}  // namespace
}  // namespace sidestep
