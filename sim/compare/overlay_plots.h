// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// overlay_plots: two runs in the same axes, the first solid, the second dashed, pushes shaded.

#include <filesystem>
#include <string>
#include <vector>

namespace sidestep {

/// A plot's files without extension, and what it shows.
struct OverlayPlot {
  std::string name;
  std::string label;
};

/// In the order of the page.
const std::vector<OverlayPlot>& OverlayPlots();

/// Writes for each a script NAME.gp, NAME.svg and NAME.png into `folder`, which is made if need be,
/// with the curves that they draw. Shaded are the pushes of both runs.
/// @throws ConfigError if a run's files are missing or broken, or gnuplot fails.
void PlotOverlay(const std::filesystem::path& first, const std::filesystem::path& second,
                 const std::filesystem::path& folder);

}  // namespace sidestep
