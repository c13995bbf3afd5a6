// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// report_sections: the parts of the page. Pure functions of the evidence.

#include <cstddef>
#include <string>
#include <vector>

#include "sim/report/run_evidence.h"

namespace sidestep::report {

/// One row a run, each linked to its section.
std::string ComparisonSection(const std::vector<RunEvidence>& runs);

/// Everything of one run. `index` makes its anchors unique in the page.
std::string RunSection(const RunEvidence& run, std::size_t index);

}  // namespace sidestep::report
