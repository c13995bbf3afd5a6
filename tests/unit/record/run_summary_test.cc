// SPDX-License-Identifier: BSD-3-Clause
// summary.json as a struct: what is written reads back, and is written again the same.
#include "sim/record/run_summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "sim/record/make_summary.h"
#include "tests/unit/record/record_test_support.h"

namespace sidestep::run_summary_test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

RunSummary Read(const std::string& text) { return ParseSummary(text, "summary.json"); }

std::string WrittenAgain(const std::string& text) { return SummaryJson(Read(text)); }

/// Every kind of value in every field, each distinct.
RunSummary FailedRun() {
  Scenario scenario = TwoFeetScenario();
  scenario.seed = 18446744073709551615U;  // no double holds it
  RunOutcome outcome;
  outcome.verdict.verdict_class = VerdictClass::kFail;
  for (const char* kind : {reason::kFall, reason::kSlip, reason::kSolver, reason::kExpectation,
                           reason::kDiverged, reason::kInterrupted, reason::kError}) {
    outcome.verdict.reasons.push_back({kind, std::string("it was ") + kind, 1.0 / 3.0});
  }
  outcome.verdict.reasons.push_back({reason::kExpectation, "a \"quote\"\nand é", std::nullopt});
  outcome.verdict.expectations = {{{"max_slip_m", 0.01, 0.05, {}}, 0.07, false},
                                  {{"recovery_time_s", {}, 2.0, {}}, kInfinity, false},
                                  {{"fall_time_s", 1.0, {}, {}}, kNaN, false},
                                  {{"unknown", 1.0, {}, {}}, std::nullopt, false},
                                  {{"fall", {}, {}, true}, true, true}};
  outcome.metrics = {{"energy_J", 1e300},  {"fall", true},        {"fall_time_s", kNaN},
                     {"max_slip_m", -0.0}, {"mpc_failures", 3.0}, {"recovery_time_s", kInfinity},
                     {"slip", false}};
  outcome.mass_kg = 3.0;
  outcome.pushes = {{scenario.pushes[0], {0.0, 3.0, 4.0}}, {scenario.pushes[1], {0.1, 0.2, 0.3}}};
  JointInfo knee{"knee"};
  knee.torque_limit_Nm = 40.0;
  outcome.joints = {{knee, 12.5, 3.5, 4.5}, {{"leg", true}, 60.0, 0.75}, {{"ankle"}, 0.1}};
  outcome.gaits.resize(2);
  outcome.gaits[0].gait.type = GaitType::kHop;
  outcome.gaits[0].figures = {3, 0.25, 1.25, 0.5, 0.35, 2.5, 0.45, 0.15, 0.65, 1.75};
  return MakeSummary(scenario, outcome,
                     {{"sidestep", "run", "a.yaml"},
                      {{30.0, 15.0}, {120.0, 60.0}},
                      {{1.0, 0.5}, {2.0, 1.0}, {6.0, 3.0}},
                      3.0,
                      {1.7, 0.75}});
}

RunSummary EmptyRun(VerdictClass verdict) {
  RunOutcome outcome;
  outcome.verdict.verdict_class = verdict;
  return MakeSummary(TwoFeetScenario(), outcome, {});
}

TEST(RunSummaryTest, WhatIsReadIsWrittenAgainAsTheSameText) {
  for (const RunSummary& summary :
       {FailedRun(), EmptyRun(VerdictClass::kPass), EmptyRun(VerdictClass::kInvalid)}) {
    const std::string text = SummaryJson(summary);
    EXPECT_EQ(WrittenAgain(text), text);
  }
}

