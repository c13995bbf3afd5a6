// SPDX-License-Identifier: BSD-3-Clause
#include "sim/sweep/merge_rows.h"

#include <algorithm>
#include <cstdio>
#include <set>
#include <utility>

#include "models/support/config_error.h"
#include "sim/sweep/row_file.h"

namespace sidestep {
namespace {

// The N of `rows-I-of-N.csv`; 0 if the file is not called so.
int ShardsOf(const std::string& name) {
  int shard = 0, shards = 0, length = 0;
  const bool is_rows =
      std::sscanf(name.c_str(), "rows-%d-of-%d.csv%n", &shard, &shards, &length) == 2 &&
      static_cast<std::size_t>(length) == name.size();
  return is_rows ? shards : 0;
}

void Add(const SweepPlan& plan, const std::filesystem::path& file, CellRow row, CellRows* rows) {
  const std::size_t place = row.cell.ray;
  if (place >= plan.rays.size() || plan.rays[place].id != row.id) {
    throw ConfigError(file.string() + ": error: a row of ray " + std::to_string(place) +
                      " is of another sweep or program");
  }
  const auto [there, is_new] = rows->emplace(NameOf(row.cell), row);
  if (!is_new && there->second.Repeatable() != row.Repeatable()) {
    throw ConfigError(file.string() + ": error: ray " + std::to_string(place) + " strength '" +
                      row.cell.strength + "' seed '" + row.cell.seed +
                      "' is there twice, and the rows differ: runs are not repeatable here");
  }
}

}  // namespace

MergedRows ReadAllRows(const SweepPlan& plan, const std::filesystem::path& folder,
                       const std::function<void(const std::string&)>& note) {
  std::set<std::filesystem::path> files;
  MergedRows merged;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const int shards = ShardsOf(entry.path().filename().string());
    if (shards > 0) files.insert(entry.path());
    merged.shards = std::max(merged.shards, shards);
  }
  for (const std::filesystem::path& file : files) {
    RowsOnDisk found = ReadRows(plan.spec, file);
    if (found.has_half_row) note(file.string() + ": note: passed over a half-written last row");
    for (CellRow& row : found.rows) Add(plan, file, std::move(row), &merged.rows);
  }
  return merged;
}

std::vector<RayResult> ResultsOf(const SweepPlan& plan, const CellRows& rows) {
  std::vector<RayResult> results;
  for (const PlannedRay& planned : plan.rays) {
    RayResult& result = results.emplace_back();
    result.ray = planned.ray.index;
    result.search = WalkRay(plan.spec, planned.ray, [&](const CellKey& cell) {
      const auto found = rows.find(NameOf(cell));
      if (found == rows.end()) return std::optional<CellOutcome>();
      result.cells.push_back(&found->second);
      return std::optional(found->second.outcome);
    });
  }
  return results;
}

std::string ArrayText(const std::vector<std::size_t>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    text += (text.empty() ? "" : ",") + std::to_string(numbers[i]);
    if (last > i) text += (last > i + 1 ? "-" : ",") + std::to_string(numbers[last]);
    i = last + 1;
  }
  return text;
}

std::vector<std::size_t> MissingShards(const std::vector<RayResult>& results, int shards) {
  std::set<std::size_t> missing;
  for (const RayResult& result : results) {
    if (!result.search.is_complete) missing.insert(result.ray % static_cast<std::size_t>(shards));
  }
  return {missing.begin(), missing.end()};
}

}  // namespace sidestep
