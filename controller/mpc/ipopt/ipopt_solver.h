// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// ipopt_solver: the reference back end, Ipopt 3.11 with MUMPS.

#include <memory>

#include "controller/mpc/problem/centroidal_solver.h"

namespace sidestep::mpc {

/// Makes the back end "ipopt". MUMPS is not thread-safe: one at a time in a process, and with
/// OMP_NUM_THREADS=1 in the environment before the process starts.
///
/// Cold start: CoM at the reference, momenta zero, feet at their nominal places, and forces that
/// share the weight rather than zero (the paper's), which is the apex of every friction cone.
/// Warm start: the guess's primal point, the barrier parameter started small.
std::unique_ptr<CentroidalSolver> MakeIpoptSolver(const SolverOptions& options);

}  // namespace sidestep::mpc
