// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// start_program: fork and exec, in a way that the program can't outlive us.

#include <sys/types.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace sidestep {

/// Starts argv[0], looked up in PATH, with `environment` ("NAME=value") in `working_dir` (ours if
/// empty) and `streams` as its standard input, output and error. The kernel kills it when the
/// thread that called this ends (PR_SET_PDEATHSIG).
///
/// @return Its process id, or minus the errno of what failed.
pid_t StartProgram(const std::vector<std::string>& argv,
                   const std::vector<std::string>& environment,
                   const std::filesystem::path& working_dir, const std::array<int, 3>& streams);

}  // namespace sidestep
