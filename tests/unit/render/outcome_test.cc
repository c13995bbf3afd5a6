// SPDX-License-Identifier: BSD-3-Clause
#include "sim/render/outcome.h"

#include <gtest/gtest.h>

#include <limits>

#include "sim/render/caption_colors.h"

namespace sidestep::render::outcome_test {
namespace {

PushSummary PushRecoveredIn(double start_s, double recovery_s) {
  PushSummary push;
  push.start_s = start_s;
  push.duration_s = 0.5;
  push.recovered = true;
  push.recovery_time_s = recovery_s;
  return push;
}

RunSummary Standing() {
  RunSummary summary;
  summary.verdict = VerdictClass::kPass;
  summary.metrics = {{"fall", false}, {"fall_time_s", kNotTold}};
  summary.simulated_s = 8.0;
  return summary;
}

RunSummary Fallen(VerdictClass verdict) {
  RunSummary summary = Standing();
  summary.verdict = verdict;
  summary.metrics = {{"fall", true}, {"fall_time_s", 5.26}};
  summary.pushes = {PushRecoveredIn(2.0, 0.7)};  // from that one, before the fall
  return summary;
}

TEST(OutcomeTest, AFallIsToldFromItsMomentOnWhateverWasExpected) {
  const Outcome expected = OutcomeOf(Fallen(VerdictClass::kPass));
  EXPECT_EQ(expected.text, "fell at 5.3 s, as expected");
  EXPECT_EQ(expected.color, kFailRed) << "a PASS, but no robot on its feet";
  EXPECT_DOUBLE_EQ(expected.from_s, 5.26);
  EXPECT_EQ(OutcomeOf(Fallen(VerdictClass::kFail)).text, "fell at 5.3 s");
}

TEST(OutcomeTest, ARecoveryIsToldFromItsMomentOn) {
  RunSummary summary = Standing();
  summary.pushes = {PushRecoveredIn(2.0, 1.24)};
  const Outcome outcome = OutcomeOf(summary);
  EXPECT_EQ(outcome.text, "recovered 1.2 s after the push");
  EXPECT_EQ(outcome.color, kPassGreen);
  EXPECT_DOUBLE_EQ(outcome.from_s, 2.0 + 0.5 + 1.24);
  summary.pushes[0].recovery_time_s = 0.0;
  EXPECT_EQ(OutcomeOf(summary).text, "recovered at once");
}

TEST(OutcomeTest, OfManyPushesTheSlowestRecoveryIsToldOnceTheLastIsOver) {
  RunSummary summary = Standing();
  summary.pushes = {PushRecoveredIn(1.0, 1.5), PushRecoveredIn(4.0, 0.25)};
  const Outcome outcome = OutcomeOf(summary);
  EXPECT_EQ(outcome.text, "recovered within 1.5 s of each push");
  EXPECT_DOUBLE_EQ(outcome.from_s, 4.0 + 0.5 + 0.25);
}

TEST(OutcomeTest, ElseTheVerdictIsToldInTheLastSecond) {
  RunSummary summary = Standing();
  EXPECT_EQ(OutcomeOf(summary).text, "PASS: no fall");
  EXPECT_DOUBLE_EQ(OutcomeOf(summary).from_s, 7.0);
  summary.pushes = {PushRecoveredIn(2.0, std::numeric_limits<double>::infinity())};
  EXPECT_EQ(OutcomeOf(summary).text, "PASS: no fall") << "it has not recovered";
  summary.verdict = VerdictClass::kFail;
  summary.reasons = {{"SLIP", "left foot", 3.0}, {"SLIP", "right foot", 4.0}, {"SOLVER", "", {}}};
  summary.pushes = {PushRecoveredIn(2.0, 0.5)};
  EXPECT_EQ(OutcomeOf(summary).text, "FAIL SLIP SOLVER") << "a recovery is no excuse";
  EXPECT_EQ(OutcomeOf(summary).color, kFailRed);
}

TEST(OutcomeTest, AnInvalidRunSaysNothingOfTheRobot) {
  RunSummary summary = Fallen(VerdictClass::kInvalid);
  summary.reasons = {{"DIVERGED", "", {}}};
  EXPECT_EQ(OutcomeOf(summary).text, "INVALID DIVERGED");
  EXPECT_EQ(OutcomeOf(summary).color, kInvalidGrey);
}

TEST(OutcomeTest, ASummaryWithoutFiguresHasAnOutcomeFromTheStart) {
  const Outcome outcome = OutcomeOf(RunSummary());
  EXPECT_EQ(outcome.text, "INVALID");
  EXPECT_DOUBLE_EQ(outcome.from_s, 0.0);
}

}  // namespace
}  // namespace sidestep::render::outcome_test
