// SPDX-License-Identifier: BSD-3-Clause
#include "sim/compare/compare_runs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <map>

#include "models/support/config_tree.h"
#include "sim/record/output_file.h"
#include "sim/record/run_reader.h"
#include "sim/record/run_summary.h"

namespace sidestep {
namespace {

using Settings = std::map<std::string, std::string>;

void Flatten(const ConfigTree& tree, const std::string& path, Settings* settings) {
  if (tree.children.empty()) {
    if (!path.empty()) (*settings)[path] = tree.kind == ConfigKind::kScalar ? tree.scalar : "";
    return;
  }
  for (std::size_t i = 0; i < tree.children.size(); ++i) {
    const std::string key = tree.kind == ConfigKind::kMap ? tree.keys[i].text : std::to_string(i);
    Flatten(tree.children[i], path.empty() ? key : path + "." + key, settings);
  }
}

Settings SettingsOf(const std::string& yaml) {
  Settings settings;
  Flatten(ParseConfig(yaml, ConfigSource{"scenario.yaml", false}), "", &settings);
  return settings;
}

struct SharedColumn {
  std::string name;
  std::size_t first;
  std::size_t second;
};

std::vector<SharedColumn> SharedColumns(const CsvTable& first, const CsvTable& second) {
  const std::vector<std::string>&a = first.header(), &b = second.header();
  std::vector<SharedColumn> shared;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto there = std::find(b.begin(), b.end(), a[i]);
    if (there == b.end() || a[i].starts_with("wall_")) continue;
    shared.push_back({a[i], i, static_cast<std::size_t>(there - b.begin())});
  }
  return shared;
}

bool IsSame(double first, double second) { return std::memcmp(&first, &second, sizeof first) == 0; }

// Bit for bit: a NaN is the same as itself, 0 is not -0. Both of one size.
template <typename Vector>
bool IsSame(const Vector& first, const Vector& second) {
  const auto bytes = static_cast<std::size_t>(first.size()) * sizeof(double);
  return std::memcmp(first.data(), second.data(), bytes) == 0;
}

// Of two logs of the same coordinates and feet; empty if the rows are the same.
std::string FirstDifference(const StateRow& a, const StateRow& b,
                            const std::vector<std::string>& feet) {
  if (!IsSame(a.time_s, b.time_s)) return "time_s";
  if (!IsSame(a.qpos, b.qpos)) return "qpos";
  if (!IsSame(a.push_force_W, b.push_force_W) || !IsSame(a.push_point_W, b.push_point_W)) {
    return "push";
  }
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const FootRow &one = a.feet[i], &other = b.feet[i];
    const bool is_same = IsSame(one.f_F_W, other.f_F_W) && IsSame(one.p_WF, other.p_WF) &&
                         IsSame(one.nominal_p_WF, other.nominal_p_WF) &&
                         IsSame(one.adjusted_p_WF, other.adjusted_p_WF);
    if (!is_same) return feet[i];
  }
  return {};
}

std::string PartText(const Divergence& at) {
  return "part at row " + std::to_string(at.row) + ", " + at.time_s + " s, " +
         (at.column.empty() ? "where one ends" : "in " + at.column);
}

double NumberOfMetric(const MetricValue& value) {
  if (const bool* truth = std::get_if<bool>(&value)) return *truth ? 1.0 : 0.0;
  return std::get<double>(value);
}

std::string Digits(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string MetricLine(const MetricPair& metric) {
  std::string line = "  " + metric.name + ": " + Digits("%.6g", metric.first) + " -> " +
                     Digits("%.6g", metric.second);
  const double change = metric.second - metric.first;
  if (!std::isfinite(change)) return line + "\n";
  line += "  (" + Digits("%+.4g", change);
  if (metric.first != 0.0)
    line += ", " + Digits("%+.1f", 100.0 * change / std::abs(metric.first)) + " %";
  return line + ")\n";
}

std::string Shown(const std::string& value) { return value.empty() ? "(none)" : value; }

}  // namespace

std::vector<SettingDifference> CompareSettings(const std::string& first,
                                               const std::string& second) {
  const Settings a = SettingsOf(first), b = SettingsOf(second);
  Settings keys = a;
  keys.insert(b.begin(), b.end());
  std::vector<SettingDifference> differences;
  for (const auto& [key, ignored] : keys) {
    const auto in_a = a.find(key), in_b = b.find(key);
    const std::string value_a = in_a == a.end() ? "" : in_a->second;
    const std::string value_b = in_b == b.end() ? "" : in_b->second;
    if (value_a != value_b) differences.push_back({key, value_a, value_b});
  }
  return differences;
}

