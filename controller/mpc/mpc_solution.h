// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mpc_solution: what a back end answers. A failed solve is a status, never an exception.

#include <Eigen/Core>
#include <vector>

namespace sidestep::mpc {

/// How a solve ended. Only kSolved carries an optimum; the rest keep the best iterate found.
enum class SolveStatus {
  kNotSolved,
  kSolved,
  kAcceptable,  ///< Stopped close to an optimum (looser tolerances).
  kInfeasible,  ///< Converged to a point of local infeasibility.
  kIterationLimit,
  kNumericalError,  ///< Non-finite input or a failed factorisation.
};

const char* ToString(SolveStatus status);

/// True if the trajectories may be used by the controller.
inline bool IsUsable(SolveStatus status) {
  return status == SolveStatus::kSolved || status == SolveStatus::kAcceptable;
}

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
