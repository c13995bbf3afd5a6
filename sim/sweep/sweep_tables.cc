// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/sweep_tables.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "models/support/config_node.h"
#include "sim/record/output_file.h"
#include "sim/sweep/csv_line.h"
#include "sim/sweep/wilson.h"

namespace sidestep {
namespace {

constexpr std::size_t kMostLines = 40;  // of rays on the screen
constexpr double kSecondsPerHour = 3600.0;

using Cells = std::vector<std::string>;

std::string FigureText(double value) {
  std::string text;
  AppendNumber(text, value);
  return text;
}

std::string Short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

Cells RayNames(const SweepSpec& spec) {
  Cells names{"ray", "id", "controller"};
  for (const Axis& axis : spec.axes) names.push_back(axis.key);
  return names;
}

Cells RayCells(const SweepPlan& plan, const PlannedRay& planned) {
  Cells cells{std::to_string(planned.ray.index), planned.id,
              plan.spec.controllers[planned.ray.controller].name};
  cells.insert(cells.end(), planned.ray.values.begin(), planned.ray.values.end());
  return cells;
}

struct Counts {
  int runs{0}, recovered{0}, lost{0}, invalid{0};

  void Add(const CellRow& row) {
    ++runs;
    recovered += row.outcome == CellOutcome::kRecovered ? 1 : 0;
    lost += row.outcome == CellOutcome::kLost ? 1 : 0;
    invalid += row.outcome == CellOutcome::kInvalid ? 1 : 0;
  }
  void AppendTo(Cells* cells) const {
    const RateInterval rate = WilsonInterval(recovered, recovered + lost);
    for (const int count : {runs, recovered, lost, invalid})
      cells->push_back(std::to_string(count));
    const double share = static_cast<double>(recovered) / (recovered + lost);  // NaN of none
    for (const double value : {share, rate.lower, rate.upper}) cells->push_back(FigureText(value));
  }
  static void AppendNames(Cells* names) {
    for (const char* name :
         {"runs", "recovered", "lost", "invalid", "rate", "rate_lower", "rate_upper"}) {
      names->emplace_back(name);
    }
  }
};

// The impulse of the runs with this strength; 0 of strength 0, infinite of an infinite one.
double ImpulseAt_Nspkg(const RayResult& result, double strength) {
  for (const CellRow* cell : result.cells) {
    if (cell->cell.strength == NumberText(strength)) return cell->impulse_Nspkg;
  }
  return strength;
}

// What lost the smallest strength that was lost, or made the first run INVALID.
const CellRow* Culprit(const RayResult& result, double lost) {
  const bool has_limit = std::isfinite(lost);
  for (const CellRow* cell : result.cells) {
    const bool is_there =
        !has_limit || cell->cell.strength.empty() || cell->cell.strength == NumberText(lost);
    const bool is_bad =
        has_limit ? cell->outcome == CellOutcome::kLost : cell->outcome != CellOutcome::kRecovered;
    if (is_there && is_bad) return cell;
  }
  return nullptr;
}

std::string RayLine(const SweepPlan& plan, const RayResult& result) {
  const PlannedRay& planned = plan.rays[result.ray];
  std::string line = "  " + plan.spec.controllers[planned.ray.controller].name;
  for (std::size_t i = 0; i < plan.spec.axes.size(); ++i) {
    const auto number = ParseNumber(planned.ray.values[i]);
    line += "  " + plan.spec.axes[i].key + "=" + (number ? Short(*number) : planned.ray.values[i]);
  }
  Counts counts;
  for (const CellRow* cell : result.cells) counts.Add(*cell);
  const Bracket bracket = BracketOf(result.search.tested);
  if (plan.spec.limit) {
    line += "  [" + Short(bracket.survived) + ", " + Short(bracket.lost) + ")  " +
            Short(ImpulseAt_Nspkg(result, bracket.survived)) + " N s/kg  ladder " +
            Short(100.0 * bracket.ladder_share) + " %";
  } else {
    line += "  recovered " + std::to_string(counts.recovered) + "/" + std::to_string(counts.runs);
  }
  if (counts.invalid > 0) line += "  " + std::to_string(counts.invalid) + " INVALID";
  const CellRow* culprit = Culprit(result, bracket.lost);
  if (culprit != nullptr) line += "  " + culprit->reasons.substr(0, culprit->reasons.find(';'));
  return line + "\n";
}

std::string ControllerLine(const SweepPlan& plan, const std::vector<RayResult>& results,
                           std::size_t controller) {
  double sum = 0.0;
  double least = std::numeric_limits<double>::infinity(), greatest = 0.0;
  int rays = 0;
  std::size_t worst = 0;
  Counts counts;
  for (const RayResult& result : results) {
    if (plan.rays[result.ray].ray.controller != controller) continue;
    for (const CellRow* cell : result.cells) counts.Add(*cell);
    const Bracket bracket = BracketOf(result.search.tested);
    const double limit = ImpulseAt_Nspkg(result, bracket.survived);
    if (limit < least) worst = result.ray;
    least = std::min(least, limit);
    greatest = std::max(greatest, limit);
    sum += limit;
    ++rays;
  }
  std::string line = plan.spec.controllers[controller].name + ": " +
                     std::to_string(counts.recovered) + " of " + std::to_string(counts.runs) +
                     " runs recovered, " + std::to_string(counts.lost) + " lost, " +
                     std::to_string(counts.invalid) + " INVALID";
  if (plan.spec.limit && rays > 0) {
    line += "; limit min " + Short(least) + ", mean " + Short(sum / rays) + ", max " +
            Short(greatest) + " N s/kg; worst ray " + std::to_string(worst);
  }
  return line + "\n";
}

}  // namespace

std::string CellsCsv(const SweepPlan& plan, const std::vector<RayResult>& results) {
  std::string text = RowHeader(plan.spec) + "\n";
  for (const RayResult& result : results) {
    for (const CellRow* cell : result.cells) text += cell->line + "\n";
  }
  return text;
}

std::string StrengthsCsv(const SweepPlan& plan, const std::vector<RayResult>& results) {
  Cells names = RayNames(plan.spec);
  for (const char* name : {"strength", "stage", "impulse_Nspkg"}) names.emplace_back(name);
  Counts::AppendNames(&names);
  std::string text = CsvLine(names) + "\n";
  for (const RayResult& result : results) {
    for (std::size_t i = 0; i < result.cells.size();) {
      const CellKey& first = result.cells[i]->cell;
      Cells cells = RayCells(plan, plan.rays[result.ray]);
      cells.insert(cells.end(), {first.strength, std::string(EnumName(first.stage)),
                                 FigureText(result.cells[i]->impulse_Nspkg)});
      Counts counts;
      for (; i < result.cells.size() && result.cells[i]->cell.strength == first.strength; ++i) {
        counts.Add(*result.cells[i]);
      }
      counts.AppendTo(&cells);
      text += CsvLine(cells) + "\n";
    }
  }
  return text;
}

std::string RaysCsv(const SweepPlan& plan, const std::vector<RayResult>& results) {
  Cells names = RayNames(plan.spec);
  for (const char* name :
       {"survived", "lost_at", "survived_Nspkg", "lost_at_Nspkg", "ladder_share", "strengths"}) {
    names.emplace_back(name);
  }
  Counts::AppendNames(&names);
  names.emplace_back("lost_by");
  std::string text = CsvLine(names) + "\n";
  for (const RayResult& result : results) {
    const Bracket bracket = BracketOf(result.search.tested);
    Cells cells = RayCells(plan, plan.rays[result.ray]);
    const bool has_limit = plan.spec.limit.has_value();
    for (const double value :
         {bracket.survived, bracket.lost, ImpulseAt_Nspkg(result, bracket.survived),
          ImpulseAt_Nspkg(result, bracket.lost), bracket.ladder_share}) {
      cells.push_back(has_limit ? FigureText(value) : "");
    }
    cells.push_back(std::to_string(result.search.tested.size()));
    Counts counts;
    for (const CellRow* cell : result.cells) counts.Add(*cell);
    counts.AppendTo(&cells);
    const CellRow* culprit = Culprit(result, bracket.lost);
    cells.push_back(culprit != nullptr ? culprit->reasons : "");
    text += CsvLine(cells) + "\n";
  }
  return text;
}

std::string SweepSummary(const SweepPlan& plan, const std::vector<RayResult>& results) {
  std::string text;
  double cpu_s = 0.0;
  std::size_t runs = 0;
  for (const RayResult& result : results) {
    runs += result.cells.size();
    for (const CellRow* cell : result.cells) cpu_s += cell->cpu_s;
    if (result.ray < kMostLines) text += RayLine(plan, result);
  }
  if (results.size() > kMostLines) {
    text += "  ... and " + std::to_string(results.size() - kMostLines) + " rays more in rays.csv\n";
  }
  for (std::size_t i = 0; i < plan.spec.controllers.size(); ++i) {
    text += ControllerLine(plan, results, i);
  }
  const double per_hour = cpu_s > 0.0 ? static_cast<double>(runs) / cpu_s * kSecondsPerHour : 0.0;
  char line[160];
  std::snprintf(line, sizeof line,
                "%zu runs of %zu rays in %.1f core minutes: %.0f runs a core hour\n", runs,
                results.size(), cpu_s / 60.0, per_hour);
  return text + line;
}

}  // namespace sidestep
