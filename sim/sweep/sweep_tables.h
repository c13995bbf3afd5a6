// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sweep_tables: what a finished sweep amounts to, as tables on disk and in words.
//
//   cells.csv      a line a run, in the order of the rays and of the search (cell_row.h)
//   strengths.csv  a line a ray and strength: runs, how many recovered, the rate's interval of 95 %
//   rays.csv       a line a ray: bracket of the limit, share of the ladder, what lost it

#include <string>
#include <vector>

#include "sim/sweep/merge_rows.h"
#include "sim/sweep/sweep_plan.h"

namespace sidestep {

std::string CellsCsv(const SweepPlan& plan, const std::vector<RayResult>& results);
std::string StrengthsCsv(const SweepPlan& plan, const std::vector<RayResult>& results);
std::string RaysCsv(const SweepPlan& plan, const std::vector<RayResult>& results);

/// For the screen: a line a ray (of many, the first), then each controller's least, mean and
/// greatest limit, its worst ray, and how many runs a core makes in an hour.
std::string SweepSummary(const SweepPlan& plan, const std::vector<RayResult>& results);

}  // namespace sidestep
