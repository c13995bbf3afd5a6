// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gnuplot: how it is started, and how text stands in its scripts.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace sidestep {

/// `text` as a single-quoted gnuplot string, in which nothing is special; in double quotes a
/// backtick would run a command. Control characters, which would end its line, become spaces.
std::string GnuplotText(std::string_view text);

/// Runs gnuplot with its own defaults, whatever stands in the user's ~/.gnuplot.
/// @param arguments  Options and script files; `-` reads the script from `input`.
/// @return  What it wrote to standard output.
/// @throws ConfigError if it can't be started or fails.
std::string RunGnuplot(const std::vector<std::string>& arguments, std::string_view input = {},
                       const std::filesystem::path& working_dir = {});

}  // namespace sidestep
