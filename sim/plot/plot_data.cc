// SPDX-License-Identifier: BSD-3-Clause
#include "sim/plot/plot_data.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "models/support/config_error.h"
#include "sim/record/run_reader.h"
#include "sim/record/run_summary.h"

namespace sidestep::plot {
namespace {

constexpr std::size_t kMostRows = 2000;       // two samples a pixel of the widest panel
constexpr std::size_t kMostPhaseRows = 6000;  // the loops of a long run are drawn as such

// Shorter is a bounce, or the first row, before the ground has pushed.
constexpr double kShortestFlight_s = 0.02;

// m or rad: what moves less, such as a planar robot to its side, has no portrait.
constexpr double kStill = 1e-4;

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

struct NamedColumn {
  std::string name;
  std::vector<double> values;
};

std::vector<NamedColumn> ColumnsOf(const CsvTable& trajectory,
                                   const std::vector<std::string>& names) {
  std::vector<NamedColumn> columns;
  for (const std::string& name : names) columns.push_back({name, trajectory.Numbers(name)});
  return columns;
}

std::vector<double> RatesOf(const std::vector<double>& values, const std::vector<double>& time_s) {
  std::vector<double> rates(values.size(), 0.0);
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    rates[i] = (values[i + 1] - values[i - 1]) / (time_s[i + 1] - time_s[i - 1]);
  }
  return rates;
}

// Roll and pitch of the base (rad), yaw first, and their rates by differences.
std::vector<NamedColumn> AttitudeColumns(const CsvTable& trajectory,
                                         const std::vector<double>& time_s) {
  const auto w = trajectory.Numbers("truth_q_WB_w"), x = trajectory.Numbers("truth_q_WB_x");
  const auto y = trajectory.Numbers("truth_q_WB_y"), z = trajectory.Numbers("truth_q_WB_z");
  std::vector<double> roll_rad, pitch_rad;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double up_y = 2.0 * (w[i] * x[i] + y[i] * z[i]);
    const double up_z = 1.0 - 2.0 * (x[i] * x[i] + y[i] * y[i]);
    roll_rad.push_back(std::atan2(up_y, up_z));
    pitch_rad.push_back(std::asin(std::clamp(2.0 * (w[i] * y[i] - z[i] * x[i]), -1.0, 1.0)));
  }
  return {{"truth_roll_rad", roll_rad},
          {"truth_roll_radps", RatesOf(roll_rad, time_s)},
          {"truth_pitch_rad", pitch_rad},
          {"truth_pitch_radps", RatesOf(pitch_rad, time_s)}};
}

std::string Thinned(const std::vector<NamedColumn>& columns, std::size_t most_rows) {
  const std::size_t num_rows = columns.front().values.size();
  const std::size_t stride = (num_rows + most_rows - 1) / most_rows;
  std::string csv;
  for (const NamedColumn& column : columns) csv += (csv.empty() ? "" : ",") + column.name;
  csv += "\n";
  char cell[32];
  for (std::size_t row = 0; row < num_rows; row += stride) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const double value = columns[i].values[row];
      std::snprintf(cell, sizeof cell, "%s%.7g", i == 0 ? "" : ",", value);
      csv += std::isfinite(value) ? cell : (i == 0 ? "" : ",");  // gnuplot skips empty cells
    }
    csv += "\n";
  }
  return csv;
}

// Where `holds` is true of a row, from its time to that of the first row after.
template <typename Holds>
std::vector<Stretch> StretchesOf(const std::vector<double>& time_s, Holds holds) {
  std::vector<Stretch> stretches;
  for (std::size_t row = 0; row < time_s.size(); ++row) {
    const bool held_before = row > 0 && holds(row - 1);
    if (held_before) stretches.back().end_s = time_s[row];
    if (holds(row) && !held_before) stretches.push_back({time_s[row], time_s[row]});
  }
  return stretches;
}

void ReadContactsInto(const CsvTable& trajectory, const std::vector<double>& time_s,
                      PlotData* data) {
  std::vector<bool> stands(time_s.size(), false);
  for (const std::string& foot : data->feet) {
    const std::vector<double> truth = trajectory.Numbers("truth_contact_" + foot);
    const std::vector<double> planned = trajectory.Numbers("planned_contact_" + foot);
    const auto is_set = [](const std::vector<double>& flags) {
      return [&flags](std::size_t row) { return flags[row] > 0.5; };  // an empty cell is NaN
    };
    data->contacts.push_back(
        {StretchesOf(time_s, is_set(truth)), StretchesOf(time_s, is_set(planned))});
    for (std::size_t row = 0; row < truth.size(); ++row) {
      if (truth[row] > 0.5) stands[row] = true;
    }
  }
  data->flights = StretchesOf(time_s, [&](std::size_t row) { return !stands[row]; });
  std::erase_if(data->flights, [](const Stretch& flight) {
    return flight.end_s - flight.start_s < kShortestFlight_s;
  });
}

