// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// wall_times: how long a control tick took by the clock on the wall. Never part of what a run is.

namespace sidestep {

/// In ms; 0 for a stage that did not run.
struct WallTimes {
  double control_ms{0.0};     ///< The whole tick.
  double mpc_ms{0.0};         ///< Of that, the MPC.
  double whole_body_ms{0.0};  ///< Of that, the whole-body control.
};

}  // namespace sidestep
