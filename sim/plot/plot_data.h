// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plot_data: what the plots need to know of a run, with the trajectory thinned to what a plot of
// a thousand pixels can show.

#include <filesystem>
#include <string>
#include <vector>

namespace sidestep::plot {

/// File of PlotData::thinned_csv, beside the scripts that read it.
inline constexpr const char* kThinnedFile = "trajectory_thinned.csv";

/// A stretch that the panels shade; its start and end are those of the summary's push.
struct PushWindow {
  double start_s{0.0};
  double end_s{0.0};
};

/// A value: scripts are written from it without another look at the run.
struct PlotData {
  std::string title;              ///< Scenario's name and verdict.
  double start_s{0.0};            ///< First row of the trajectory.
  double end_s{0.0};              ///< Last row; at least 1 ms after start_s.
  std::vector<std::string> feet;  ///< Names, as the columns have them.
  std::vector<PushWindow> pushes;
  double deadline_ms{0.0};  ///< Of one MPC solve; 0 if the summary has none.
  double p50_ms{0.0};       ///< Of solves; 0 likewise.
  double p99_ms{0.0};
  bool has_footsteps{false};  ///< footsteps.csv holds a row.
  bool has_solves{false};     ///< mpc.csv holds a row.
  std::string thinned_csv;    ///< The plotted columns of trajectory.csv, at most 2000 rows.
};

/// Reads a run's files. @throws ConfigError if one is missing or broken, or a column is missing.
PlotData LoadPlotData(const std::filesystem::path& run_dir);

}  // namespace sidestep::plot
