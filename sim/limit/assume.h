// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// assume: `--assume key=value`, a pendulum other than the robot's.

#include <string>
#include <vector>

#include "sim/limit/limit_params.h"

namespace sidestep::limit {

/// `params` with what `assignments` say, in their order. Throws ConfigError, `--assume key=value:
/// error: ...`, on an unknown key, a value out of range, or feet that can come no nearer than they
/// can part.
LimitParams Assume(const std::vector<std::string>& assignments, LimitParams params);

}  // namespace sidestep::limit
