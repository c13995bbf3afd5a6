// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plot_run: a run's folder in, plots/*.svg out, by gnuplot as a process.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/plot/canvas.h"

namespace sidestep {

/// Names of the plots, without extension, in the order a report shows them.
const std::vector<std::string>& PlotNames();

/// What to draw, and how.
struct PlotOptions {
  std::vector<std::string> only{};          ///< Of PlotNames(); empty: all.
  std::vector<std::string> formats{"svg"};  ///< svg, png or pdf.
  plot::Canvas canvas{};

  /// Instead of the whole run, this long (s) before each push to as long after it.
  std::optional<double> around_s{};
};

/// Writes run_dir/plots/: for each plot a script NAME.gp and a picture of each format, and the
/// curves that the scripts draw. A plot is drawn again by `gnuplot NAME.gp` in that folder (add
/// `-e "format='png'"` for PNG). NAME is a plot's, then `_push1` for the time around the first
/// push, then `_88mm` for a size of its own. Reads trajectory.csv, footsteps.csv, mpc.csv,
/// summary.json and, for the soles' shape, scenario.yaml.
/// @return  The pictures' files.
/// @throws ConfigError if a plot is none, a file is missing or broken, or gnuplot fails (with its
///         words), or there is no push to draw the time around.
std::vector<std::filesystem::path> PlotRun(const std::filesystem::path& run_dir,
                                           const PlotOptions& options = {});

}  // namespace sidestep
