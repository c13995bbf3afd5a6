// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/write_scenarios.h"

#include <gtest/gtest.h>

namespace sidestep::importer {
namespace {

RobotDescription Shipped(const std::string& name) {
  return ReadRobotDescription(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "models" / name /
                              "robot.yaml");
}

TEST(WriteScenarios, AHumanoidStandsAsFarApartAsItStarts) {
  const auto texts = ScenariosOf(Shipped("g1"));
  ASSERT_EQ(texts.size(), 3U);
  EXPECT_NE(texts.at("g1_stand.yaml").find("step_width_m: 0.197"), std::string::npos);
  EXPECT_NE(texts.at("g1_push.yaml").find("body: pelvis"), std::string::npos);
}

TEST(WriteScenarios, OtherRobotsHaveNone) {
  for (const char* name : {"hopper", "rabbit", "biped", "two_legs"}) {
    EXPECT_TRUE(ScenariosOf(Shipped(name)).empty()) << name;
  }
}

}  // namespace
}  // namespace sidestep::importer
