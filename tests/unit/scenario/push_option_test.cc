// SPDX-License-Identifier: BSD-3-Clause
#include "sim/scenario/push_option.h"

#include <numbers>

#include "tests/unit/scenario/scenario_fixture.h"

namespace sidestep::push_option_test {
namespace {

class PushOptionTest : public ScenarioFixture {
 protected:
  /// The push that `text` appends to the valid scenario, which has two.
  Push Added(const std::string& text) const {
    const Scenario scenario = Read(valid_, {"--push " + text});
    EXPECT_EQ(scenario.pushes.size(), 3U) << "appended";
    return scenario.pushes.back();
  }
  std::string ErrorOfPush(const std::string& text) const {
    return ErrorIn(valid_, {"--push " + text});
  }
};

TEST_F(PushOptionTest, TellsBodySizeDirectionStartAndDuration) {
  const Push push = Added("foot 6N@90deg 2.5s+0.25s");
  EXPECT_EQ(push.body, "foot");
  EXPECT_NEAR(push.force_N.x(), 0.0, 1e-12);
  EXPECT_NEAR(push.force_N.y(), 6.0, 1e-12) << "90 degrees are to the left";
  EXPECT_EQ(push.frame, PushFrame::kHeading);
  EXPECT_EQ(push.start_s, 2.5);
  EXPECT_EQ(push.duration_s, 0.25);
}

TEST_F(PushOptionTest, SizesAndDirectionsHaveUnits) {
  const double newtons = Added("foot 0.5mg@0rad 1s+0.5s").force_N.x();
  const double impulse = Added("foot 0.5Ns/kg@0deg 1s+0.5s").force_N.x() * 0.5;
  EXPECT_NEAR(newtons / impulse, 9.81, 1e-9) << "0.5 m g over 0.5 m";
  EXPECT_NEAR(Added("foot 2N@-1.5rad 1s+1s").force_N.y(), -2.0 * std::sin(1.5), 1e-12);
}

TEST_F(PushOptionTest, AStartMayBeAPhaseWithFootAndTime) {
  const double first_s = Added("foot 2N@0deg mid_swing+0.1s").start_s;
  EXPECT_EQ(Added("foot 2N@0deg mid_swing:left+0.1s").start_s, first_s);
  const double later_s = Added("foot 2N@0deg mid_swing:left>3s+0.1s").start_s;
  EXPECT_GT(later_s, 3.0);
  EXPECT_LT(first_s, 3.0);
}

TEST_F(PushOptionTest, OverridesMayChangeIt) {
  const Scenario scenario =
      Read(valid_, {"--push foot 2N@0deg 1s+1s", "pushes.2.profile=half_sine"});
  EXPECT_EQ(scenario.pushes.at(2).profile, PushProfile::kHalfSine);
}

TEST_F(PushOptionTest, AScenarioWithoutPushesGetsOne) {
  const Scenario scenario =
      Read("sidestep: 1\nname: a\nrobot: mini\nduration_s: 6\n", {"--push foot 2N@0deg 1s+1s"});
  EXPECT_EQ(scenario.pushes.size(), 1U);
}

TEST_F(PushOptionTest, WhatIsNoPushIsToldTheForm) {
  for (const char* text :
       {"", "foot", "foot 6N 2s+1s", "foot 6@0deg 2s+1s", "foot 6N@0 2s+1s", "foot 6N@0deg 2s",
        "foot 6N@0deg 2+1s", "foot 6N@0deg 2s+1s more", "foot 6N@1.2.3deg 2s+1s"}) {
    EXPECT_EQ(ErrorOfPush(text),
              "--push '" + std::string(text) +
                  "': error: must read BODY SIZE@DIRECTION START+DURATION: 'r_hand 60N@90deg "
                  "9.5s+1s'; sizes in N, mg or Ns/kg, directions in deg or rad, a start by phase: "
                  "'mid_swing:left>5s'");
  }
  EXPECT_NE(ErrorOfPush(std::string(100'000, 'x')), "no error") << "and no overflow";
}

TEST_F(PushOptionTest, TheReadersErrorsNameTheOption) {
  EXPECT_TRUE(ErrorOfPush("hand 6N@0deg 2s+1s")
                  .starts_with("--push 'hand 6N@0deg 2s+1s': error: "
                               "pushes.2.body"))
      << ErrorOfPush("hand 6N@0deg 2s+1s");
  EXPECT_TRUE(ErrorOfPush("foot 6N@0deg noon+1s")
                  .starts_with("--push 'foot 6N@0deg noon+1s': "
                               "error: pushes.2.at_phase"));
}

}  // namespace
}  // namespace sidestep::push_option_test
