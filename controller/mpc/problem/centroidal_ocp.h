// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// centroidal_ocp: one instance of the MPC's optimal control problem, as data.
//
// In : what planner and estimator know at one instant.      Out: input of every back end.
// Flow: estimator -> planner -> [mpc: CentroidalOcp -> back end -> MpcSolution] -> swing, wbc.
//
// Grid: states at knots k = 0..N, inputs (forces) at k = 0..N-1. Knot k lasts T_k: T, but for the
// first, which may be shorter, so that a solve between two points of a gait's grid of contact
// changes has its other knots on them. One location per contact phase: the paper's
// pdot = (1 - Gamma) v with the free swing velocity eliminated.
//
//   p[k+1]   = p[k] + T_k hp[k] / m
//   hp[k+1]  = hp[k] + T_k ( m g + F[k] + sum_ij f_ij[k] )
//   hw[k+1]  = hw[k] + T_k ( tau[k] + sum_ij ( P_iq + R_iq c_ij - p[k] ) x f_ij[k] )
//
// Cost, half the weighted squares of: p - reference, hw - reference (k = 0..N); P - nominal, once a
// knot of the phase; what a standing foot's leg lacks in length, max(0, (|r|^2 - L^2) / 2L) with r
// from ankle to hip (LegReach; close to |r| - L near L, but a square root less; 0 < k < N); what a
// foot bears above its limit, max(0, sum_j f_ijz - limit), z of W; f_ij - s_ij sum_l f_il
// (symmetry) and the forces' rates; see MpcWeights. A rate is a change from one input to the next
// over T, however short the first knot is.
//
// Source: Romualdi et al., ICRA 2022, section III. Every vector is in world W unless named.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "controller/types/mpc_params.h"

namespace sidestep::mpc {

/// One stay of a foot on the ground, active for knots first_knot <= k < end_knot (Gamma = 1).
struct ContactPhase {
  int first_knot{0};
  int end_knot{0};    ///< May exceed N + 1.
  bool fixed{false};  ///< The foot stands there at k = 0: p_WF is given, not decided.
  Eigen::Matrix3d R_WF{Eigen::Matrix3d::Identity()};
  Eigen::Vector3d p_WF{Eigen::Vector3d::Zero()};          ///< m; only if fixed.
  Eigen::Vector3d nominal_p_WF{Eigen::Vector3d::Zero()};  ///< m; only if free.
  /// lower <= R_WF^T (P - nominal) <= upper, m; only if free. Zero size is an equality.
  Eigen::Vector3d box_lower_m{Eigen::Vector3d::Zero()};
  Eigen::Vector3d box_upper_m{Eigen::Vector3d::Zero()};
};

/// How far a leg reaches: |p - P + R_WF offset| <= length, from ankle to hip, for a hip that moves
/// with the CoM and turns with the foot's heading.
struct LegReach {
  Eigen::Vector3d offset_m{Eigen::Vector3d::Zero()};  ///< In F: hip from C less ankle from F.
  double length_m{0.0};                               ///< 0: not known, no term in the cost.
};

/// One foot: its vertices and the phases that touch the horizon, in order of time.
struct OcpContact {
  std::string name;
  Eigen::Matrix3Xd vertices_m;  ///< 3 x n_v, in F. One column at the origin is a point foot.
  /// n_v, sum 1: s_j of the symmetry cost, which wants f_j = s_j sum_i f_i and so the foot's centre
  /// of pressure at sum_j s_j c_j. Empty: equal shares.
  Eigen::VectorXd force_shares;
  bool has_previous_force{false};
  Eigen::Matrix3Xd previous_force_N;  ///< 3 x n_v, in W; force applied before k = 0.
  LegReach leg;
  std::vector<ContactPhase> phases;
};

/// The whole problem.
struct CentroidalOcp {
  std::string name;
  std::string description;
  double step_s{0.1};                  ///< T.
  std::optional<double> first_step_s;  ///< T_0, if it is not T; > 0 and at most T.
  int knots{15};                       ///< N.
  double mass_kg{1.0};
  Eigen::Vector3d gravity_mps2{Eigen::Vector3d::Zero()};
  Eigen::Vector3d initial_p_WC{Eigen::Vector3d::Zero()};              ///< m.
  Eigen::Vector3d initial_linear_momentum{Eigen::Vector3d::Zero()};   ///< kg m/s.
  Eigen::Vector3d initial_angular_momentum{Eigen::Vector3d::Zero()};  ///< kg m^2/s about C.
  Eigen::Matrix3Xd reference_p_WC;                                    ///< 3 x (N+1), m.
  Eigen::Matrix3Xd reference_angular_momentum;                        ///< 3 x (N+1).
  Eigen::Matrix3Xd external_force_N;                                  ///< 3 x N.
  Eigen::Matrix3Xd external_torque_Nm;                                ///< 3 x N, about C.
  double foot_load_limit_N{0.0};  ///< At least 0. Counts only with weights.foot_load.
  MpcWeights weights;
  Eigen::MatrixX3d friction_A;  ///< rows x 3: A R^T f <= b at every vertex.
  Eigen::VectorXd friction_b;   ///< N.
  std::vector<OcpContact> contacts;

  /// T_k (s): how long input k lasts.
  double StepAt(int k) const { return k == 0 ? first_step_s.value_or(step_s) : step_s; }
};

/// The sum of force shares may differ from 1 by this much: rounding, as derivatives rely on it.
constexpr double kShareTolerance = 1e-12;

/// n_v s_j: the share of vertex j in units of an equal share, so exactly 1 if shares are equal.
double RelativeShare(const OcpContact& contact, Eigen::Index vertex);

/// Mean square of the relative shares of all vertices; at least 1, and 1 if they are equal.
double MeanSquareShare(const OcpContact& contact);

/// Index of the phase of `contact` that is active at knot k, or -1.
int ActivePhase(const OcpContact& contact, int k);

/// Throws ContractViolation if shapes, knots or phases are inconsistent (a program's bug; files
/// are checked by the reader), if force shares do not sum to 1, or if a foot's load has a negative
/// limit. An empty box (lower > upper) passes: it is an infeasible problem.
void CheckShapes(const CentroidalOcp& ocp);

/// True if every number of the problem that its optimum may depend on is finite.
bool IsFinite(const CentroidalOcp& ocp);

/// True if a free phase that touches the horizon has lower > upper: no optimum exists.
bool HasEmptyBox(const CentroidalOcp& ocp);

}  // namespace sidestep::mpc
