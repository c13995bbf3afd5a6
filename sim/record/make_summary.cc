// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/make_summary.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "models/support/hash_text.h"
#include "sim/scenario/push_option.h"
#include "sim/scenario/resolve_pushes.h"
#include "sim/scenario/write_scenario.h"
#include "sim/world/world_model.h"

namespace sidestep {
namespace {

// When the robot fell, or nothing.
std::optional<double> FallTime_s(const RunOutcome& outcome) {
  const auto found = outcome.metrics.find("fall_time_s");
  const double* time_s =
      found == outcome.metrics.end() ? nullptr : std::get_if<double>(&found->second);
  return time_s != nullptr && std::isfinite(*time_s) ? std::optional(*time_s) : std::nullopt;
}

// What became of push number `index`: a fall before the next one is its own.
std::string OutcomeOf(const RunOutcome& outcome, std::size_t index, double simulated_s) {
  const PushRecord& record = outcome.pushes[index];
  if (record.push.start_s > simulated_s || record.impulse_W_Ns.isZero(0.0)) return "NOT_BEGUN";
  if (record.figures.recovered) return "RECOVERED";
  const std::optional<double> fall_s = FallTime_s(outcome);
  const bool is_last_before =
      fall_s && *fall_s >= record.push.start_s &&
      std::none_of(outcome.pushes.begin(), outcome.pushes.end(), [&](const PushRecord& other) {
        return other.push.start_s > record.push.start_s && other.push.start_s <= *fall_s;
      });
  return is_last_before ? "FALL" : "NOT_RECOVERED";
}

PushSummary SummaryOf(const PushRecord& record, double mass_kg) {
  PushSummary push;
  push.force_N = record.push.force_N.norm();
  if (!record.push.force_N.head<2>().isZero(0.0)) {
    push.direction_rad = std::atan2(record.push.force_N.y(), record.push.force_N.x());
  }
  push.body = record.push.body;
  push.start_s = record.push.start_s;
  push.duration_s = record.push.duration_s;
  push.impulse_Ns = record.impulse_W_Ns.norm();
  push.impulse_per_mass_mps = push.impulse_Ns / mass_kg;
  push.recovered = record.figures.recovered;
  push.recovery_time_s = record.figures.recovery_time_s;
  push.peak_tilt_rad = record.figures.peak_tilt_rad;
  push.steps_taken = record.figures.steps_taken;
  push.max_step_adjustment_m = record.figures.max_step_adjustment_m;
  push.drift_m = record.figures.drift_m;
  return push;
}

ExpectationSummary SummaryOf(const ExpectationResult& result) {
  const Expectation& wanted = result.expectation;
  return {wanted.metric,
          wanted.min,
          wanted.max,
          wanted.is,
          result.measured.value_or(MetricValue(kNotTold)),
          result.pass};
}

JointSummary SummaryOf(const JointRecord& record) {
  JointSummary joint{record.joint.name, record.joint.is_slide, record.peak_torque_Nm, {}};
  if (std::isfinite(record.joint.torque_limit_Nm)) joint.limit_Nm = record.joint.torque_limit_Nm;
  joint.peak_speed_radps = record.peak_speed_radps;
  if (std::isfinite(record.speed_limit_radps)) joint.speed_limit_radps = record.speed_limit_radps;
  return joint;
}

std::vector<double> Column(const std::vector<StageTime>& times, double StageTime::*clock) {
  std::vector<double> column;
  for (const StageTime& time : times) column.push_back(time.*clock);
  return column;
}

}  // namespace

StageTimes StageTimesOf(std::vector<double> times_ms, double deadline_ms) {
  StageTimes times;
  times.deadline_ms = deadline_ms;
  if (times_ms.empty()) return times;
  const auto count = static_cast<double>(times_ms.size());
  std::sort(times_ms.begin(), times_ms.end());
  const auto percentile = [&](double share) {
    const double rank = std::ceil(share * count);
    return times_ms[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
  };
  times.mean_ms = std::accumulate(times_ms.begin(), times_ms.end(), 0.0) / count;
  times.p50_ms = percentile(0.5);
  times.p99_ms = percentile(0.99);
  times.max_ms = times_ms.back();
  times.misses = static_cast<int>(
      std::count_if(times_ms.begin(), times_ms.end(), [&](double ms) { return ms > deadline_ms; }));
  times.count = static_cast<int>(times_ms.size());
  return times;
}

RunSummary MakeSummary(const Scenario& scenario, const RunOutcome& outcome, const RunFacts& facts) {
  RunSummary summary;
  summary.versions = Versions();
  summary.program_version = summary.versions.front().second;
  summary.name = scenario.name;
  summary.verdict = outcome.verdict.verdict_class;
  for (const Reason& reason : outcome.verdict.reasons) {
    summary.reasons.push_back({reason.kind, reason.text, reason.time_s});
  }
  for (const ExpectationResult& result : outcome.verdict.expectations) {
    summary.expectations.push_back(SummaryOf(result));
  }
  summary.metrics = outcome.metrics;
  for (std::size_t i = 0; i < outcome.pushes.size(); ++i) {
    PushSummary push = SummaryOf(outcome.pushes[i], outcome.mass_kg);
    push.phase = PhaseAt(scenario, push.start_s).value_or(kNotTold);
    push.outcome = OutcomeOf(outcome, i, facts.simulated_s);
    summary.pushes.push_back(std::move(push));
  }
  for (const GaitRecord& record : outcome.gaits) {
    summary.gaits.push_back({record.gait.type, record.gait.start_s, record.figures});
  }
  for (const JointRecord& record : outcome.joints) summary.joints.push_back(SummaryOf(record));
  const double mpc_period_ms = 1000.0 / scenario.control.mpc.rate_hz;
  const double control_period_ms = 1000.0 / scenario.control.rate_hz;
  summary.solve_time = StageTimesOf(Column(facts.solves, &StageTime::wall_ms), mpc_period_ms);
  summary.solve_cpu = StageTimesOf(Column(facts.solves, &StageTime::cpu_ms), mpc_period_ms);
  summary.whole_body_time =
      StageTimesOf(Column(facts.whole_body, &StageTime::wall_ms), control_period_ms);
  summary.whole_body_cpu =
      StageTimesOf(Column(facts.whole_body, &StageTime::cpu_ms), control_period_ms);
  summary.seed = scenario.seed;
  summary.command = facts.command;
  for (const std::string& text : scenario.overrides) {
    summary.overrides.push_back(text.starts_with(kPushOption) ? text : "--set " + text);
  }
  summary.scenario_hash = HashText(ResolvedYaml(scenario));
  if (scenario.plant == Plant::kMujoco) summary.model_hash = HashText(SimulatedMjcf(scenario));
  summary.log = facts.log;
  summary.simulated_s = facts.simulated_s;
  summary.wall_s = facts.took.wall_s;
  summary.cpu_s = facts.took.cpu_s;
  summary.real_time_factor = facts.simulated_s / facts.took.wall_s;
  summary.cpu_real_time_factor = facts.simulated_s / facts.took.cpu_s;
  return summary;
}

}  // namespace sidestep
