// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// draw_scripts: gnuplot's pictures, which appear whole or not at all.

#include <filesystem>
#include <string>
#include <vector>

namespace sidestep::plot {

/// Runs the scripts NAME.gp of `folder` once for each of `formats` (svg, png, pdf), all in one
/// gnuplot: a start of it costs as much as a plot.
/// @return  The pictures, NAME.FORMAT in `folder`; older ones stay until all are whole.
/// @throws ConfigError or Interrupted as RunGnuplot(), and leaves no new picture then.
std::vector<std::filesystem::path> DrawScripts(const std::vector<std::string>& names,
                                               const std::vector<std::string>& formats,
                                               const std::filesystem::path& folder);

}  // namespace sidestep::plot
