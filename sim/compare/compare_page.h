// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// compare_page: two runs told apart on one page, with their overlaid plots.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "sim/compare/compare_runs.h"

namespace sidestep {

/// The page: verdicts, where the trajectories part, plots, settings and metrics that differ. It
/// needs no other file, network or script, and follows the reader's light or dark preference.
/// @param plots  Labels and SVG texts (gnuplot's), in order.
std::string ComparePage(const RunComparison& comparison, const std::string& first,
                        const std::string& second,
                        const std::vector<std::pair<std::string, std::string>>& plots);

/// Writes the plots and compare.html into `folder`. @throws ConfigError as PlotOverlay.
void WriteComparison(const RunComparison& comparison, const std::filesystem::path& first,
                     const std::filesystem::path& second, const std::filesystem::path& folder);

}  // namespace sidestep
