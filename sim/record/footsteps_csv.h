// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// footsteps_csv: the text of footsteps.csv.

#include <string>
#include <vector>

#include "sim/verdict/verdict.h"

namespace sidestep {

/// One row a contact, with a header. What there is not, a place or a box, is an empty cell. @param
/// feet  Names. @param tick_s  Length of a tick (s).
std::string FootstepsCsv(const std::vector<FootstepRecord>& footsteps,
                         const std::vector<std::string>& feet, double tick_s);

}  // namespace sidestep
