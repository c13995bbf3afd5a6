// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

namespace sidestep {
namespace {

using Json = nlohmann::ordered_json;

Json FromOptional(const auto& value) { return value ? Json(*value) : Json(nullptr); }

Json FromMetric(const MetricValue& value) {
  return std::visit([](auto held) { return Json(held); }, value);
}

Json ReasonsJson(const std::vector<Reason>& reasons) {
  Json list = Json::array();
  for (const Reason& reason : reasons) {
    list.push_back(
        {{"class", reason.kind}, {"text", reason.text}, {"time_s", FromOptional(reason.time_s)}});
  }
  return list;
}

Json ExpectationsJson(const std::vector<ExpectationResult>& results) {
  Json list = Json::array();
  for (const ExpectationResult& result : results) {
    const Expectation& wanted = result.expectation;
    list.push_back({{"metric", wanted.metric},
                    {"min", FromOptional(wanted.min)},
                    {"max", FromOptional(wanted.max)},
                    {"is", FromOptional(wanted.is)},
                    {"measured", result.measured ? FromMetric(*result.measured) : Json(nullptr)},
                    {"pass", result.pass}});
  }
  return list;
}

Json PushesJson(const RunOutcome& outcome) {
  Json list = Json::array();
  for (const PushRecord& record : outcome.pushes) {
    const double impulse_Ns = record.impulse_W_Ns.norm();
    list.push_back({{"body", record.push.body},
                    {"start_s", record.push.start_s},
                    {"duration_s", record.push.duration_s},
                    {"impulse_Ns", impulse_Ns},
                    {"impulse_per_mass_mps", impulse_Ns / outcome.mass_kg}});
  }
  return list;
}

Json JointsJson(const std::vector<JointRecord>& records) {
  Json joints = Json::object();
  for (const JointRecord& record : records) {
    const bool is_slide = record.joint.is_slide;
    joints[record.joint.name] = {
        {is_slide ? "peak_force_N" : "peak_torque_Nm", record.peak_torque_Nm},
        {is_slide ? "limit_N" : "limit_Nm", record.joint.torque_limit_Nm}};
  }
  return joints;
}

Json TimesJson(const std::vector<double>& times_ms, double deadline_ms) {
  const StageTimes times = Summarise(times_ms, deadline_ms);
  return {{"mean", times.mean_ms}, {"p50", times.p50_ms},     {"p99", times.p99_ms},
          {"max", times.max_ms},   {"deadline", deadline_ms}, {"misses", times.misses},
          {"count", times.count}};
}

}  // namespace

StageTimes Summarise(std::vector<double> times_ms, double deadline_ms) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  if (times_ms.empty()) return {kNaN, kNaN, kNaN, kNaN, 0, 0};
  const auto count = static_cast<double>(times_ms.size());
  std::sort(times_ms.begin(), times_ms.end());
  const auto percentile = [&](double share) {
    const double rank = std::ceil(share * count);
    return times_ms[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
  };
  const auto misses =
      std::count_if(times_ms.begin(), times_ms.end(), [&](double ms) { return ms > deadline_ms; });
  return {std::accumulate(times_ms.begin(), times_ms.end(), 0.0) / count,
          percentile(0.5),
          percentile(0.99),
          times_ms.back(),
          static_cast<int>(misses),
          static_cast<int>(times_ms.size())};
}

std::string SummaryJson(const Scenario& scenario, const RunOutcome& outcome,
                        const RunFacts& facts) {
  Json metrics = Json::object();
  for (const auto& [name, value] : outcome.metrics) metrics[name] = FromMetric(value);
  Json versions = Json::object();
  for (const auto& [name, version] : Versions()) versions[name] = version;

  Json summary;
  summary["sidestep"] = versions.at("sidestep");
  summary["name"] = scenario.name;
  summary["verdict"] = EnumName(outcome.verdict.verdict_class);
  summary["reasons"] = ReasonsJson(outcome.verdict.reasons);
  summary["expectations"] = ExpectationsJson(outcome.verdict.expectations);
  summary["metrics"] = metrics;
  summary["pushes"] = PushesJson(outcome);
  summary["joints"] = JointsJson(outcome.joints);
  summary["solve_time_ms"] = TimesJson(facts.solve_ms, 1000.0 / scenario.control.mpc.rate_hz);
  summary["whole_body_time_ms"] = TimesJson(facts.whole_body_ms, 1000.0 / scenario.control.rate_hz);
  summary["versions"] = versions;
  summary["seed"] = scenario.seed;
  summary["command"] = facts.command;
  summary["simulated_s"] = facts.simulated_s;
  summary["wall_s"] = facts.wall_s;
  summary["real_time_factor"] = facts.simulated_s / facts.wall_s;
  // The library writes null for NaN and infinity; bytes that are no UTF-8 (of argv) are replaced.
  return summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sidestep
