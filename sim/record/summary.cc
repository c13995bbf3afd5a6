// SPDX-License-Identifier: BSD-3-Clause
#include "sim/record/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

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

}  // namespace

SolveTimes SummariseSolveTimes(std::vector<double> solve_ms, double deadline_ms) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  if (solve_ms.empty()) return {kNaN, kNaN, kNaN, 0, 0};
  std::sort(solve_ms.begin(), solve_ms.end());
  const auto percentile = [&](double share) {
    const double rank = std::ceil(share * static_cast<double>(solve_ms.size()));
    return solve_ms[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
  };
  const auto misses =
      std::count_if(solve_ms.begin(), solve_ms.end(), [&](double ms) { return ms > deadline_ms; });
  return {percentile(0.5), percentile(0.99), solve_ms.back(), static_cast<int>(misses),
          static_cast<int>(solve_ms.size())};
}

std::string SummaryJson(const Scenario& scenario, const RunOutcome& outcome,
                        const RunFacts& facts) {
  const double deadline_ms = 1000.0 / scenario.control.mpc.rate_hz;
  const SolveTimes times = SummariseSolveTimes(facts.solve_ms, deadline_ms);
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
  summary["solve_time_ms"] = {{"p50", times.p50_ms},    {"p99", times.p99_ms},
                              {"max", times.max_ms},    {"deadline", deadline_ms},
                              {"misses", times.misses}, {"count", times.count}};
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
