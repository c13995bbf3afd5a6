// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cstdio>

#include "sim/check/outcome.h"

namespace sidestep {
namespace {

using Row = std::array<std::string, 5>;

std::string Fixed(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// One line of text: line ends become spaces, so that a row stays a row.
std::string OneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return text;
}

// Why it did not pass; for a pass, what was measured.
std::string Remark(const Outcome& outcome) {
  if (outcome.verdict == VerdictClass::kPass || outcome.reasons.empty()) {
    std::string text;
    for (const std::string& value : outcome.measured) text += (text.empty() ? "" : "; ") + value;
    return OneLine(text);
  }
  std::string text = outcome.reasons.front();
  const std::size_t others = outcome.reasons.size() - 1;
  if (others > 0) text += " (and " + std::to_string(others) + " more)";
  return OneLine(text);
}

// "3 PASS, 1 FAIL, 0 INVALID".
std::string CountsText(const std::vector<Outcome>& outcomes) {
  std::string text;
  for (const auto& [verdict, name] : EnumNames<VerdictClass>::kNames) {
    const auto count =
        std::count_if(outcomes.begin(), outcomes.end(),
                      [value = verdict](const auto& one) { return one.verdict == value; });
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + std::string(name);
  }
  return text;
}

}  // namespace

std::string OutcomeTable(const std::vector<Outcome>& outcomes, double wall_s) {
  std::vector<Row> rows{{"verdict", "scenario", "wall_s", "speed", "reason or measured"}};
  for (const Outcome& outcome : outcomes) {
    const double speed = outcome.real_time_factor;
    rows.push_back({std::string(EnumName(outcome.verdict)), outcome.name,
                    Fixed("%.1f", outcome.wall_s), speed > 0.0 ? Fixed("%.2fx", speed) : "-",
                    Remark(outcome)});
  }
  std::array<std::size_t, 5> width{};
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  }
  std::string table;
  for (const Row& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      const std::string padding(width[i] - row[i].size(), ' ');
      const bool is_number = i == 2 || i == 3;
      table += (is_number ? padding + row[i] : row[i] + padding) + "  ";
    }
    table += row.back();
    table.erase(table.find_last_not_of(' ') + 1);
    table += "\n";
  }
  return table + std::to_string(outcomes.size()) + " run in " + Fixed("%.1f", wall_s) +
         " s: " + CountsText(outcomes) + "\n";
}

}  // namespace sidestep
