// SPDX-License-Identifier: BSD-3-Clause
// A summary.json that is none: one line of error with its place, whatever it holds.
#include <gtest/gtest.h>

#include <fstream>

#include "models/support/config_error.h"
#include "sim/record/make_summary.h"
#include "sim/record/run_summary.h"
#include "tests/unit/record/record_test_support.h"

namespace sidestep::broken_summary_test {
namespace {

std::string ErrorOf(const std::string& text) {
  try {
    ParseSummary(text, "run/summary.json");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

std::string WholeText() {
  const Scenario scenario = TwoFeetScenario();
  RunOutcome outcome;
  outcome.verdict.verdict_class = VerdictClass::kFail;
  outcome.verdict.reasons = {{reason::kFall, "it fell", 1.5}};
  outcome.verdict.expectations = {{{"fall", {}, {}, false}, true, false}};
  outcome.metrics = {{"fall", true}, {"energy_J", 2.5}};
  outcome.mass_kg = 2.0;
  outcome.pushes = {{scenario.pushes[0], {0.0, 3.0, 4.0}}};
  outcome.joints = {{{"knee"}, 12.5}};
  return SummaryJson(
      MakeSummary(scenario, outcome, {{"sidestep"}, {{3.0, 1.5}}, {{1.0, 0.5}}, 3.0, {1.5, 1.5}}));
}

/// The whole text with one piece of it replaced.
std::string With(const std::string& piece, const std::string& other) {
  std::string text = WholeText();
  const std::size_t at = text.find(piece);
  if (at == std::string::npos) ADD_FAILURE() << "no " << piece << " in " << text;
  return text.replace(at, piece.size(), other);
}

TEST(BrokenSummaryTest, WrongTypeIsNamedWithItsKey) {
  const std::string file = "run/summary.json: error: ";
  EXPECT_EQ(ErrorOf(WholeText()), "no error");
  EXPECT_EQ(ErrorOf(With("\"verdict\": \"FAIL\"", "\"verdict\": \"OK\"")),
            file + "verdict: expected PASS or FAIL or INVALID, got string");
  EXPECT_EQ(ErrorOf(With("\"verdict\": \"FAIL\"", "\"verdict\": 1")),
            file + "verdict: expected PASS or FAIL or INVALID, got number");
  EXPECT_EQ(ErrorOf(With("\"start_s\": 0.0", "\"start_s\": \"soon\"")),
            file + "pushes[0].start_s: expected a number or null, got string");
  EXPECT_EQ(ErrorOf(With("\"text\": \"it fell\"", "\"text\": null")),
            file + "reasons[0].text: expected a string, got null");
  EXPECT_EQ(ErrorOf(With("\"pass\": false", "\"pass\": 0")),
            file + "expectations[0].pass: expected true or false, got number");
  EXPECT_EQ(ErrorOf(With("\"energy_J\": 2.5", "\"energy_J\": [2.5]")),
            file + "metrics.energy_J: expected a number, true, false or null, got array");
  EXPECT_EQ(ErrorOf(With("\"peak_torque_Nm\": 12.5", "\"peak_torque_Nm\": {}")),
            file + "joints.knee.peak_torque_Nm: expected a number or null, got object");
  EXPECT_EQ(ErrorOf(With("\"seed\": 1", "\"seed\": -1")),
            file + "seed: expected a whole number from 0 to 2^64 - 1, got number");
  EXPECT_EQ(ErrorOf(With("\"count\": 1", "\"count\": 1e3")),
            file + "solve_time_ms.count: expected a count, got number");
  EXPECT_EQ(ErrorOf(With("\"count\": 1", "\"count\": 2147483648")),
            file + "solve_time_ms.count: expected a count, got number");
  EXPECT_EQ(ErrorOf(With("\"command\": [\n    \"sidestep\"\n  ]", "\"command\": \"sidestep\"")),
            file + "command: expected a list, got string");
}

TEST(BrokenSummaryTest, MissingKeyIsNamed) {
  EXPECT_EQ(ErrorOf("{}"), "run/summary.json: error: sidestep is missing");
  EXPECT_EQ(ErrorOf(With("\"duration_s\"", "\"duration\"")),
            "run/summary.json: error: pushes[0].duration_s is missing");
  EXPECT_EQ(ErrorOf(With("\"peak_torque_Nm\"", "\"peak\"")),
            "run/summary.json: error: joints.knee.peak_torque_Nm is missing");
}

TEST(BrokenSummaryTest, WhatIsNoObjectIsRefused) {
  EXPECT_EQ(ErrorOf("[1]"), "run/summary.json: error: the file: expected an object, got array");
  EXPECT_EQ(ErrorOf("null"), "run/summary.json: error: the file: expected an object, got null");
}

TEST(BrokenSummaryTest, BrokenJsonIsAnErrorWithLineAndColumn) {
  EXPECT_EQ(ErrorOf(""), "run/summary.json:1:1: error: the JSON breaks off here");
  EXPECT_EQ(ErrorOf("{\"name\": "), "run/summary.json:1:10: error: the JSON breaks off here");
  EXPECT_EQ(ErrorOf("{\n  \"name\": no\n}"),
            "run/summary.json:2:12: error: the JSON breaks off here");
  EXPECT_EQ(ErrorOf("{\"name\": \"\xff\"}"),
            "run/summary.json:1:11: error: the JSON breaks off here");
  EXPECT_EQ(ErrorOf("{\"wall_s\": 1e999}"),
            "run/summary.json: error: holds a number beyond the range of a double");
}

TEST(BrokenSummaryTest, EveryTruncationIsAnErrorOfOneLine) {
  const std::string whole = WholeText();
  const std::size_t end = whole.rfind('}');
  for (std::size_t size = 0; size <= end; ++size) {
    const std::string error = ErrorOf(whole.substr(0, size));
    EXPECT_EQ(error.find("run/summary.json:"), 0U) << size << ": " << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << size << ": " << error;
  }
}

TEST(BrokenSummaryTest, DeepNestingEndsInALineNotInACrash) {
  constexpr int kDepth = 100'000;
  std::string lists(kDepth, '[');
  std::string objects;
  for (int i = 0; i < kDepth; ++i) objects += "{\"a\":";
  const std::string closed = lists + std::string(kDepth, ']');
  const std::string error = "run/summary.json: error: is nested deeper than 32";
  EXPECT_EQ(ErrorOf(lists), error);
  EXPECT_EQ(ErrorOf(objects), error);
  EXPECT_EQ(ErrorOf(closed), error);
  EXPECT_EQ(ErrorOf(With("\"FAIL\"", closed)), error);
}

TEST(BrokenSummaryTest, AKeyOfTheFileCantBreakTheLineOrFloodIt) {
  const std::string error =
      ErrorOf(With("\"energy_J\": 2.5", "\"a\\nb" + std::string(1000, 'c') + "\": \"\""));
  EXPECT_EQ(error.find("run/summary.json: error: metrics.a?bccc"), 0U) << error;
  EXPECT_LT(error.size(), 200U);
}

using BrokenSummaryFileTest = RecordTest;

TEST_F(BrokenSummaryFileTest, TheFileIsNamedWithItsFolder) {
  const std::string name = (folder_ / "summary.json").string();
  const auto error = [&] {
    try {
      ReadSummary(folder_);
    } catch (const ConfigError& failure) {
      return std::string(failure.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(error(), name + ": error: can't be read");
  std::filesystem::create_directories(folder_);
  std::ofstream(folder_ / "summary.json") << "{}";
  EXPECT_EQ(error(), name + ": error: sidestep is missing");
  std::ofstream(folder_ / "summary.json") << WholeText();
  EXPECT_EQ(error(), "no error");
}

}  // namespace
}  // namespace sidestep::broken_summary_test
