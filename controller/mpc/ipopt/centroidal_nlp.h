// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// centroidal_nlp: a CentroidalOcp as a sparse non-linear program with exact derivatives.
//
//   min J(x)   subject to   lower <= g(x) <= upper,   x_lower <= x <= x_upper
//
// Variables and rows: see nlp_layout.h (mass-normalised). J is quadratic but for legs and loads, g
// at most bilinear: without those the Hessian of the Lagrangian does not depend on x, and its
// structure never does. Independent of any solver.
// Source: Romualdi et al., ICRA 2022, section III; derivatives by hand, checked by differences.

#include <Eigen/Core>

#include "controller/mpc/ipopt/nlp_layout.h"
#include "controller/mpc/problem/centroidal_ocp.h"

namespace sidestep::mpc {

/// Bounds beyond +-kNlpInfinity are none (Ipopt's own convention).
constexpr double kNlpInfinity = 2e19;

/// The NLP of one problem at a time. Nothing allocates once the largest problem has been set.
class CentroidalNlp {
 public:
  using ConstVector = Eigen::Ref<const Eigen::VectorXd>;
  using Vector = Eigen::Ref<Eigen::VectorXd>;

  /// Takes `ocp` (kept by reference: it must outlive its use here) and lays it out.
  /// Throws ContractViolation if CheckShapes() does.
  void SetProblem(const CentroidalOcp& ocp);

  const CentroidalOcp& ocp() const { return *ocp_; }
  const NlpLayout& layout() const { return layout_; }
  int num_variables() const { return layout_.num_variables(); }
  int num_constraints() const { return layout_.num_constraints(); }
  int num_jacobian_entries() const { return num_jacobian_entries_; }
  int num_hessian_entries() const { return num_hessian_entries_; }

  /// Of num_variables() each: boxes of free footholds, in the contact's axes (m); states and forces
  /// are free.
  void VariableBounds(Vector lower, Vector upper) const;
  /// Of num_constraints() each: dynamics first (equalities, 0), then the friction rows, which have
  /// no lower bound.
  void ConstraintBounds(Vector lower, Vector upper) const;

  /// J at x: half the weighted squares of the tasks, summed over the knots. The knot at 0, which no
  /// variable moves, is counted.
  double Cost(ConstVector x) const;
  /// dJ/dx, dense, of num_variables().
  void Gradient(ConstVector x, Vector gradient) const;
  /// g(x), of num_constraints(); explicit Euler between knots.
  void Constraints(ConstVector x, Vector g) const;

  /// Row and column of each entry of dg/dx, from 0, no entry twice. Arrays of
  /// num_jacobian_entries().
  void JacobianStructure(int* rows, int* columns) const;
  void JacobianValues(ConstVector x, double* values) const;

  /// Lower triangle, at x, of  cost_factor d2J/dx2 + sum_r multipliers[r] d2g_r/dx2, from 0, no
  /// entry twice. Arrays of num_hessian_entries().
  void HessianStructure(int* rows, int* columns) const;
  void HessianValues(ConstVector x, double cost_factor, ConstVector multipliers,
                     double* values) const;

  /// Largest violation of a constraint or bound at x in SI: momentum in kg m/s and kg m^2/s,
  /// force in N, place in m.
  double ConstraintViolation(ConstVector x) const;

 private:
  static constexpr int kPosition = 0;  // Offsets within a state.
  static constexpr int kVelocity = 3;
  static constexpr int kAngular = 6;

  void CountEntries();
  template <typename Emit>
  void VisitJacobian(const ConstVector* x, Emit&& emit) const;
  template <typename Emit>
  void VisitHessian(const ConstVector* x, double cost_factor, const ConstVector* multipliers,
                    Emit&& emit) const;
  template <typename Emit>
  void VisitForceHessian(const ConstVector* x, int slot_index, double cost_factor,
                         Emit&& emit) const;

  /// A free foothold's or a force's phase, in the problem.
  const ContactPhase& PhaseOf(int contact, int phase) const;
  /// Position, velocity or angular part of the state at knot k, mass-normalised; at 0 the measured
  /// one.
  Eigen::Vector3d StateOrInitial(ConstVector x, int k, int part) const;
  /// Place of the force in W (m), with the foothold's adjustment if it is free.
  Eigen::Vector3d VertexPosition(ConstVector x, const ForceSlot& slot) const;
  /// A leg's cost counts where it stands at 0 < k < N: once a slot of vertex 0.
  bool HasLegCost(const ForceSlot& slot) const;
  /// From ankle to hip, in W (m).
  Eigen::Vector3d AnkleToHip(ConstVector x, const ForceSlot& slot) const;
  double LegCost(ConstVector x) const;
  void AddLegGradient(ConstVector x, Vector gradient) const;
  /// In the vector from ankle to hip. Zero without x, where only the structure is asked for.
  Eigen::Matrix3d LegCurvature(const ConstVector* x, const ForceSlot& slot) const;
  /// Of the cost, in W: in the CoM at knot k, and in a foot's free place.
  Eigen::Matrix3d PositionHessian(const ConstVector* x, int k) const;
  Eigen::Matrix3d PlaceHessian(const ConstVector* x, int location) const;
  /// What the slot's foot bears at its knot above its limit, mass-normalised; 0 if within.
  double ExcessLoad(ConstVector x, const ForceSlot& slot) const;
  double LoadCost(ConstVector x) const;
  void AddLoadGradient(ConstVector x, Vector gradient) const;
  /// In each pair of the foot's vertical forces at the slot's knot. Zero without x.
  double LoadCurvature(const ConstVector* x, const ForceSlot& slot) const;
  double ForceCost(ConstVector x) const;
  void ForceGradient(ConstVector x, Vector gradient) const;
  /// Over the vertices of the slot's contact at its knot, mass-normalised.
  Eigen::Vector3d MeanForce(ConstVector x, const ForceSlot& slot) const;
  Eigen::Vector3d Asymmetry(ConstVector x, const ForceSlot& slot) const;
  Eigen::Vector3d SymmetrySlope(ConstVector x, const ForceSlot& slot) const;
  const OcpContact& ContactOf(const ForceSlot& slot) const;
  Eigen::Vector3d PreviousForce(const ForceSlot& slot) const;
  int NumVertices(const ForceSlot& slot) const;

  const CentroidalOcp* ocp_{nullptr};
  NlpLayout layout_;
  int num_jacobian_entries_{0};  ///< Counted by SetProblem(), as the next is.
  int num_hessian_entries_{0};
  mutable Eigen::VectorXd scratch_;  ///< Constraint values of ConstraintViolation().
};

}  // namespace sidestep::mpc
