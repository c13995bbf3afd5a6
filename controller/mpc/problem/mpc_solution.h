// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mpc_solution: what a back end answers. A failed solve is a status, never an exception.

#include <Eigen/Core>
#include <vector>

#include "controller/types/solver_status.h"

namespace sidestep::mpc {

/// A contact's part of the solution.
struct ContactSolution {
  std::vector<Eigen::Vector3d> phase_p_WF;  ///< One a phase (m), fixed ones included.
  std::vector<Eigen::Matrix3Xd> force_N;    ///< N entries, 3 x n_v each; zero where inactive.
};

struct MpcSolution {
  SolveStatus status{SolveStatus::kNotSolved};
  double cost{0.0};
  double constraint_violation{0.0};  ///< SI, infinity norm, at the unscaled point.
  double kkt_error{0.0};             ///< Infinity norm of the scaled optimality conditions.
  int iterations{0};
  Eigen::Matrix3Xd p_WC;              ///< 3 x (N+1), m.
  Eigen::Matrix3Xd linear_momentum;   ///< 3 x (N+1), kg m/s.
  Eigen::Matrix3Xd angular_momentum;  ///< 3 x (N+1), kg m^2/s about C.
  std::vector<ContactSolution> contacts;
};

}  // namespace sidestep::mpc
