// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// shifted_guess: the previous solution, moved on in time, as a start for the next problem.

#include "controller/mpc/problem/centroidal_ocp.h"
#include "controller/mpc/problem/mpc_solution.h"

namespace sidestep::mpc {

/// Fills `guess` (shapes of `next_ocp`) from the solution of `previous_ocp`, `shift_knots` >= 0
/// knots earlier. Does not allocate when the shapes repeat.
///
/// - Knot k takes the previous knot k + shift: its state, for k > 0, and its forces. On a grid that
///   both problems share knots k > 0 are the same instants, however long the first knots are.
///   Beyond the previous horizon the CoM coasts, angular momentum and forces stay. State 0 is the
///   next problem's.
/// - A phase continues the previous phase of that contact with which it shares most time, in order
///   of time; it may have become fixed. A phase without such a predecessor starts at its nominal
///   place with its share of the weight.
/// - The forces of a contact that touched down within the last two knots of the previous horizon
///   also restart at their share: those near-zero forces would hold the next solve at the friction
///   cone's apex, a local optimum where the new foot stays unloaded.
///
/// Throws ContractViolation if the two problems have other contacts or vertices, or `previous`
/// other shapes than `previous_ocp`.
void ShiftedGuess(const CentroidalOcp& previous_ocp, const MpcSolution& previous, int shift_knots,
                  const CentroidalOcp& next_ocp, MpcSolution* guess);

}  // namespace sidestep::mpc
