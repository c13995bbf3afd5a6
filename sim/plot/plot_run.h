// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plot_run: a run's folder in, plots/*.svg out, by gnuplot as a process.

#include <filesystem>
#include <string>
#include <vector>

namespace sidestep {

/// Names of the plots, without extension, in the order a report shows them.
const std::vector<std::string>& PlotNames();

enum class PlotFiles { kSvg, kSvgAndPng };

/// Writes run_dir/plots/: for each plot a script NAME.gp, NAME.svg and, if asked for, NAME.png, and
/// the thinned data that the scripts draw. A plot is drawn again by `gnuplot NAME.gp` in that
/// folder (add
/// `-e "format='png'"` for PNG). Reads trajectory.csv, footsteps.csv, mpc.csv and summary.json.
/// @throws ConfigError if a file is missing or broken, or gnuplot fails (with its words).
void PlotRun(const std::filesystem::path& run_dir, PlotFiles files = PlotFiles::kSvg);

}  // namespace sidestep
