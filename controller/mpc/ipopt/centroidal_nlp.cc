// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/ipopt/centroidal_nlp.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace sidestep::mpc {
namespace {

double WeightedSquare(const Eigen::Vector3d& weight, const Eigen::Vector3d& value) {
  return 0.5 * weight.dot(value.cwiseAbs2());
}

}  // namespace

void CentroidalNlp::SetProblem(const CentroidalOcp& ocp) {
  CheckShapes(ocp);
  ocp_ = &ocp;
  layout_.Build(ocp);
  scratch_.resize(num_constraints());
  CountEntries();
}

const ContactPhase& CentroidalNlp::PhaseOf(int contact, int phase) const {
  return ocp_->contacts[static_cast<std::size_t>(contact)].phases[static_cast<std::size_t>(phase)];
}

const OcpContact& CentroidalNlp::ContactOf(const ForceSlot& slot) const {
  return ocp_->contacts[static_cast<std::size_t>(slot.contact)];
}

int CentroidalNlp::NumVertices(const ForceSlot& slot) const {
  return static_cast<int>(ContactOf(slot).vertices_m.cols());
}

Eigen::Vector3d CentroidalNlp::StateOrInitial(ConstVector x, int k, int part) const {
  if (k > 0) {
    return x.segment<3>(layout_.knots()[static_cast<std::size_t>(k)].state_column + part);
  }
  if (part == kPosition) {
    return ocp_->initial_p_WC;
  }
  return (part == kVelocity ? ocp_->initial_linear_momentum : ocp_->initial_angular_momentum) /
         ocp_->mass_kg;
}

Eigen::Vector3d CentroidalNlp::VertexPosition(ConstVector x, const ForceSlot& slot) const {
  if (slot.location < 0) {
    return slot.anchor_W;
  }
  const FreeLocation& location = layout_.locations()[static_cast<std::size_t>(slot.location)];
  return slot.anchor_W + PhaseOf(slot.contact, slot.phase).R_WF * x.segment<3>(location.column);
}

void CentroidalNlp::VariableBounds(Vector lower, Vector upper) const {
  lower.setConstant(-kNlpInfinity);
  upper.setConstant(kNlpInfinity);
  for (const FreeLocation& location : layout_.locations()) {
    const ContactPhase& phase = PhaseOf(location.contact, location.phase);
    lower.segment<3>(location.column) = phase.box_lower_m;
    upper.segment<3>(location.column) = phase.box_upper_m;
  }
}

void CentroidalNlp::ConstraintBounds(Vector lower, Vector upper) const {
  const Eigen::Index num_dynamics = NlpLayout::DynamicsRow(ocp_->knots);
  lower.head(num_dynamics).setZero();
  upper.head(num_dynamics).setZero();
  lower.tail(lower.size() - num_dynamics).setConstant(-kNlpInfinity);
  for (const ForceSlot& slot : layout_.slots()) {
    upper.segment(slot.friction_row, ocp_->friction_b.size()) = ocp_->friction_b / ocp_->mass_kg;
  }
}

double CentroidalNlp::Cost(ConstVector x) const {
  const MpcWeights& weights = ocp_->weights;
  double cost = ForceCost(x) + LegCost(x) + LoadCost(x);
  for (int k = 0; k <= ocp_->knots; ++k) {
    cost +=
        WeightedSquare(weights.com, StateOrInitial(x, k, kPosition) - ocp_->reference_p_WC.col(k));
    cost += WeightedSquare(
        weights.angular_momentum,
        StateOrInitial(x, k, kAngular) - ocp_->reference_angular_momentum.col(k) / ocp_->mass_kg);
  }
  for (const FreeLocation& location : layout_.locations()) {
    const Eigen::Vector3d moved_W =
        PhaseOf(location.contact, location.phase).R_WF * x.segment<3>(location.column);
    cost += location.num_knots * WeightedSquare(weights.contact_position, moved_W);
  }
  return cost;
}

