// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// tick_times: how long a control tick took. Never part of what a run is.

namespace sidestep {

/// By the clock on the wall, and of the processor: the first is what a robot would feel, the second
/// is the same however busy the machine is.
struct StageTime {
  double wall_ms{0.0};
  double cpu_ms{0.0};
};

/// As StageTime, of a whole run.
struct RunTime {
  double wall_s{0.0};
  double cpu_s{0.0};
};

/// 0 for a stage that did not run.
struct TickTimes {
  StageTime control;     ///< The whole tick.
  StageTime mpc;         ///< Of that, the MPC.
  StageTime whole_body;  ///< Of that, the whole-body control.
};

}  // namespace sidestep
