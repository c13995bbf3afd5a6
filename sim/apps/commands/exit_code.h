// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// exit_code: what the program tells the shell.

#include "sim/verdict/verdict.h"

namespace sidestep {

/// Pass, or the command did what it was asked.
constexpr int kExitPass = ExitCodeOf(VerdictClass::kPass);
/// The verdict is FAIL, or the problem has no solution.
constexpr int kExitFail = ExitCodeOf(VerdictClass::kFail);
/// A mistake in a file or on the command line.
constexpr int kExitBadInput = 2;
/// The run says nothing (diverged, interrupted), or our bug.
constexpr int kExitInvalid = ExitCodeOf(VerdictClass::kInvalid);

}  // namespace sidestep
