// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/make_solver.h"

#include "controller/mpc/ipopt/ipopt_solver.h"
#include "controller/mpc/structured/structured_solver.h"
#include "models/support/require.h"

namespace sidestep::mpc {

std::unique_ptr<CentroidalSolver> MakeSolver(const std::string& name,
                                             const SolverOptions& options) {
  if (name == "structured") return MakeStructuredSolver(options);
  SIDESTEP_REQUIRE(name == "ipopt", name);
  return MakeIpoptSolver(options);
}

}  // namespace sidestep::mpc
