// SPDX-License-Identifier: BSD-3-Clause
#include "sim/compare/fail_on.h"

#include <cmath>
#include <optional>

#include "models/support/config_error.h"
#include "models/support/parse_number.h"

namespace sidestep {

FailOn ParseFailOn(const std::string& text) {
  const auto fail = [&] {
    throw ConfigError("--fail-on " + text +
                      ": error: must read NAME>VALUE or NAME<VALUE, with a sign for a change and % "
                      "for one of A's size: drift_m>+10%");
  };
  const std::size_t at = text.find_first_of("<>");
  if (at == std::string::npos || at == 0) fail();
  FailOn condition{text, text.substr(0, at), text[at] == '>', 0.0, FailOn::Of::kValue};
  std::string value = text.substr(at + 1);
  const bool has_sign = value.starts_with("+") || value.starts_with("-");
  const bool is_percent = value.ends_with("%");
  if (has_sign) condition.of = is_percent ? FailOn::Of::kPercent : FailOn::Of::kChange;
  if (is_percent && !has_sign) fail();
  if (is_percent) value.pop_back();
  if (value.starts_with("+")) value.erase(0, 1);
  const std::optional<double> bound = ParseAs<double>(value);
  if (!bound || !std::isfinite(*bound)) fail();
  condition.bound = *bound;
  return condition;
}

bool Fails(const FailOn& condition, double first, double second) {
  constexpr double kWhole = 100.0;
  if (std::isnan(second)) return !std::isnan(first);
  double value = second;
  double bound = condition.bound;
  if (condition.of != FailOn::Of::kValue) {
    value = second == first ? 0.0 : second - first;  // two infinities are no change
    if (std::isnan(value)) return true;              // A told nothing: no change can be bounded
  }
  if (condition.of == FailOn::Of::kPercent) bound *= std::abs(first) / kWhole;
  return condition.is_above ? value > bound : value < bound;
}

}  // namespace sidestep