void ReadPushMarksInto(const CsvTable& trajectory, const std::vector<double>& time_s,
                       PlotData* data) {
  const auto x = trajectory.Numbers("truth_p_WC_x_m"), y = trajectory.Numbers("truth_p_WC_y_m");
  const auto force_x = trajectory.Numbers("push_force_W_x_N");
  const auto force_y = trajectory.Numbers("push_force_W_y_N");
  for (const Stretch& push : data->pushes) {
    const auto at = std::lower_bound(time_s.begin(), time_s.end(), push.start_s);
    if (at == time_s.end()) continue;
    const auto first = static_cast<std::size_t>(at - time_s.begin());
    PushMark mark{x[first], y[first], 0.0, 0.0};
    for (std::size_t row = first; row < time_s.size() && time_s[row] <= push.end_s; ++row) {
      if (std::hypot(force_x[row], force_y[row]) <= std::hypot(mark.force_x_N, mark.force_y_N)) {
        continue;
      }
      mark.force_x_N = force_x[row];
      mark.force_y_N = force_y[row];
    }
    data->push_marks.push_back(mark);
  }
}

void ReadPhasesInto(const CsvTable& trajectory, const std::vector<double>& time_s, PlotData* data) {
  std::vector<NamedColumn> columns = ColumnsOf(
      trajectory,
      {"time_s", "truth_p_WC_y_m", "truth_v_WC_y_mps", "truth_p_WC_z_m", "truth_v_WC_z_mps"});
  for (NamedColumn& column : AttitudeColumns(trajectory, time_s)) {
    columns.push_back(std::move(column));
  }
  data->phase_csv = Thinned(columns, kMostPhaseRows);
  for (const NamedColumn& column : columns) {
    const bool is_rate = column.name.ends_with("ps");
    const auto [min, max] = std::minmax_element(column.values.begin(), column.values.end());
    if (column.name == "time_s" || is_rate || !(*max - *min > kStill)) continue;
    data->phases.push_back({column.name, *min, *max});
  }
}

void ReadSummaryInto(const std::filesystem::path& run_dir, PlotData* data) {
  const RunSummary summary = ReadSummary(run_dir);
  data->title = summary.name + " (" + std::string(EnumName(summary.verdict)) + ")";
  for (const PushSummary& push : summary.pushes) {
    data->pushes.push_back({push.start_s, push.start_s + push.duration_s});
  }
  for (const GaitSummary& gait : summary.gaits) {
    data->gaits.push_back({gait.start_s, std::string(EnumName(gait.type))});
  }
  const auto drawn = [](double ms) { return std::isfinite(ms) ? ms : 0.0; };
  data->deadline_ms = drawn(summary.solve_time.deadline_ms);
  data->p50_ms = drawn(summary.solve_time.p50_ms);
  data->p99_ms = drawn(summary.solve_time.p99_ms);
}

// What all but the six steps that were moved farthest were moved at most.
double MovedFarther_m(const std::vector<Footstep>& footsteps) {
  constexpr std::size_t kMostBoxes = 6;  // more would be a hatch
  constexpr double kLeast_m = 0.01;
  std::vector<double> moved_m;
  for (const Footstep& step : footsteps) {
    const double distance_m = (step.adjusted_p_WF - step.nominal_p_WF).head<2>().norm();
    if (std::isfinite(distance_m)) moved_m.push_back(distance_m);
  }
  std::sort(moved_m.rbegin(), moved_m.rend());
  return moved_m.size() > kMostBoxes ? std::max(kLeast_m, moved_m[kMostBoxes]) : kLeast_m;
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
  ReadContactsInto(trajectory, time_s, &data);
  data.thinned_csv = Thinned(ColumnsOf(trajectory, PlottedColumns(data.feet)), kMostRows);
  ReadPushMarksInto(trajectory, time_s, &data);
  ReadPhasesInto(trajectory, time_s, &data);
  const std::vector<Footstep> footsteps = ReadFootsteps(run_dir);
  data.has_footsteps = !footsteps.empty();
  data.moved_m = MovedFarther_m(footsteps);
  const CsvTable solves = CsvTable::Read(run_dir / "mpc.csv");
  data.has_solves = solves.num_rows() > 0;
  data.has_cpu_times = solves.has("cpu_ms");
  return data;
}

}  // namespace sidestep::plot
