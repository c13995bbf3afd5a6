// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// write_report: run folders in, one self-contained HTML page out.

#include <filesystem>
#include <vector>

namespace sidestep {

/// Writes a page that shows everything a run left: verdict and reasons, video, expectations,
/// pushes, solve times, settings, plots and the resolved scenario. For several runs a table that
/// compares them comes first. The page needs no network, no script and no other file: video and
/// plots are in it. Runs without video or plots are shown without. Follows the reader's light or
/// dark preference.
/// @throws ConfigError if a run's summary.json or scenario.yaml is missing or broken, if `runs` is
///         empty, or if the page can't be written.
void WriteReport(const std::vector<std::filesystem::path>& run_dirs,
                 const std::filesystem::path& out_html);

}  // namespace sidestep
