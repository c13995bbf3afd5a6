// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// centroidal_solver: the small interface behind which back ends solve a CentroidalOcp.

#include <memory>
#include <utility>

#include "controller/mpc/problem/centroidal_ocp.h"
#include "controller/mpc/problem/mpc_solution.h"

namespace sidestep::mpc {

/// Options every back end understands. It stops on iterations and residuals, never on time.
struct SolverOptions {
  double tolerance{1e-8};
  int max_iterations{200};
};

/// A solver of CentroidalOcp. Not thread-safe; one instance a controller. Its answer depends on the
/// problem, the guess and the options alone: what it keeps between solves is memory, not knowledge.
class CentroidalSolver {
 public:
  virtual ~CentroidalSolver() = default;

  /// Solves `ocp`. `guess` (may be null: cold start) is a primal starting point on the same grid
  /// and contact schedule, usually ShiftedGuess() of the previous solution; shapes must match.
  /// The reference stays valid until the next call. Never throws on a hard problem.
  virtual const MpcSolution& Solve(const CentroidalOcp& ocp, const MpcSolution* guess) = 0;

  /// The cost of what Solve() would find, for a choice among problems: to about a thousandth, and
  /// infinite if it seems dearer than `ceiling` or nothing is found. Solve()'s answer is lost.
  virtual double Weigh(const CentroidalOcp& ocp, const MpcSolution* guess, double ceiling) = 0;

  /// A solver with the same options, which answers every problem bit for bit as this one does. It
  /// shares nothing with this one, and its memory grows anew.
  virtual std::unique_ptr<CentroidalSolver> Clone() const = 0;
};

}  // namespace sidestep::mpc
