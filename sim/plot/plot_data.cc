// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/plot_data.h"

#include <algorithm>
#include <cmath>

#include "models/support/config_error.h"
#include "sim/record/run_reader.h"
#include "sim/record/run_summary.h"

namespace sidestep::plot {
namespace {

constexpr std::size_t kMostRows = 2000;  // two samples a pixel of the widest panel

// Columns that the scripts draw. Reading checks that each is there.
std::vector<std::string> PlottedColumns(const std::vector<std::string>& feet) {
  std::vector<std::string> columns{"time_s", "truth_tilt_rad"};
  const auto add_vector = [&](const std::string& stem, const std::string& unit) {
    for (const char* axis : {"_x_", "_y_", "_z_"}) columns.push_back(stem + axis + unit);
  };
  for (const char* point : {"truth_p_WC", "belief_p_WC", "reference_p_WC", "mpc_p_WC"}) {
    add_vector(point, "m");
  }
  for (const char* velocity : {"truth_v_WC", "belief_v_WC", "reference_v_WC", "mpc_v_WC"}) {
    add_vector(velocity, "mps");
  }
  add_vector("truth_h_C_W", "kgm2ps");
  for (const char* push : {"push", "belief_push"}) {
    add_vector(std::string(push) + "_force_W", "N");
    add_vector(std::string(push) + "_torque_C_W", "Nm");
  }
  for (const std::string& foot : feet) {
    add_vector("truth_f_F_W_" + foot, "N");
    add_vector("truth_m_F_W_" + foot, "Nm");
    add_vector("mpc_f_F_W_" + foot, "N");
    columns.push_back("truth_p_WF_" + foot + "_z_m");
    columns.push_back("swing_p_WF_" + foot + "_z_m");
    add_vector("nominal_p_WF_" + foot, "m");
    add_vector("adjusted_p_WF_" + foot, "m");
  }
  return columns;
}

std::string Thinned(const CsvTable& trajectory, const std::vector<std::string>& columns) {
  const std::size_t stride = (trajectory.num_rows() + kMostRows - 1) / kMostRows;
  std::vector<std::vector<double>> values;
  std::string csv;
  for (const std::string& column : columns) {
    values.push_back(trajectory.Numbers(column));
    csv += (csv.empty() ? "" : ",") + column;
  }
  csv += "\n";
  char cell[32];
  for (std::size_t row = 0; row < trajectory.num_rows(); row += stride) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double value = values[i][row];
      std::snprintf(cell, sizeof cell, "%s%.7g", i == 0 ? "" : ",", value);
      csv += std::isfinite(value) ? cell : (i == 0 ? "" : ",");  // gnuplot skips empty cells
    }
    csv += "\n";
  }
  return csv;
}

void ReadSummaryInto(const std::filesystem::path& run_dir, PlotData* data) {
  const RunSummary summary = ReadSummary(run_dir);
  data->title = summary.name + " (" + std::string(EnumName(summary.verdict)) + ")";
  for (const PushSummary& push : summary.pushes) {
    data->pushes.push_back({push.start_s, push.start_s + push.duration_s});
  }
  const auto drawn = [](double ms) { return std::isfinite(ms) ? ms : 0.0; };
  data->deadline_ms = drawn(summary.solve_time.deadline_ms);
  data->p50_ms = drawn(summary.solve_time.p50_ms);
  data->p99_ms = drawn(summary.solve_time.p99_ms);
}

}  // namespace

PlotData LoadPlotData(const std::filesystem::path& run_dir) {
  PlotData data;
  ReadSummaryInto(run_dir, &data);
  const CsvTable trajectory = CsvTable::Read(run_dir / "trajectory.csv");
  if (trajectory.num_rows() == 0) {
    throw ConfigError((run_dir / "trajectory.csv").string() + ": error: holds no row");
  }
  data.feet = FeetOf(trajectory);
  const std::vector<double> time_s = trajectory.Numbers("time_s");
  data.start_s = time_s.front();
  data.end_s = std::max(time_s.back(), time_s.front() + 1e-3);  // an axis needs a length
  data.thinned_csv = Thinned(trajectory, PlottedColumns(data.feet));
  data.has_footsteps = !ReadFootsteps(run_dir).empty();
  data.has_solves = CsvTable::Read(run_dir / "mpc.csv").num_rows() > 0;
  return data;
}

}  // namespace sidestep::plot
