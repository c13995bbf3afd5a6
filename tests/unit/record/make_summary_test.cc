// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/make_summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "models/support/config_error.h"
#include "sim/process/process.h"
#include "tests/unit/record/record_test_support.h"

namespace sidestep::make_summary_test {
namespace {

nlohmann::json Summary(const RunOutcome& outcome, const RunFacts& facts = {}) {
  return nlohmann::json::parse(SummaryJson(MakeSummary(TwoFeetScenario(), outcome, facts)));
}

TEST(MakeSummaryTest, WhatIsNotFiniteIsNull) {
  RunOutcome outcome;
  outcome.metrics = {{"recovery_time_s", std::numeric_limits<double>::infinity()},
                     {"fall_time_s", std::numeric_limits<double>::quiet_NaN()},
                     {"energy_J", 0.1},
                     {"fall", false}};
  const nlohmann::json metrics = Summary(outcome).at("metrics");
  EXPECT_TRUE(metrics.at("recovery_time_s").is_null());
  EXPECT_TRUE(metrics.at("fall_time_s").is_null());
  EXPECT_EQ(metrics.at("energy_J"), 0.1);
  EXPECT_EQ(metrics.at("fall"), false);
}

TEST(MakeSummaryTest, TellsVerdictReasonsAndExpectations) {
  RunOutcome outcome;
  outcome.verdict.verdict_class = VerdictClass::kFail;
  outcome.verdict.reasons = {{reason::kFall, "it fell", 1.5},
                             {reason::kExpectation, "not met", std::nullopt}};
  outcome.verdict.expectations = {{{"max_slip_m", {}, 0.05, {}}, 0.07, false},
                                  {{"fall", {}, {}, true}, true, true}};
  const nlohmann::json summary = Summary(outcome);
  EXPECT_EQ(summary.at("verdict"), "FAIL");
  EXPECT_EQ(summary.at("reasons")[0],
            nlohmann::json::parse(R"({"class": "FALL", "text": "it fell", "time_s": 1.5})"));
  EXPECT_TRUE(summary.at("reasons")[1].at("time_s").is_null());
  EXPECT_EQ(summary.at("expectations")[0],
            nlohmann::json::parse(R"({"metric": "max_slip_m", "min": null, "max": 0.05,
                                      "is": null, "measured": 0.07, "pass": false})"));
  EXPECT_EQ(summary.at("expectations")[1].at("measured"), true);
}

TEST(MakeSummaryTest, PushesTellImpulseAndImpulseOverMass) {
  const Scenario scenario = TwoFeetScenario();
  RunOutcome outcome;
  outcome.mass_kg = 2.0;
  outcome.pushes = {{scenario.pushes[0], {0.0, 3.0, 4.0}}};
  const nlohmann::json push = Summary(outcome).at("pushes")[0];
  EXPECT_EQ(push.at("body"), "com");
  EXPECT_EQ(push.at("duration_s"), 0.05);
  EXPECT_EQ(push.at("impulse_Ns"), 5.0);
  EXPECT_EQ(push.at("impulse_per_mass_mps"), 2.5);
}

TEST(MakeSummaryTest, PushesTellWhetherAndHowTheRobotRecovered) {
  RunOutcome outcome;
  outcome.mass_kg = 2.0;
  outcome.pushes.resize(2);
  outcome.pushes[0].figures = {true, 0.75, 0.3, 4, 0.08, 0.02};
  const nlohmann::json pushes = Summary(outcome).at("pushes");
  EXPECT_EQ(pushes[0].at("recovered"), true);
  EXPECT_EQ(pushes[0].at("recovery_time_s"), 0.75);
  EXPECT_EQ(pushes[0].at("peak_tilt_rad"), 0.3);
  EXPECT_EQ(pushes[0].at("steps_taken"), 4);
  EXPECT_EQ(pushes[0].at("max_step_adjustment_m"), 0.08);
  EXPECT_EQ(pushes[0].at("drift_m"), 0.02);
  EXPECT_EQ(pushes[1].at("recovered"), false);
  EXPECT_TRUE(pushes[1].at("recovery_time_s").is_null()) << "never";
}

TEST(MakeSummaryTest, PushesTellForceDirectionAndTheirOwnOutcome) {
  RunOutcome outcome;
  outcome.mass_kg = 2.0;
  outcome.metrics = {{"fall_time_s", 4.5}};
  outcome.pushes.resize(4);
  for (std::size_t i = 0; i < 4; ++i) {
    outcome.pushes[i].push.start_s = 1.0 + static_cast<double>(i);  // at 1, 2, 3 and 4 s
    outcome.pushes[i].push.force_N = {0.0, -3.0, 4.0};
    outcome.pushes[i].impulse_W_Ns = {0.0, -0.3, 0.4};
  }
  outcome.pushes[0].figures.recovered = true;
  RunFacts facts;
  facts.simulated_s = 5.0;
  nlohmann::json pushes = Summary(outcome, facts).at("pushes");
  EXPECT_EQ(pushes[0].at("force_N"), 5.0);
  EXPECT_NEAR(pushes[0].at("direction_rad").get<double>(), -1.5708, 1e-4);
  EXPECT_EQ(pushes[0].at("outcome"), "RECOVERED");
  EXPECT_EQ(pushes[1].at("outcome"), "NOT_RECOVERED") << "the next push came first";
  EXPECT_EQ(pushes[3].at("outcome"), "FALL");
  facts.simulated_s = 3.5;
  outcome.metrics = {{"fall_time_s", 3.2}};
  pushes = Summary(outcome, facts).at("pushes");
  EXPECT_EQ(pushes[2].at("outcome"), "FALL");
  EXPECT_EQ(pushes[3].at("outcome"), "NOT_BEGUN");
}

TEST(MakeSummaryTest, GaitsTellWhatCameOfThem) {
  RunOutcome outcome;
  outcome.gaits.resize(2);
  outcome.gaits[1].gait.type = GaitType::kRun;
  outcome.gaits[1].gait.start_s = 1.5;
  outcome.gaits[1].figures = {7, 2.0, 4.5, 1.2, 0.4, 3.0, 0.3, 0.4, 0.6, 2.5};
  const nlohmann::json gaits = Summary(outcome).at("gaits");
  EXPECT_EQ(gaits[0].at("type"), "stand");
  EXPECT_EQ(gaits[0].at("strides"), 0);
  EXPECT_TRUE(gaits[0].at("speed_mps").is_null());
  EXPECT_EQ(gaits[1], nlohmann::json::parse(
                          R"({"type": "run", "start_s": 1.5, "strides": 7, "from_s": 2.0,
                              "to_s": 4.5, "speed_mps": 1.2, "step_length_m": 0.4,
                              "step_frequency_hz": 3.0, "duty_factor": 0.3, "flight_fraction": 0.4,
                              "cost_of_transport": 0.6, "max_ground_force_ratio": 2.5})"));
}

TEST(MakeSummaryTest, PercentilesAreSamplesAndMissesExceedTheDeadline) {
  std::vector<double> solve_ms;
  for (int i = 200; i >= 1; --i) solve_ms.push_back(i);
  const StageTimes times = StageTimesOf(solve_ms, 150.0);
  EXPECT_DOUBLE_EQ(times.mean_ms, 100.5);
  EXPECT_EQ(times.p50_ms, 100.0);
  EXPECT_EQ(times.p99_ms, 198.0);
  EXPECT_EQ(times.max_ms, 200.0);
  EXPECT_EQ(times.misses, 50);
  EXPECT_EQ(times.count, 200);
  EXPECT_EQ(StageTimesOf({7.0}, 10.0).p99_ms, 7.0);
}

TEST(MakeSummaryTest, RunWithoutASolveHasNoTimes) {
  const nlohmann::json times = Summary({}).at("solve_time_ms");
  EXPECT_TRUE(times.at("p50").is_null());
  EXPECT_EQ(times.at("count"), 0);
  EXPECT_EQ(times.at("deadline"), 100.0) << "10 solves a second by default";
}

TEST(MakeSummaryTest, WholeBodyTimesStandBesideTheMpcs) {
  RunFacts facts;
  facts.solves = {{30.0, 3.0}, {50.0, 5.0}};
  facts.whole_body = {{1.0, 0.5}, {2.0, 1.0}, {6.0, 1.5}};
  const nlohmann::json summary = Summary({}, facts);
  EXPECT_EQ(summary.at("solve_time_ms").at("mean"), 40.0);
  const nlohmann::json& times = summary.at("whole_body_time_ms");
  EXPECT_EQ(times.at("mean"), 3.0);
  EXPECT_EQ(times.at("p50"), 2.0);
  EXPECT_EQ(times.at("p99"), 6.0);
  EXPECT_EQ(times.at("max"), 6.0);
  EXPECT_EQ(times.at("deadline"), 2.0) << "500 control ticks a second";
  EXPECT_EQ(times.at("misses"), 1);
  EXPECT_EQ(summary.at("solve_cpu_ms").at("mean"), 4.0);
  EXPECT_EQ(summary.at("whole_body_cpu_ms").at("mean"), 1.0);
  EXPECT_EQ(summary.at("whole_body_cpu_ms").at("misses"), 0) << "the machine was busy";
}

TEST(MakeSummaryTest, JointsTellTheirPeaksBesideTheirLimits) {
  RunOutcome outcome;
  JointInfo knee{"knee"};
  knee.torque_limit_Nm = 40.0;
  outcome.joints = {{knee, 12.5, 3.0, 4.0}, {{"leg", true}, 60.0, 0.5}};
  const nlohmann::json joints = Summary(outcome).at("joints");
  EXPECT_EQ(joints.at("knee"), nlohmann::json::parse(R"({"peak_torque_Nm": 12.5, "limit_Nm": 40.0,
                                      "peak_speed_radps": 3.0, "speed_limit_radps": 4.0})"));
  EXPECT_EQ(joints.at("leg"), nlohmann::json::parse(R"({"peak_force_N": 60.0, "limit_N": null,
                                                        "peak_speed_mps": 0.5})"));
  EXPECT_EQ(Summary({}).at("joints"), nlohmann::json::object());
}

TEST(MakeSummaryTest, TellsHowTheRunWasMade) {
  const nlohmann::json summary =
      Summary({}, {{"sidestep", "run", "a\xff.yaml"}, {}, {}, 3.0, {1.5, 0.5}});
  EXPECT_EQ(summary.at("command")[1], "run");
  EXPECT_EQ(summary.at("real_time_factor"), 2.0);
  EXPECT_EQ(summary.at("cpu_real_time_factor"), 6.0);
  EXPECT_EQ(summary.at("seed"), 1);
  EXPECT_EQ(summary.at("sidestep"), summary.at("versions").at("sidestep"));
  for (const char* name : {"mujoco", "ipopt", "eigen", "compiler"}) {
    EXPECT_FALSE(summary.at("versions").at(name).get<std::string>().empty()) << name;
  }
}

TEST(MakeSummaryTest, TellsWhatWasOverridden) {
  Scenario scenario = TwoFeetScenario();
  scenario.overrides = {"--push com 5N@0deg 1s+1s", "seed=3"};
  EXPECT_EQ(MakeSummary(scenario, {}, {}).overrides,
            (std::vector<std::string>{"--push com 5N@0deg 1s+1s", "--set seed=3"}));
}

TEST(MakeSummaryTest, HashesTellScenariosAndModelsApart) {
  const RunSummary one = MakeSummary(TwoFeetScenario(), {}, {});
  EXPECT_EQ(MakeSummary(TwoFeetScenario(), {}, {}).scenario_hash, one.scenario_hash);
  EXPECT_EQ(one.model_hash, "") << "the centroidal plant has no MJCF";
  Scenario other = TwoFeetScenario();
  other.seed += 1;
  EXPECT_NE(MakeSummary(other, {}, {}).scenario_hash, one.scenario_hash);

  other.plant = Plant::kMujoco;
  other.robot.model = RobotModel();
  other.robot.model->simulated_mjcf = "<mujoco/>";
  const std::string hash = MakeSummary(other, {}, {}).model_hash;
  EXPECT_EQ(hash.size(), 16U);
  other.robot.model->simulated_mjcf = "<mujoco />";
  EXPECT_NE(MakeSummary(other, {}, {}).model_hash, hash) << "another robot";
}

// The commit that the sources stand at, in 12 digits or more; `unknown` if they are no clone or
// there is no git to ask.
std::string CommitOfSources() {
  const std::string sources = SIDESTEP_SOURCE_DIR;
  if (!std::filesystem::exists(sources + "/.git")) return "unknown";
  try {
    const ProcessResult git = RunProcess({"git", "-C", sources, "rev-parse", "--short=12", "HEAD"});
    return git.exit_code == 0 ? git.out.substr(0, git.out.find('\n')) : "unknown";
  } catch (const ConfigError&) {
    return "unknown";
  }
}

TEST(MakeSummaryTest, TellsTheCommitThatItWasBuiltFrom) {
  std::string commit = Summary({}).at("versions").at("git_commit");
  if (commit.ends_with("-dirty")) commit.resize(commit.size() - 6);
  EXPECT_EQ(commit, CommitOfSources()) << "or it was built before the last commit";
}

}  // namespace
}  // namespace sidestep::make_summary_test
