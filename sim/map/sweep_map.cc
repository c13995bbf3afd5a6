// SPDX-License-Identifier: BSD-3-Clause
#include "sim/map/sweep_map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>

#include "models/support/config_error.h"
#include "models/support/parse_number.h"
#include "sim/record/run_reader.h"
#include "sim/sweep/axis.h"
#include "sim/sweep/cell_row.h"
#include "sim/sweep/csv_line.h"

namespace sidestep::map {
namespace {

bool IsStrength(const std::string& key) {
  return key.starts_with("pushes.") && (key.ends_with(".magnitude_N") ||
                                        key.ends_with(".magnitude_mg") || key.ends_with("_Nspkg"));
}

/// Which columns of the table mean what.
struct Columns {
  std::vector<std::string> names;
  std::size_t first_after_axes{0};
  std::optional<std::size_t> direction;
  std::vector<std::size_t> panel;
};

Columns ColumnsOf(const std::string& header, const std::string& file) {
  Columns columns;
  columns.names = SplitCsvLine(header);
  const auto strength = std::find(columns.names.begin(), columns.names.end(),
                                  after_axes::kNames[after_axes::kStrength]);
  columns.first_after_axes = static_cast<std::size_t>(strength - columns.names.begin());
  bool is_table = columns.first_after_axes >= kColumnsBeforeAxes &&
                  columns.names.size() >= columns.first_after_axes + after_axes::kNames.size();
  for (std::size_t i = 0; is_table && i < after_axes::kNames.size(); ++i) {
    is_table = columns.names[columns.first_after_axes + i] == after_axes::kNames[i];
  }
  if (!is_table || columns.names[2] != "controller") {
    throw ConfigError(file + ":1: error: is no table of a sweep's cells");
  }
  for (std::size_t i = kColumnsBeforeAxes; i < columns.first_after_axes; ++i) {
    const std::string& key = columns.names[i];
    if (!columns.direction && key.ends_with("direction_rad")) {
      columns.direction = i;
    } else if (!IsStrength(key)) {
      columns.panel.push_back(i);
    }
  }
  return columns;
}

std::string PanelOf(const Columns& columns, const std::vector<std::string>& row) {
  std::string name;
  for (const std::size_t i : columns.panel) {
    name += (name.empty() ? "" : ", ") + ShortSetting(columns.names[i], row[i]);
  }
  return name;
}

std::string PanelKeyOf(const Columns& columns, const std::vector<std::string>& row) {
  std::string key;
  for (const std::size_t i : columns.panel) key += columns.names[i] + "=" + row[i] + "\n";
  return key;
}

/// Numbers names in the order in which they come.
class Names {
 public:
  std::size_t Place(const std::string& name, std::vector<std::string>* names) {
    const auto [place, is_new] = places_.try_emplace(name, names->size());
    if (is_new) names->push_back(name);
    return place->second;
  }

 private:
  std::map<std::string, std::size_t> places_;
};

double NumberOf(const std::string& text) { return ParseAs<double>(text).value_or(kUnknown); }

/// Gathers rows.
class MapBuilder {
 public:
  MapBuilder(const Columns& columns, SweepMap* map) : columns_(columns), map_(*map) {}

  void Add(const std::vector<std::string>& row, std::size_t ray) {
    const std::size_t panel = panels_.Place(PanelKeyOf(columns_, row), &map_.panel_keys);
    if (panel == map_.panels.size()) map_.panels.push_back(PanelOf(columns_, row));
    const std::size_t controller = controllers_.Place(row[2], &map_.controllers);
    const std::string direction = columns_.direction ? row[*columns_.direction] : "";
    const std::size_t at = directions_.Place(direction, &map_.directions);
    MapCell& cell = cells_[{panel, controller, at}];
    if (cell.points.empty()) {
      cell.controller = controller;
      cell.panel = panel;
      cell.direction = direction;
      if (!direction.empty()) cell.direction_rad = ParseNumber(direction);
    }
    AddRun(row, ray, &cell);
  }

  void Finish() {
    for (auto& [place, cell] : cells_) {
      std::stable_sort(cell.points.begin(), cell.points.end(), [](const auto& a, const auto& b) {
        return a.impulse_Nspkg < b.impulse_Nspkg;  // NaN stays where it is
      });
      map_.has_limits = map_.has_limits || cell.points.size() > 1;
      map_.cells.push_back(std::move(cell));
    }
  }