TEST(RunSummaryTest, ReadingTakesEveryFieldFromTheText) {
  const RunSummary read = Read(SummaryJson(FailedRun()));
  EXPECT_EQ(read.name, "two feet");
  EXPECT_EQ(read.verdict, VerdictClass::kFail);
  EXPECT_EQ(read.seed, 18446744073709551615U);
  ASSERT_EQ(read.reasons.size(), 8U);
  EXPECT_EQ(read.reasons[1].kind, reason::kSlip);
  EXPECT_EQ(read.reasons[1].time_s, 1.0 / 3.0);
  EXPECT_EQ(read.reasons[7].text, "a \"quote\"\nand é");
  EXPECT_FALSE(read.reasons[7].time_s.has_value());
  ASSERT_EQ(read.expectations.size(), 5U);
  EXPECT_EQ(read.expectations[0].max, 0.05);
  EXPECT_EQ(read.expectations[0].measured, MetricValue(0.07));
  EXPECT_FALSE(read.expectations[0].is.has_value());
  EXPECT_EQ(read.expectations[4].measured, MetricValue(true));
  EXPECT_EQ(read.metrics.at("mpc_failures"), MetricValue(3.0));
  EXPECT_EQ(read.metrics.at("slip"), MetricValue(false));
  ASSERT_EQ(read.pushes.size(), 2U);
  EXPECT_EQ(read.pushes[0].body, "com");
  EXPECT_EQ(read.pushes[0].impulse_per_mass_mps, 5.0 / 3.0);
  EXPECT_EQ(read.solve_time.misses, 1);
  EXPECT_EQ(read.whole_body_time.mean_ms, 3.0);
  EXPECT_EQ(read.versions.front().first, "sidestep");
  EXPECT_EQ(read.versions.front().second, read.program_version);
  EXPECT_EQ(read.command, (std::vector<std::string>{"sidestep", "run", "a.yaml"}));
  EXPECT_EQ(read.real_time_factor, 3.0 / 1.7);
}

TEST(RunSummaryTest, JointsKeepTheOrderOfTheActuatorsAndTheirUnits) {
  const RunSummary read = Read(SummaryJson(FailedRun()));
  ASSERT_EQ(read.joints.size(), 3U);
  EXPECT_EQ(read.joints[0].name, "knee");
  EXPECT_FALSE(read.joints[0].is_slide);
  EXPECT_EQ(read.joints[0].limit_Nm, 40.0);
  EXPECT_EQ(read.joints[1].name, "leg");
  EXPECT_TRUE(read.joints[1].is_slide);
  EXPECT_EQ(read.joints[1].peak_Nm, 60.0);
  EXPECT_FALSE(read.joints[1].limit_Nm.has_value()) << "an infinite limit is none";
  EXPECT_EQ(read.joints[0].peak_speed_radps, 3.5);
  EXPECT_EQ(read.joints[0].speed_limit_radps, 4.5);
  EXPECT_EQ(read.joints[1].peak_speed_radps, 0.75);
  EXPECT_EQ(read.joints[2].name, "ankle") << "not the alphabet's order";
}

TEST(RunSummaryTest, WhatIsNotFiniteComesBackAsNaN) {
  const RunSummary read = Read(SummaryJson(FailedRun()));
  EXPECT_TRUE(std::isnan(std::get<double>(read.metrics.at("recovery_time_s"))));
  EXPECT_TRUE(std::isnan(std::get<double>(read.metrics.at("fall_time_s"))));
  EXPECT_TRUE(std::isnan(std::get<double>(read.expectations[1].measured)));
  EXPECT_TRUE(std::isnan(std::get<double>(read.expectations[3].measured)));
  EXPECT_TRUE(std::isnan(Read(SummaryJson(EmptyRun(VerdictClass::kPass))).solve_time.p50_ms));
}

