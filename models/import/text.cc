// SPDX-License-Identifier: BSD-3-Clause
#include "models/import/text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace sidestep::importer {

double Rounded(double value, int digits) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  const double unit = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
  return std::round(value * unit) / unit;
}

std::string Figure(double value, int digits) {
  const double rounded = Rounded(value, digits);
  std::array<char, 400> text{};
  const double magnitude = std::abs(rounded);
  const bool is_plain = rounded == 0.0 || (magnitude >= 1e-6 && magnitude < 1e12);
  const auto format = is_plain ? std::chars_format::fixed : std::chars_format::scientific;
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), rounded == 0.0 ? 0.0 : rounded, format);
  return {text.data(), end};
}

std::string Listed(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 4;
  std::string text;
  const std::size_t shown = names.size() <= kShown + 1 ? names.size() : kShown;
  for (std::size_t i = 0; i < shown; ++i) {
    const bool is_last = i + 1 == names.size();
    text += (i == 0 ? "" : is_last ? " and " : ", ") + ("'" + names[i] + "'");
  }
  if (shown < names.size()) text += " and " + std::to_string(names.size() - shown) + " more";
  return text;
}

std::string XmlEscaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

}  // namespace sidestep::importer