 private:
  void AddRun(const std::vector<std::string>& row, std::size_t ray, MapCell* cell) const {
    const std::string* after = &row[columns_.first_after_axes];
    auto point = std::find_if(cell->points.begin(), cell->points.end(), [&](const MapPoint& known) {
      return known.ray == ray && known.strength == after[after_axes::kStrength];
    });
    if (point == cell->points.end()) {
      const double impulse_Nspkg = NumberOf(after[after_axes::kImpulse]);
      cell->points.push_back(
          {after[after_axes::kStrength], std::isfinite(impulse_Nspkg) ? impulse_Nspkg : 0.0,
           after[after_axes::kStage], 0, 0, 0, "", ray, after[after_axes::kSeed]});
      point = cell->points.end() - 1;
    }
    const bool is_recovered = after[after_axes::kOutcome] == "RECOVERED";
    point->recovered += is_recovered ? 1 : 0;
    point->lost += after[after_axes::kOutcome] == "LOST" ? 1 : 0;
    point->invalid += after[after_axes::kOutcome] == "INVALID" ? 1 : 0;
    if (!is_recovered && point->reasons.empty()) {
      point->reasons = after[after_axes::kReasons];
      point->seed = after[after_axes::kSeed];
    }
  }

  const Columns& columns_;
  SweepMap& map_;
  Names panels_;
  Names controllers_;
  Names directions_;
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, MapCell> cells_;
};

}  // namespace

Survival MapPoint::survival() const {
  if (lost > 0) return Survival::kLost;
  if (invalid > 0 || recovered == 0) return Survival::kInvalid;
  return Survival::kSurvived;
}

CellLimit LimitOf(const MapCell& cell) {
  std::vector<TestedStrength> tested;
  int recovered = 0, told = 0;
  for (const MapPoint& point : cell.points) {
    const bool is_ladder = point.stage == "ladder";
    tested.push_back({point.impulse_Nspkg, is_ladder ? SearchStage::kLadder : SearchStage::kSingle,
                      point.survival()});
    recovered += point.recovered;
    told += point.recovered + point.lost;
  }
  if (told == 0) return {};
  const Bracket bracket = BracketOf(tested);
  return {bracket.survived, bracket.lost, static_cast<double>(recovered) / told};
}

double ValueOf(const SweepMap& map, const MapCell& cell) {
  const CellLimit limit = LimitOf(cell);
  return map.has_limits ? limit.survived : limit.share;
}

const MapCell* FindCell(const SweepMap& map, std::size_t controller, std::size_t panel,
                        const std::string& direction) {
  for (const MapCell& cell : map.cells) {
    if (cell.controller == controller && cell.panel == panel && cell.direction == direction) {
      return &cell;
    }
  }
  return nullptr;
}

bool HasDirections(const SweepMap& map) {
  return map.directions.size() > 1 &&
         std::all_of(map.cells.begin(), map.cells.end(),
                     [](const MapCell& cell) { return cell.direction_rad.has_value(); });
}

SweepMap ParseMap(std::string_view cells_csv, const std::string& name, const std::string& file) {
  SweepMap map;
  map.name = name;
  std::size_t end = std::min(cells_csv.find('\n'), cells_csv.size());
  const Columns columns = ColumnsOf(std::string(cells_csv.substr(0, end)), file);
  MapBuilder builder(columns, &map);
  for (int line = 2; end + 1 < cells_csv.size(); ++line) {
    const std::size_t begin = end + 1;
    end = std::min(cells_csv.find('\n', begin), cells_csv.size());
    const std::vector<std::string> row = SplitCsvLine(cells_csv.substr(begin, end - begin));
    if (row.size() != columns.names.size()) {
      throw ConfigError(file + ":" + std::to_string(line) + ": error: has " +
                        std::to_string(row.size()) + " columns, not " +
                        std::to_string(columns.names.size()));
    }
    const std::optional<std::size_t> ray = ParseAs<std::size_t>(row[0]);
    if (!ray) {
      throw ConfigError(file + ":" + std::to_string(line) + ": error: ray '" + row[0] +
                        "' is no number of a ray");
    }
    builder.Add(row, *ray);
  }
  builder.Finish();
  return map;
}

SweepMap ReadMap(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "cells.csv";
  const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
  const std::string name = whole.has_filename() ? whole.filename() : whole.parent_path().filename();
  return ParseMap(ReadWholeFile(file), name, file);
}

std::string ShortSetting(const std::string& key, const std::string& value) {
  std::string name = key;
  if (name.starts_with("pushes.")) name.erase(0, name.find('.', sizeof "pushes." - 1) + 1);
  const std::optional<double> number = ParseNumber(value);
  if (!number) return name + " " + value;
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", *number);
  return name + " " + text;
}

}  // namespace sidestep::map
