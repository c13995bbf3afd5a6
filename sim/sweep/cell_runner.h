// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// cell_runner: runs cells of a sweep, each as its straight run would come out, bit for bit.
//
// What comes before the first push is simulated once for all scenarios that differ only in their
// pushes, and forked there. So cells are cheap in an order in which pushes start ever later.

#include <list>
#include <string>

#include "sim/episode/episode.h"
#include "sim/scenario/scenario.h"
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

/// Scenarios with the same text differ in nothing that happens before their first push but its
/// time: pushes are reduced to their number and bodies, and what only names or judges is left out.
std::string PrefixText(const Scenario& scenario);

/// Tick at which the first push starts; -1 without pushes.
Tick FirstPushTick(const Scenario& scenario);

class CellRunner {
 public:
  explicit CellRunner(const ControllerFactory& make_controller = MakeController)
      : make_controller_(make_controller) {}

  /// Runs a cell. Its `expect` does not count. A robot that is not settled (Judge::is_settled) one
  /// tick before the first push makes it INVALID, reason UNSETTLED.
  CellResult Run(const Scenario& scenario);

 private:
  struct Prefix {
    std::string text;
    Episode episode;
  };

  /// The episode just before the first push, or null if the user interrupted.
  const Episode* Before(const Scenario& scenario, Tick tick);

  ControllerFactory make_controller_;
  std::list<Prefix> prefixes_;  ///< The one used last comes first.
};

}  // namespace sidestep
