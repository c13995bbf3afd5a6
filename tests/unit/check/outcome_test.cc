// SPDX-License-Identifier: BSD-3-Clause
// What `check` makes of a finished process and the summary it left.

#include "sim/check/outcome.h"

#include <gtest/gtest.h>

#include "tests/unit/check/check_test_support.h"

namespace sidestep::outcome_test {
namespace {

std::string PassSummary() {
  RunSummary summary;
  summary.verdict = VerdictClass::kPass;
  summary.expectations = {{"fall", {}, {}, false, false, true},
                          {"max_step_adjustment_m", 0.01, {}, {}, 0.04321, true}};
  summary.cpu_real_time_factor = 1.5;
  return SummaryJson(summary);
}

std::string FailSummary() {
  RunSummary summary;
  summary.verdict = VerdictClass::kFail;
  summary.reasons = {{"FALL", "base too low", 1.2041}, {"EXPECTATION", "fall is true", {}}};
  summary.expectations = {{"fall", {}, {}, false, true, false},
                          {"recovery_time_s", 0.5, 2.0, {}, kNotTold, false}};
  return SummaryJson(summary);
}

Outcome Read(const std::string& summary, int exit_code, const std::string& err = "") {
  const ScratchFolder folder;
  if (!summary.empty()) folder.Write("summary.json", summary);
  return ReadOutcome("push", "push.yaml", folder.path(), {exit_code, "", err}, 3.0);
}

TEST(ReadOutcomeTest, APassKeepsItsMeasuredValuesAndBounds) {
  const Outcome outcome = Read(PassSummary(), 0);
  EXPECT_EQ(outcome.verdict, VerdictClass::kPass);
  EXPECT_TRUE(outcome.reasons.empty());
  EXPECT_EQ(outcome.measured,
            (std::vector<std::string>{"fall = false (is false)",
                                      "max_step_adjustment_m = 0.04321 (min 0.01)"}));
  EXPECT_DOUBLE_EQ(outcome.real_time_factor, 1.5);
}

TEST(ReadOutcomeTest, AFailKeepsItsReasonsWithTheirTimes) {
  const Outcome outcome = Read(FailSummary(), 1);
  EXPECT_EQ(outcome.verdict, VerdictClass::kFail);
  EXPECT_EQ(outcome.reasons, (std::vector<std::string>{"FALL at 1.204 s: base too low",
                                                       "EXPECTATION: fall is true"}));
  EXPECT_EQ(outcome.measured,
            (std::vector<std::string>{"fall = true (is false) missed",
                                      "recovery_time_s = null (min 0.5, max 2) missed"}));
  EXPECT_EQ(outcome.real_time_factor, 0.0) << "not told";
}

TEST(ReadOutcomeTest, ACrashIsInvalidAndQuotesTheLastWords) {
  const Outcome outcome = Read("", 128 + 11, "starting\nlast words\n");
  EXPECT_EQ(outcome.verdict, VerdictClass::kInvalid);
  ASSERT_EQ(outcome.reasons.size(), 1U);
  EXPECT_NE(outcome.reasons[0].find("signal 11"), std::string::npos) << outcome.reasons[0];
  EXPECT_NE(outcome.reasons[0].find(": last words"), std::string::npos) << outcome.reasons[0];
  EXPECT_EQ(outcome.error_output, "starting\nlast words");
}

TEST(ReadOutcomeTest, ASummaryThatContradictsTheExitCodeIsInvalid) {
  EXPECT_EQ(Read(PassSummary(), 1).verdict, VerdictClass::kInvalid);
  EXPECT_EQ(Read(PassSummary(), 3).verdict, VerdictClass::kInvalid);
  EXPECT_EQ(Read(FailSummary(), 0).verdict, VerdictClass::kInvalid);
}

TEST(ReadOutcomeTest, ABrokenOrAbsentSummaryIsNeverAPass) {
  std::string half = PassSummary();
  half.resize(half.size() / 2);
  std::string other_verdict = PassSummary();
  other_verdict.replace(other_verdict.find("PASS"), 4, "OK");
  ASSERT_EQ(Read(BareSummary(VerdictClass::kPass), 0).verdict, VerdictClass::kPass);
  for (const std::string& summary :
       {std::string(), std::string("{"), std::string("[]"), std::string("{}"), half, other_verdict,
        std::string(R"({"verdict": "PASS"})"), std::string(100'000, '[')}) {
    const Outcome outcome = Read(summary, 0);
    EXPECT_EQ(outcome.verdict, VerdictClass::kInvalid) << summary.substr(0, 40);
    ASSERT_EQ(outcome.reasons.size(), 1U);
    EXPECT_NE(outcome.reasons[0].find("left no whole summary ("), std::string::npos);
    EXPECT_NE(outcome.reasons[0].find("summary.json"), std::string::npos) << "it names the file";
  }
}

TEST(ExitCodeTest, InvalidOutweighsFailAndFailOutweighsPass) {
  Outcome pass, fail, invalid;
  pass.verdict = VerdictClass::kPass;
  fail.verdict = VerdictClass::kFail;
  invalid.verdict = VerdictClass::kInvalid;
  EXPECT_EQ(ExitCodeOf({}), 0);
  EXPECT_EQ(ExitCodeOf({pass, pass}), 0);
  EXPECT_EQ(ExitCodeOf({pass, fail, pass}), 1);
  EXPECT_EQ(ExitCodeOf({invalid, fail, pass}), 3);
}

TEST(OutcomeTableTest, EveryScenarioHasOneAlignedRowAndTheLastLineCounts) {
  Outcome pass = Read(PassSummary(), 0);
  Outcome crash = Read("", 139, "a\nb");
  crash.name = "a_much_longer_name";
  const std::string table = OutcomeTable({pass, Read(FailSummary(), 1), crash}, 9.04);
  EXPECT_NE(table.find("PASS     push                   3.0  1.50x  fall = false"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("FALL at 1.204 s: base too low (and 1 more)\n"), std::string::npos) << table;
  EXPECT_NE(table.find("3 run in 9.0 s: 1 PASS, 1 FAIL, 1 INVALID\n"), std::string::npos) << table;
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5);
}

}  // namespace
}  // namespace sidestep::outcome_test
