// SPDX-License-Identifier: BSD-3-Clause
#include "sim/limit/assume.h"

#include <gtest/gtest.h>

#include "tests/support/temp_folder.h"

namespace sidestep::limit::assume_test {
namespace {

std::string ErrorOf(const std::vector<std::string>& assignments) {
  return TempFolder().ErrorOf([&] { Assume(assignments, {}); });
}

TEST(AssumeTest, ReplacesWhatIsNamedAndNothingElse) {
  LimitParams params;
  params.swing_s = 0.7;
  const LimitParams assumed = Assume({"reach_m=0.3", "reach_m=0.6", "cop_inset_m=0.01"}, params);
  EXPECT_EQ(assumed.reach_m, 0.6);
  EXPECT_EQ(assumed.cop_inset_m, 0.01);
  EXPECT_EQ(assumed.swing_s, 0.7);
}

TEST(AssumeTest, MistakesAreToldWithTheOption) {
  EXPECT_EQ(ErrorOf({"reach_m"}), "--assume reach_m: error: must read key=value");
  EXPECT_EQ(ErrorOf({"reach_m=far"}),
            "--assume reach_m=far: error: reach_m = 'far' is not a number");
  EXPECT_EQ(ErrorOf({"reach_m=30"}),
            "--assume reach_m=30: error: reach_m = 30 violates 0 <= reach_m <= 2");
  EXPECT_EQ(ErrorOf({"swing_sped_mps=2"}),
            "--assume swing_sped_mps=2: error: swing_sped_mps is not a known key; did you mean "
            "'swing_speed_mps'?");
  EXPECT_EQ(ErrorOf({"farthest_m=0.05"}), "error: farthest_m = 0.05 is below nearest_m = 0.11");
}

}  // namespace
}  // namespace sidestep::limit::assume_test
