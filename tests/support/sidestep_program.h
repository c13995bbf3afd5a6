// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sidestep_program: the program as a shell would start it.

#include <string>
#include <utility>
#include <vector>

#include "sim/process/process.h"

namespace sidestep {

/// Runs `sidestep` with these arguments to its end.
inline ProcessResult Sidestep(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), SIDESTEP_BINARY);
  return RunProcess(arguments);
}

}  // namespace sidestep
