// SPDX-License-Identifier: BSD-3-Clause
// What `check` makes of a finished process and the summary it left.

#include "sim/check/outcome.h"

#include <gtest/gtest.h>

#include "tests/unit/check/check_test_support.h"

namespace sidestep::outcome_test {
namespace {

constexpr const char* kPassSummary = R"({"verdict": "PASS", "reasons": [], "real_time_factor": 1.5,
  "expectations": [{"metric": "fall", "min": null, "max": null, "is": false, "measured": false,
                    "pass": true},
                   {"metric": "max_step_adjustment_m", "min": 0.01, "max": null, "is": null,
                    "measured": 0.04321, "pass": true}]})";
constexpr const char* kFailSummary = R"({"verdict": "FAIL", "real_time_factor": 2,
  "reasons": [{"class": "FALL", "text": "base too low", "time_s": 1.2041},
              {"class": "EXPECTATION", "text": "fall is true", "time_s": null}],
  "expectations": [{"metric": "fall", "is": false, "measured": true, "pass": false}]})";

Outcome Read(const std::string& summary, int exit_code, const std::string& err = "") {
  const ScratchFolder folder;
  if (!summary.empty()) folder.Write("summary.json", summary);
  return ReadOutcome("push", "push.yaml", folder.path(), {exit_code, "", err}, 3.0);
}

TEST(ReadOutcomeTest, APassKeepsItsMeasuredValuesAndBounds) {
  const Outcome outcome = Read(kPassSummary, 0);
  EXPECT_EQ(outcome.run_class, RunClass::kPass);
  EXPECT_TRUE(outcome.reasons.empty());
  EXPECT_EQ(outcome.measured,
            (std::vector<std::string>{"fall = false (is false)",
                                      "max_step_adjustment_m = 0.04321 (min 0.01)"}));
  EXPECT_DOUBLE_EQ(outcome.real_time_factor, 1.5);
}

TEST(ReadOutcomeTest, AFailKeepsItsReasonsWithTheirTimes) {
  const Outcome outcome = Read(kFailSummary, 1);
  EXPECT_EQ(outcome.run_class, RunClass::kFail);
  EXPECT_EQ(outcome.reasons, (std::vector<std::string>{"FALL at 1.204 s: base too low",
                                                       "EXPECTATION: fall is true"}));
  EXPECT_EQ(outcome.measured, std::vector<std::string>{"fall = true (is false) missed"});
}

TEST(ReadOutcomeTest, ACrashIsInvalidAndQuotesTheLastWords) {
  const Outcome outcome = Read("", 128 + 11, "starting\nlast words\n");
  EXPECT_EQ(outcome.run_class, RunClass::kInvalid);
  ASSERT_EQ(outcome.reasons.size(), 1U);
  EXPECT_NE(outcome.reasons[0].find("signal 11"), std::string::npos) << outcome.reasons[0];
  EXPECT_NE(outcome.reasons[0].find(": last words"), std::string::npos) << outcome.reasons[0];
  EXPECT_EQ(outcome.error_output, "starting\nlast words");
}

TEST(ReadOutcomeTest, ASummaryThatContradictsTheExitCodeIsInvalid) {
  EXPECT_EQ(Read(kPassSummary, 1).run_class, RunClass::kInvalid);
  EXPECT_EQ(Read(kPassSummary, 3).run_class, RunClass::kInvalid);
  EXPECT_EQ(Read(kFailSummary, 0).run_class, RunClass::kInvalid);
}

TEST(ReadOutcomeTest, ABrokenOrAbsentSummaryIsNeverAPass) {
  for (const char* summary : {"", "{", "[]", "{}", R"({"verdict": 1})", R"({"verdict": "PASS"})",
                              R"({"verdict": "OK", "reasons": [], "expectations": []})"}) {
    EXPECT_EQ(Read(summary, 0).run_class, RunClass::kInvalid) << summary;
  }
}

TEST(ExitCodeTest, InvalidOutweighsFailAndFailOutweighsPass) {
  Outcome pass, fail, invalid;
  pass.run_class = RunClass::kPass;
  fail.run_class = RunClass::kFail;
  invalid.run_class = RunClass::kInvalid;
  EXPECT_EQ(ExitCodeOf({}), 0);
  EXPECT_EQ(ExitCodeOf({pass, pass}), 0);
  EXPECT_EQ(ExitCodeOf({pass, fail, pass}), 1);
  EXPECT_EQ(ExitCodeOf({invalid, fail, pass}), 3);
}

TEST(OutcomeTableTest, EveryScenarioHasOneAlignedRowAndTheLastLineCounts) {
  Outcome pass = Read(kPassSummary, 0);
  Outcome crash = Read("", 139, "a\nb");
  crash.name = "a_much_longer_name";
  const std::string table = OutcomeTable({pass, Read(kFailSummary, 1), crash}, 9.04);
  EXPECT_NE(table.find("PASS     push                   3.0  1.50x  fall = false"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("FALL at 1.204 s: base too low (and 1 more)\n"), std::string::npos) << table;
  EXPECT_NE(table.find("3 run in 9.0 s: 1 PASS, 1 FAIL, 1 INVALID\n"), std::string::npos) << table;
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 5);
}

}  // namespace
}  // namespace sidestep::outcome_test