void CentroidalNlp::Constraints(ConstVector x, Vector g) const {
  for (int k = 0; k < ocp_->knots; ++k) {
    const double step_s = ocp_->StepAt(k);
    const KnotLayout& knot = layout_.knots()[static_cast<std::size_t>(k)];
    const Eigen::Vector3d p_WC = StateOrInitial(x, k, kPosition);
    Eigen::Vector3d vdot = ocp_->gravity_mps2 + ocp_->external_force_N.col(k) / ocp_->mass_kg;
    Eigen::Vector3d ldot = ocp_->external_torque_Nm.col(k) / ocp_->mass_kg;
    for (int s = knot.first_slot; s < knot.end_slot; ++s) {
      const ForceSlot& slot = layout_.slots()[static_cast<std::size_t>(s)];
      const Eigen::Vector3d u = x.segment<3>(slot.column);
      vdot += u;
      ldot += (VertexPosition(x, slot) - p_WC).cross(u);
      const Eigen::Vector3d u_F = PhaseOf(slot.contact, slot.phase).R_WF.transpose() * u;
      g.segment(slot.friction_row, ocp_->friction_A.rows()).noalias() = ocp_->friction_A * u_F;
    }
    const int row = NlpLayout::DynamicsRow(k);
    const Eigen::Vector3d v = StateOrInitial(x, k, kVelocity);
    g.segment<3>(row + kPosition) = StateOrInitial(x, k + 1, kPosition) - p_WC - step_s * v;
    g.segment<3>(row + kVelocity) = StateOrInitial(x, k + 1, kVelocity) - v - step_s * vdot;
    g.segment<3>(row + kAngular) =
        StateOrInitial(x, k + 1, kAngular) - StateOrInitial(x, k, kAngular) - step_s * ldot;
  }
}

Eigen::Vector3d CentroidalNlp::MeanForce(ConstVector x, const ForceSlot& slot) const {
  const int num_vertices = NumVertices(slot);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int j = 0; j < num_vertices; ++j) {  // The vertices of a contact are neighbours.
    sum += x.segment<3>(slot.column + 3 * (j - slot.vertex));
  }
  return sum / num_vertices;
}

// What the symmetry cost squares: u_j - s_j sum_i u_i, with s_j sum_i u_i = (n s_j) mean.
Eigen::Vector3d CentroidalNlp::Asymmetry(ConstVector x, const ForceSlot& slot) const {
  return x.segment<3>(slot.column) -
         RelativeShare(ContactOf(slot), slot.vertex) * MeanForce(x, slot);
}

Eigen::Vector3d CentroidalNlp::PreviousForce(const ForceSlot& slot) const {
  return ContactOf(slot).previous_force_N.col(slot.vertex) / ocp_->mass_kg;
}

double CentroidalNlp::ForceCost(ConstVector x) const {
  const MpcWeights& weights = ocp_->weights;
  double cost = 0.0;
  for (const ForceSlot& slot : layout_.slots()) {
    const Eigen::Vector3d u = x.segment<3>(slot.column);
    cost += WeightedSquare(weights.force_symmetry, Asymmetry(x, slot));
    if (slot.next_slot >= 0) {
      const int next = layout_.slots()[static_cast<std::size_t>(slot.next_slot)].column;
      cost += WeightedSquare(weights.force_rate, (x.segment<3>(next) - u) / ocp_->step_s);
    }
    if (slot.has_previous_force) {
      cost += WeightedSquare(weights.force_rate, (u - PreviousForce(slot)) / ocp_->step_s);
    }
    if (slot.is_new) {
      cost += WeightedSquare(weights.new_contact_force, u);
    }
  }
  return cost;
}

double CentroidalNlp::ConstraintViolation(ConstVector x) const {
  Constraints(x, scratch_);
  const int num_dynamics = NlpLayout::DynamicsRow(ocp_->knots);
  double violation = 0.0;
  for (int row = 0; row < num_dynamics; ++row) {
    const bool is_position = row % NlpLayout::kStateSize < kVelocity;
    violation = std::max(violation, std::abs(scratch_(row)) * (is_position ? 1.0 : ocp_->mass_kg));
  }
  for (const ForceSlot& slot : layout_.slots()) {
    for (Eigen::Index r = 0; r < ocp_->friction_b.size(); ++r) {
      violation = std::max(violation,
                           ocp_->mass_kg * scratch_(slot.friction_row + r) - ocp_->friction_b(r));
    }
  }
  for (const FreeLocation& location : layout_.locations()) {
    const ContactPhase& phase = PhaseOf(location.contact, location.phase);
    const Eigen::Vector3d moved = x.segment<3>(location.column);
    violation = std::max({violation, (phase.box_lower_m - moved).maxCoeff(),
                          (moved - phase.box_upper_m).maxCoeff()});
  }
  return violation;
}

}  // namespace sidestep::mpc
