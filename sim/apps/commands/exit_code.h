// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// exit_code: what the program tells the shell.

namespace sidestep {

constexpr int kExitPass = 0;      ///< Pass, or the command did what it was asked.
constexpr int kExitFail = 1;      ///< The verdict is FAIL, or the problem has no solution.
constexpr int kExitBadInput = 2;  ///< A mistake in a file or on the command line.
constexpr int kExitInvalid = 3;   ///< The run says nothing (diverged, interrupted), or our bug.

}  // namespace sidestep
