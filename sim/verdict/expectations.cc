// SPDX-License-Identifier: BSD-3-Clause
#include "sim/verdict/expectations.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sidestep {
namespace {

std::string Text(double value) {
  if (std::isnan(value)) return "not measured";
  if (std::isinf(value)) return "never";
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string Text(bool value) { return value ? "true" : "false"; }

bool Meets(const Expectation& expectation, const MetricValue& measured) {
  const bool has_bound = expectation.min.has_value() || expectation.max.has_value();
  if (const bool* flag = std::get_if<bool>(&measured)) {
    return !has_bound && expectation.is.has_value() && *flag == *expectation.is;
  }
  const double value = std::get<double>(measured);
  if (expectation.is.has_value() || !has_bound) return false;
  // NaN compares false.
  return (!expectation.min || value >= *expectation.min) &&
         (!expectation.max || value <= *expectation.max);
}

}  // namespace

std::vector<ExpectationResult> CheckExpectations(const std::vector<Expectation>& expectations,
                                                 const Metrics& metrics) {
  std::vector<ExpectationResult> results;
  for (const Expectation& expectation : expectations) {
    ExpectationResult result{expectation, std::nullopt, false};
    const auto found = metrics.find(expectation.metric);
    if (found != metrics.end()) {
      result.measured = found->second;
      result.pass = Meets(expectation, found->second);
    }
    results.push_back(result);
  }
  return results;
}

bool Expects(const std::vector<Expectation>& expectations, const std::string& metric) {
  return std::any_of(expectations.begin(), expectations.end(), [&](const Expectation& one) {
    return one.metric == metric && one.is.value_or(false);
  });
}

std::string Describe(const ExpectationResult& result) {
  const Expectation& wanted = result.expectation;
  std::string text = wanted.metric;
  if (!result.measured) return text + " is no metric";
  text += " is " + std::visit([](auto value) { return Text(value); }, *result.measured);
  text += ", expected";
  if (wanted.is) return text + " " + Text(*wanted.is);
  if (wanted.min) text += " at least " + Text(*wanted.min);
  if (wanted.min && wanted.max) text += " and";
  if (wanted.max) text += " at most " + Text(*wanted.max);
  return text;
}

}  // namespace sidestep
