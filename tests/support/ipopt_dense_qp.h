// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// ipopt_dense_qp: a dense QP solved by Ipopt, for tests to compare with.

#include <Eigen/Core>

#include "controller/wbc/qp/dense_qp.h"

namespace sidestep::wbc {

struct IpoptQpResult {
  bool is_solved{false};
  bool is_infeasible{false};
  Eigen::VectorXd x;  ///< n; empty unless solved.
};

/// Solves `problem` to `tolerance` with bounds kept exactly (no relaxation), after dropping the
/// equalities that depend on others.
IpoptQpResult SolveWithIpopt(const DenseQpProblem& problem, double tolerance);

}  // namespace sidestep::wbc
