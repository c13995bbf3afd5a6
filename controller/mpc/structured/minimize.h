// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// minimize: the numerical core in the fastest form that this processor runs.

#include "controller/mpc/structured/interior_point.h"

namespace sidestep::mpc::structured {

/// See Minimize() of interior_point.h.
Summary Minimize(const ProblemView& problem, const Settings& settings, Workspace* workspace);

/// True if the processor runs the copy for AVX2 and FMA.
bool HasFastInstructions();

}  // namespace sidestep::mpc::structured
