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
#include "sim/sweep/cell_result.h"

namespace sidestep {

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
