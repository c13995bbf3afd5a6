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

/// Likewise of PlotData::phase_csv.
inline constexpr const char* kPhaseFile = "phase.csv";

/// A stretch of time.
struct Stretch {
  double start_s{0.0};
  double end_s{0.0};
};

/// A push seen from above: where the CoM was when it came, and its largest force.
struct PushMark {
  double x_m{0.0};
  double y_m{0.0};
  double force_x_N{0.0};
  double force_y_N{0.0};
};

/// When a foot stood, and when it was planned to.
struct FootContacts {
  std::vector<Stretch> truth;
  std::vector<Stretch> planned;
};

/// How far a column of PlotData::phase_csv goes.
struct PhaseRange {
  std::string column;
  double min{0.0};
  double max{0.0};
};

/// A gait that the scenario asked for.
struct AskedGaitStart {
  double start_s{0.0};
  std::string type;
};

/// A value: scripts are written from it without another look at the run.
struct PlotData {
  std::string title;                   ///< Scenario's name and verdict.
  double start_s{0.0};                 ///< First row of the trajectory.
  double end_s{0.0};                   ///< Last row; at least 1 ms after start_s.
  std::vector<std::string> feet;       ///< Names, as the columns have them.
  std::vector<Stretch> pushes;         ///< As the summary has them; panels over time shade them.
  std::vector<PushMark> push_marks;    ///< Of those that came.
  std::vector<FootContacts> contacts;  ///< One a foot.
  std::vector<Stretch> flights;        ///< No foot stood; of 20 ms at least.
  std::vector<AskedGaitStart> gaits;
  double deadline_ms{0.0};  ///< Of one MPC solve; 0 if the summary has none.
  double p50_ms{0.0};       ///< Of solves; 0 likewise.
  double p99_ms{0.0};
  bool has_footsteps{false};  ///< footsteps.csv holds a row.
  double moved_m{0.0};     ///< A step that the controller moved farther is one of the six farthest.
  bool has_solves{false};  ///< mpc.csv holds a row.
  bool has_cpu_times{false};  ///< Its rows tell the processor's time, too.
  std::string thinned_csv;    ///< The plotted columns of trajectory.csv, at most 2000 rows.
  /// The CoM's and the base's motion for phase portraits, at most 6000 rows: y and z of the CoM,
  /// roll and pitch of the base (yaw first), and their rates.
  std::string phase_csv;
  std::vector<PhaseRange> phases;  ///< Of the values in it that move, not of their rates.
};

/// Reads a run's files. @throws ConfigError if one is missing or broken, or a column is missing.
PlotData LoadPlotData(const std::filesystem::path& run_dir);

}  // namespace sidestep::plot
