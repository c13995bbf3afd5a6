// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plot_curves: which curves of a run the plots draw, by the names that PlotData tells.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sim/plot/plot_data.h"
#include "sim/record/run_reader.h"

namespace sidestep::plot {

/// The rows of a table from one time to another.
class TimedRows {
 public:
  /// @param table  With a column time_s that ascends. All rows if there is no stretch.
  TimedRows(const CsvTable& table, const std::optional<Stretch>& stretch);

  bool is_empty() const { return time_s_.empty(); }
  const std::vector<double>& time_s() const { return time_s_; }
  bool has(const std::string& column) const { return table_.has(column); }

  /// A column's numbers in these rows; NaN for an empty cell. @throws as CsvTable::Numbers.
  std::vector<double> Numbers(const std::string& column) const {
    return Cut(table_.Numbers(column));
  }

  /// Of a value for each row of the table, those of these rows.
  std::vector<double> Cut(std::vector<double> values) const;

  /// All rows.
  const CsvTable& table() const { return table_; }

 private:
  const CsvTable& table_;
  std::size_t first_{0};
  std::vector<double> time_s_;
};

/// Adds all curves to data->curves, and what moves to data->phases.
/// @param data  Has its feet and pushes. @throws ConfigError naming a column that is missing.
void AddCurves(const TimedRows& trajectory, const TimedRows& solves, PlotData* data);

}  // namespace sidestep::plot
