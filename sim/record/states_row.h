// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// states_row: the bytes of states.bin, which rendering replays.

#include <string>
#include <vector>

#include "controller/types/control_tick.h"
#include "sim/world/world.h"

namespace sidestep {

/// The two header lines. @param dt_s  Time between rows. @param nq  Size of qpos.
std::string StatesHeader(const std::vector<std::string>& feet, int nq, double dt_s);

/// Appends one row of little-endian doubles: time_s, qpos, force and point of the strongest push
/// acting (zeros if none), and for each foot f_F_W, p_WF, and the nominal and adjusted place of its
/// current or next contact (its own place where the controller has no plan).
void AppendStatesRow(double time_s, const WorldTruth& truth, const ControlTick& control,
                     std::string& bytes);

}  // namespace sidestep