// The file as users and scripts know it: names and order of keys are a promise.
constexpr const char* kPass = R"({
  "sidestep": "0.1.0",
  "name": "stand",
  "verdict": "PASS",
  "reasons": [],
  "expectations": [
    {
      "metric": "fall",
      "min": null,
      "max": null,
      "is": false,
      "measured": false,
      "pass": true
    }
  ],
  "metrics": {
    "fall": false,
    "recovery_time_s": null
  },
  "pushes": [
    {
      "body": "trunk",
      "start_s": 0.5,
      "duration_s": 0.1,
      "force_N": 40.0,
      "direction_rad": 1.5,
      "phase": 0.25,
      "impulse_Ns": 4.0,
      "impulse_per_mass_mps": 0.2,
      "outcome": "RECOVERED",
      "recovered": true,
      "recovery_time_s": 0.25,
      "peak_tilt_rad": 0.125,
      "steps_taken": 2,
      "max_step_adjustment_m": 0.0625,
      "drift_m": 0.5
    }
  ],
  "gaits": [
    {
      "type": "hop",
      "start_s": 0.0,
      "strides": 3,
      "from_s": 0.25,
      "to_s": 1.25,
      "speed_mps": 0.5,
      "step_length_m": 0.125,
      "step_frequency_hz": 4.0,
      "duty_factor": 0.75,
      "flight_fraction": 0.0,
      "cost_of_transport": null,
      "max_ground_force_ratio": 1.5
    }
  ],
  "joints": {
    "leg": {
      "peak_force_N": 60.0,
      "limit_N": null,
      "peak_speed_mps": 0.5
    },
    "knee": {
      "peak_torque_Nm": 12.5,
      "limit_Nm": 40.0,
      "peak_speed_radps": 2.5,
      "speed_limit_radps": null
    }
  },
  "solve_time_ms": {
    "mean": 6.0,
    "p50": 5.0,
    "p99": 9.0,
    "max": 9.5,
    "deadline": 50.0,
    "misses": 0,
    "count": 10
  },
  "solve_cpu_ms": {
    "mean": 3.0,
    "p50": 2.5,
    "p99": 4.5,
    "max": 4.75,
    "deadline": 50.0,
    "misses": 0,
    "count": 10
  },
  "whole_body_time_ms": {
    "mean": null,
    "p50": null,
    "p99": null,
    "max": null,
    "deadline": 2.0,
    "misses": 0,
    "count": 0
  },
  "whole_body_cpu_ms": {
    "mean": null,
    "p50": null,
    "p99": null,
    "max": null,
    "deadline": 2.0,
    "misses": 0,
    "count": 0
  },
  "versions": {
    "sidestep": "0.1.0",
    "mujoco": "2.2.2"
  },
  "seed": 1,
  "command": [
    "sidestep",
    "run"
  ],
  "overrides": [
    "--set seed=1"
  ],
  "scenario_hash": "0011223344556677",
  "model_hash": "",
  "log": "full",
  "simulated_s": 2.0,
  "wall_s": 0.5,
  "cpu_s": 0.25,
  "real_time_factor": 4.0,
  "cpu_real_time_factor": 8.0
}
)";

std::string Without(std::string text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  return text.erase(begin, text.find(to, begin) - begin);
}

TEST(RunSummaryTest, KeysAndTheirOrderAreThoseOfTheFile) { EXPECT_EQ(WrittenAgain(kPass), kPass); }

TEST(RunSummaryTest, FilesOfThePastAreReadWithoutWhatTheyLack) {
  std::string old = Without(kPass, "  \"joints\"", "  \"solve_time_ms\"");
  old = Without(old, "  \"solve_cpu_ms\"", "  \"versions\"");

  old = Without(old, "  \"overrides\"", "  \"simulated_s\"");
  old = Without(old, "  \"cpu_s\"", "  \"real_time_factor\"");
  old = Without(old, ",\n  \"cpu_real_time_factor\"", "\n}");
  old = Without(old, "    \"mean\"", "    \"p50\"");
  old = Without(old, "      \"force_N\"", "      \"impulse_Ns\"");
  old = Without(old, ",\n      \"outcome\"", "\n    }\n  ],\n  \"solve_time_ms\"");
  const RunSummary read = Read(old);
  EXPECT_TRUE(read.joints.empty());
  EXPECT_TRUE(read.gaits.empty());
  ASSERT_EQ(read.pushes.size(), 1U);
  EXPECT_FALSE(read.pushes[0].recovered);
  EXPECT_TRUE(std::isnan(read.pushes[0].recovery_time_s));
  EXPECT_EQ(read.pushes[0].impulse_per_mass_mps, 0.2);
  EXPECT_EQ(read.whole_body_time.count, 0);
  EXPECT_TRUE(std::isnan(read.solve_time.mean_ms));
  EXPECT_EQ(read.solve_time.p50_ms, 5.0);
  EXPECT_EQ(read.real_time_factor, 4.0);
  EXPECT_TRUE(std::isnan(read.cpu_s));
  EXPECT_TRUE(read.overrides.empty());
  EXPECT_EQ(read.scenario_hash, "");
}

TEST(RunSummaryTest, FilesOfTheFutureAreReadWithoutWhatIsUnknown) {
  std::string text = kPass;
  text.insert(1, R"("terrain": {"kind": [1, 2]}, )");
  EXPECT_EQ(WrittenAgain(text), kPass);
}

}  // namespace
}  // namespace sidestep::run_summary_test
