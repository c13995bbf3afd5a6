// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plot_data: what the plots need to know of a run, or of the time around one of its pushes.

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/plot/canvas.h"
#include "sim/plot/curve_file.h"
#include "sim/record/run_reader.h"
#include "sim/record/run_summary.h"

namespace sidestep::plot {

/// A run's files, read once for all its plots.
struct PlottedRun {
  RunSummary summary;
  CsvTable trajectory;
  std::vector<Footstep> footsteps;
  CsvTable solves;
  /// Of each foot of the trajectory: the outline of its sole, convex, in F; a point or a line for
  /// a foot that has no more, empty if the run's robot can't be read any longer.
  std::vector<std::vector<Eigen::Vector2d>> soles;
};

/// Reads a run's files. @throws ConfigError if one is missing or broken.
PlottedRun ReadPlottedRun(const std::filesystem::path& run_dir);

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

/// One contact of a foot.
struct PlottedStep {
  Footstep step;
  std::size_t foot{0};       ///< Of PlotData::feet.
  int number{0};             ///< Of all touch-downs in order, from 1 on; 0 stood from the start.
  double lift_s{0.0};        ///< When the foot left its contact before, or the run's start.
  bool is_far_moved{false};  ///< One of the six that the controller moved farthest.
};

/// A gait that the scenario asked for.
struct AskedGaitStart {
  double start_s{0.0};
  std::string type;
};

/// A value: scripts are written from it without another look at the run.
struct PlotData {
  std::string title;                   ///< Scenario's name and verdict.
  Canvas canvas;                       ///< How large it will be drawn.
  double start_s{0.0};                 ///< First row of the trajectory that is shown.
  double end_s{0.0};                   ///< Last row; at least 1 ms after start_s.
  std::vector<std::string> feet;       ///< Names, as the columns have them.
  std::vector<Stretch> pushes;         ///< As the summary has them; panels over time shade them.
  std::vector<PushMark> push_marks;    ///< Of those that came.
  std::vector<FootContacts> contacts;  ///< One a foot.
  std::vector<Stretch> flights;        ///< No foot stood; of 20 ms at least.
  std::vector<AskedGaitStart> gaits;
  std::vector<PlottedStep> steps;
  std::vector<std::vector<Eigen::Vector2d>> soles;  ///< As PlottedRun's.
  double deadline_ms{0.0};                          ///< Of one MPC solve; 0 if there is none.
  double p50_ms{0.0};                               ///< Of solves; 0 likewise.
  double p99_ms{0.0};
  std::vector<std::string> phases;  ///< Of the phase portraits' values, those that move.

  /// By the trajectory's columns, over time; `adjustment_<foot>_x_m`, the foothold in plan against
  /// its nominal place; `pressure_<foot>_x_m`, the centre of pressure from F; `truth_path` and
  /// `reference_path` from above; `<value>_before`, `_pushed` and `_after` of each of `phases`,
  /// against its rate; `solve_wall_ms`, `solve_cpu_ms` and `solve_iterations`.
  CurveFile curves;
};

/// The data of a stretch of a run, or of all of it.
/// @param curves  Takes the curves: empty.
/// @throws ConfigError if the stretch holds no row, or a column is missing.
PlotData SelectPlotData(const PlottedRun& run, std::optional<Stretch> stretch = {},
                        CurveFile curves = CurveFile());

/// Of a whole run's folder.
PlotData LoadPlotData(const std::filesystem::path& run_dir, CurveFile curves = CurveFile());

}  // namespace sidestep::plot
