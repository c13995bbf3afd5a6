// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plot_data: what the plots need to know of a run, with the trajectory thinned to what a plot of
// a thousand pixels can show.

#include <filesystem>
#include <string>
#include <vector>

namespace sidestep::plot {

inline constexpr const char* kThinnedFile = "trajectory_thinned.csv";

struct PushWindow {
  double start_s{0.0};
  double end_s{0.0};
};

struct PlotData {
  std::string title;  ///< Scenario's name and verdict.
  double start_s{0.0};
  double end_s{0.0};
  std::vector<std::string> feet;
  std::vector<PushWindow> pushes;
  double deadline_ms{0.0};  ///< Of one MPC solve; 0 if the summary has none.
  double p50_ms{0.0};
  double p99_ms{0.0};
  bool has_footsteps{false};
  bool has_solves{false};
  std::string thinned_csv;  ///< The plotted columns of trajectory.csv, at most 2000 rows.
};

/// Reads a run's files. @throws ConfigError if one is missing or broken, or a column is missing.
PlotData LoadPlotData(const std::filesystem::path& run_dir);

}  // namespace sidestep::plot
