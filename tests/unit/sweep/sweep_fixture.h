// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// sweep_fixture: a small sweep, its plan without scenarios, and rows that nobody ran.

#include <gtest/gtest.h>

#include <string>

#include "sim/sweep/cell_row.h"
#include "sim/sweep/read_sweep.h"
#include "sim/sweep/sweep_plan.h"
#include "tests/support/temp_folder.h"

namespace sidestep {

/// Two controllers, two directions, a ladder of three and two seeds.
inline SweepSpec SmallSweep() {
  SweepOptions options;
  options.vary = {"pushes.0.direction_rad=[0, 1.5]"};
  options.limit = "pushes.0.magnitude_N=[10, 20, 40]";
  options.controllers = {"{a: {}, b: {control.mode: passive}}"};
  options.seeds = "2";
  return ReadSweep(std::filesystem::path(SIDESTEP_SOURCE_DIR) / "scenarios/hopper_push.yaml",
                   options);
}

/// Its plan, with ids of its own.
inline SweepPlan SmallPlan() {
  SweepPlan plan;
  plan.spec = SmallSweep();
  for (const Ray& ray : RaysOf(plan.spec)) {
    plan.rays.push_back({ray, "id" + std::to_string(ray.index), "prefix", 2000});
  }
  return plan;
}

/// The row of a cell that came out as `outcome`; 0.1 N s/kg a newton.
inline CellRow RowOf(const SweepPlan& plan, const CellKey& cell, CellOutcome outcome,
                     double cpu_s = 1.5) {
  CellResult result;
  result.outcome = outcome;
  result.reasons = outcome == CellOutcome::kRecovered ? "" : "FALL at 3.000 s: low, very";
  result.impulse_Nspkg = cell.strength.empty() ? 0.0 : 0.1 * std::stod(cell.strength);
  result.metrics = {{"fall", outcome == CellOutcome::kLost}, {"max_tilt_rad", 0.25}};
  result.simulated_s = 6.5;
  result.cpu_s = cpu_s;
  const PlannedRay& planned = plan.rays[cell.ray];
  return MakeRow(plan.spec, planned.ray, planned.id, cell, result);
}

/// All rows of a plan whose runs recover below `limit_N`.
inline CellRows RowsBelow(const SweepPlan& plan, double limit_N, double cpu_s = 1.5) {
  CellRows rows;
  for (const PlannedRay& planned : plan.rays) {
    WalkRay(plan.spec, planned.ray, [&](const CellKey& cell) {
      const bool survives = std::stod(cell.strength) < limit_N;
      const CellOutcome outcome = survives ? CellOutcome::kRecovered : CellOutcome::kLost;
      rows.emplace(NameOf(cell), RowOf(plan, cell, outcome, cpu_s));
      return std::optional(outcome);
    });
  }
  return rows;
}

}  // namespace sidestep
