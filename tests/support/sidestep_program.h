// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sidestep_program: the program as a shell would start it.

#include <gtest/gtest.h>

#include <algorithm>
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

/// Expects of `sidestep` with these arguments that they are a mistake of the user's: exit code 2,
/// one line on stderr that has `words` in it, and nothing on stdout.
inline void ExpectMistake(const std::vector<std::string>& arguments,
                          const std::string& words = {}) {
  const ProcessResult result = Sidestep(arguments);
  SCOPED_TRACE(testing::PrintToString(arguments));
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
  EXPECT_EQ(result.out, "");
}

}  // namespace sidestep