std::optional<Divergence> CompareTrajectories(const CsvTable& first, const CsvTable& second) {
  const std::vector<SharedColumn> columns = SharedColumns(first, second);
  const std::size_t rows = std::min(first.num_rows(), second.num_rows());
  for (std::size_t row = 0; row < rows; ++row) {
    for (const SharedColumn& column : columns) {
      if (first.Cell(row, column.first) == second.Cell(row, column.second)) continue;
      return Divergence{row, std::string(first.Cell(row, 0)), column.name};
    }
  }
  if (first.num_rows() == second.num_rows()) return std::nullopt;
  const CsvTable& longer = first.num_rows() > rows ? first : second;
  return Divergence{rows, std::string(longer.Cell(rows, 0)), ""};
}

std::optional<Divergence> CompareStates(const StateLog& first, const StateLog& second) {
  const auto at = [&](std::size_t row, const std::string& what) {
    std::string time_s;
    AppendNumber(time_s, (row < first.rows.size() ? first : second).rows[row].time_s);
    return Divergence{row, time_s, what};
  };
  if (first.nq != second.nq || first.feet != second.feet) return at(0, "their robots");
  const std::size_t rows = std::min(first.rows.size(), second.rows.size());
  for (std::size_t row = 0; row < rows; ++row) {
    const std::string what = FirstDifference(first.rows[row], second.rows[row], first.feet);
    if (!what.empty()) return at(row, what);
  }
  if (first.rows.size() == second.rows.size()) return std::nullopt;
  return at(rows, "");
}

RunComparison CompareRuns(const std::filesystem::path& first, const std::filesystem::path& second) {
  const RunSummary a = ReadSummary(first), b = ReadSummary(second);
  RunComparison comparison;
  comparison.first_verdict = EnumName(a.verdict);
  comparison.second_verdict = EnumName(b.verdict);
  comparison.settings = CompareSettings(ReadWholeFile(first / "scenario.yaml"),
                                        ReadWholeFile(second / "scenario.yaml"));
  for (const auto& [name, value] : a.metrics) {
    const auto other = b.metrics.find(name);
    if (other == b.metrics.end()) continue;
    comparison.metrics.push_back({name, NumberOfMetric(value), NumberOfMetric(other->second)});
  }
  const auto both_have = [&](const char* file) {
    return std::filesystem::exists(first / file) && std::filesystem::exists(second / file);
  };
  comparison.first_log = a.log;
  comparison.second_log = b.log;
  comparison.has_trajectories = both_have("trajectory.csv");
  if (comparison.has_trajectories && a.log == b.log) {
    comparison.divergence = CompareTrajectories(ReadTrajectory(first), ReadTrajectory(second));
  }
  comparison.has_states = both_have("states.bin");
  if (comparison.has_states) {
    comparison.states_divergence = CompareStates(ReadStates(first), ReadStates(second));
  }
  return comparison;
}

std::string RunComparisonText(const RunComparison& comparison) {
  std::string text =
      "verdict: " + comparison.first_verdict + " -> " + comparison.second_verdict + "\n";
  text += "settings that differ: " + std::to_string(comparison.settings.size()) + "\n";
  for (const SettingDifference& one : comparison.settings) {
    text += "  " + one.key + ": " + Shown(one.first) + " -> " + Shown(one.second) + "\n";
  }
  std::string lines;
  std::size_t same = 0;
  for (const MetricPair& metric : comparison.metrics) {
    const bool is_same =
        metric.first == metric.second || (std::isnan(metric.first) && std::isnan(metric.second));
    if (is_same) {
      ++same;
    } else {
      lines += MetricLine(metric);
    }
  }
  text += "metrics: " + std::to_string(comparison.metrics.size() - same) + " differ, " +
          std::to_string(same) + " are the same\n" + lines;
  text += DivergenceText(comparison) + "\n";
  return comparison.has_states ? text + StatesText(comparison) + "\n" : text;
}

std::string DivergenceText(const RunComparison& comparison) {
  if (!comparison.has_trajectories) return "trajectories: not both are there";
  if (comparison.first_log != comparison.second_log) {
    return "trajectories: not compared, for one log is " +
           std::string(EnumName(comparison.first_log)) + " and the other " +
           std::string(EnumName(comparison.second_log));
  }
  if (comparison.divergence) return "trajectories: " + PartText(*comparison.divergence);
  const bool is_rounded = comparison.first_log == LogDetail::kNormal;
  return is_rounded ? "trajectories: the same in the rows and digits of their logs"
                    : "trajectories: the same";
}

std::string StatesText(const RunComparison& comparison) {
  if (!comparison.has_states) return {};
  if (!comparison.states_divergence) return "states: the same bit for bit";
  return "states: " + PartText(*comparison.states_divergence);
}

}  // namespace sidestep
