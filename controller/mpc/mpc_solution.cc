// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/mpc_solution.h"

namespace sidestep::mpc {

const char* ToString(SolveStatus status) {
  switch (status) {
    case SolveStatus::kNotSolved:
      return "not_solved";
    case SolveStatus::kSolved:
      return "solved";
    case SolveStatus::kAcceptable:
      return "acceptable";
    case SolveStatus::kInfeasible:
      return "infeasible";
    case SolveStatus::kIterationLimit:
      return "iteration_limit";
    case SolveStatus::kNumericalError:
      return "numerical_error";
  }
  return "unknown";
}

}  // namespace sidestep::mpc
