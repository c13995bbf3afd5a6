// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// expectations: what a scenario expects beside what was measured.

#include <string>
#include <vector>

#include "sim/scenario/scenario.h"
#include "sim/verdict/verdict.h"

namespace sidestep {

/// Compares each expectation with its metric. Bounds are inclusive. NaN meets no bound, infinity no
/// `max`; a truth value meets no bound and a number no `is`; an unknown metric meets nothing.
std::vector<ExpectationResult> CheckExpectations(const std::vector<Expectation>& expectations,
                                                 const Metrics& metrics);

/// Whether some expectation says `metric: true`.
bool Expects(const std::vector<Expectation>& expectations, const std::string& metric);

/// One line: what was expected and what is, such as "max_slip_m is 0.071, expected at most 0.05".
std::string Describe(const ExpectationResult& result);

}  // namespace sidestep
