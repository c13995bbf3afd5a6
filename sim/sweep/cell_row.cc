// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/cell_row.h"

#include <unistd.h>

#include <algorithm>
#include <optional>
#include <type_traits>

#include "models/support/config_error.h"
#include "models/support/parse_number.h"
#include "sim/record/output_file.h"
#include "sim/sweep/csv_line.h"
#include "sim/verdict/metrics.h"

namespace sidestep {
namespace {

constexpr std::size_t kOfMachine = 3;  // cpu_s, wall_s, host, at the end

std::string CellText(double value) {
  std::string text;
  AppendNumber(text, value);
  return text;
}

std::string CellText(const Metrics& metrics, std::string_view name) {
  const auto found = metrics.find(std::string(name));
  if (found == metrics.end()) return "";
  if (const bool* truth = std::get_if<bool>(&found->second)) return *truth ? "true" : "false";
  return CellText(std::get<double>(found->second));
}

std::string HostName() {
  char name[256] = "";
  if (gethostname(name, sizeof name - 1) != 0) return "";
  return name;
}

}  // namespace

std::string_view CellRow::Repeatable() const {
  std::string_view text = line;  // no such column is ever quoted
  for (std::size_t i = 0; i < kOfMachine; ++i) text = text.substr(0, text.rfind(','));
  return text;
}

CellName NameOf(const CellKey& cell) { return {cell.ray, cell.strength, cell.seed}; }

std::string RowHeader(const SweepSpec& spec) {
  std::vector<std::string> names{"ray", "id", "controller"};
  for (const Axis& axis : spec.axes) names.push_back(axis.key);
  names.insert(names.end(), after_axes::kNames.begin(), after_axes::kNames.end());
  for (const MetricInfo& metric : KnownMetrics()) names.emplace_back(metric.name);
  for (const char* name : {"simulated_s", "cpu_s", "wall_s", "host"}) names.emplace_back(name);
  return CsvLine(names);
}

CellRow MakeRow(const SweepSpec& spec, const Ray& ray, const std::string& id, const CellKey& cell,
                const CellResult& result) {
  std::vector<std::string> cells{std::to_string(ray.index), id,
                                 spec.controllers[ray.controller].name};
  cells.insert(cells.end(), ray.values.begin(), ray.values.end());
  cells.insert(cells.end(), {cell.strength, std::string(EnumName(cell.stage)), cell.seed,
                             std::string(EnumName(result.outcome)), result.reasons,
                             CellText(result.impulse_Nspkg)});
  for (const MetricInfo& metric : KnownMetrics()) {
    cells.push_back(CellText(result.metrics, metric.name));
  }
  std::string host = HostName();
  std::replace(host.begin(), host.end(), ',', ' ');
  std::replace(host.begin(), host.end(), '"', ' ');
  cells.insert(cells.end(), {CellText(result.simulated_s), CellText(result.cpu_s),
                             CellText(result.wall_s), host});
  return {cell,          id, result.outcome, result.reasons, result.impulse_Nspkg, result.cpu_s,
          CsvLine(cells)};
}

CellRow ReadRow(const SweepSpec& spec, const std::string& line, const std::string& place) {
  const std::vector<std::string> cells = SplitCsvLine(line);
  const std::size_t after = kColumnsBeforeAxes + spec.axes.size();
  const std::size_t columns =
      after + after_axes::kNames.size() + KnownMetrics().size() + 1 + kOfMachine;
  if (cells.size() != columns) {
    throw ConfigError(place + ": error: is no row of this sweep: it has " +
                      std::to_string(cells.size()) + " columns, not " + std::to_string(columns));
  }
  const auto ray = ParseAs<std::size_t>(cells[0]);
  const auto stage = EnumOfName<SearchStage>(cells[after + after_axes::kStage]);
  const auto outcome = EnumOfName<CellOutcome>(cells[after + after_axes::kOutcome]);
  const auto impulse_Nspkg = ParseAs<double>(cells[after + after_axes::kImpulse]);
  const auto cpu_s = ParseAs<double>(cells[columns - kOfMachine]);
  if (!ray || !stage || !outcome || !impulse_Nspkg || !cpu_s) {
    throw ConfigError(place +
                      ": error: is no row of this sweep: a column is not what it should be");
  }
  CellRow row;
  row.cell = {*ray, cells[after + after_axes::kStrength], cells[after + after_axes::kSeed], *stage};
  row.id = cells[1];
  row.outcome = *outcome;
  row.reasons = cells[after + after_axes::kReasons];
  row.impulse_Nspkg = *impulse_Nspkg;
  row.cpu_s = *cpu_s;
  row.line = line;
  return row;
}

}  // namespace sidestep
