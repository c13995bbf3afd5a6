// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// cell_result: what came of one run of a sweep, as plain data.

#include <string>

#include "sim/sweep/rays.h"
#include "sim/verdict/verdict.h"

namespace sidestep {

/// What a cell's run showed.
struct CellResult {
  bool was_interrupted{false};  ///< By the user: nothing else has a meaning.
  CellOutcome outcome{CellOutcome::kInvalid};
  std::string
      reasons;  ///< Kinds and texts, joined by "; "; empty if it recovered and did no wrong.
  double impulse_Nspkg{0.0};  ///< Sizes of all pushes, as scripted, over the plant's mass.
  Metrics metrics;            ///< Empty if INVALID.
  double simulated_s{0.0};    ///< From the scenario's start, shared part included.
  double cpu_s{0.0};   ///< Of this process, spent on this cell, with what it was the first to need.
  double wall_s{0.0};  ///< Likewise.
};

}  // namespace sidestep
