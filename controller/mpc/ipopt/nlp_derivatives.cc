// SPDX-License-Identifier: BSD-3-Clause
// First and second derivatives of CentroidalNlp. One visitor per matrix gives both its structure
// and its values, so the two cannot disagree.
#include "controller/mpc/ipopt/centroidal_nlp.h"
#include "controller/mpc/ipopt/skew.h"

namespace sidestep::mpc {

void CentroidalNlp::Gradient(ConstVector x, Vector gradient) const {
  const MpcWeights& weights = ocp_->weights;
  gradient.setZero();
  for (int k = 1; k <= ocp_->knots; ++k) {
    const int column = layout_.knots()[static_cast<std::size_t>(k)].state_column;
    gradient.segment<3>(column + kPosition) =
        weights.com.cwiseProduct(x.segment<3>(column + kPosition) - ocp_->reference_p_WC.col(k));
    gradient.segment<3>(column + kAngular) = weights.angular_momentum.cwiseProduct(
        x.segment<3>(column + kAngular) - ocp_->reference_angular_momentum.col(k) / ocp_->mass_kg);
  }
  for (const FreeLocation& location : layout_.locations()) {
    const Eigen::Matrix3d& R_WF = PhaseOf(location.contact, location.phase).R_WF;
    const Eigen::Vector3d moved_W = R_WF * x.segment<3>(location.column);
    gradient.segment<3>(location.column).noalias() =
        location.num_knots * R_WF.transpose() * weights.contact_position.cwiseProduct(moved_W);
  }
  ForceGradient(x, gradient);
  AddLegGradient(x, gradient);
  AddLoadGradient(x, gradient);
}

// Of half the sum of squared asymmetries e_i of a contact, in u_j: e_j - sum_i s_i e_i. As the
// asymmetries sum to zero, equal shares make the last sum so; written as the excess over equal
// shares it is zero without rounding.
Eigen::Vector3d CentroidalNlp::SymmetrySlope(ConstVector x, const ForceSlot& slot) const {
  const int num_vertices = NumVertices(slot);
  Eigen::Vector3d excess = Eigen::Vector3d::Zero();
  for (int i = 0; i < num_vertices; ++i) {
    const ForceSlot& other =
        layout_.slots()[static_cast<std::size_t>(&slot - layout_.slots().data() + i - slot.vertex)];
    excess += (RelativeShare(ContactOf(slot), i) - 1.0) * Asymmetry(x, other);
  }
  return Asymmetry(x, slot) - excess / num_vertices;
}

void CentroidalNlp::ForceGradient(ConstVector x, Vector gradient) const {
  const MpcWeights& weights = ocp_->weights;
  const double inverse_square = 1.0 / (ocp_->step_s * ocp_->step_s);
  for (const ForceSlot& slot : layout_.slots()) {
    const Eigen::Vector3d u = x.segment<3>(slot.column);
    Eigen::Vector3d slope = weights.force_symmetry.cwiseProduct(SymmetrySlope(x, slot));
    Eigen::Vector3d jumps = Eigen::Vector3d::Zero();
    if (slot.next_slot >= 0) {
      jumps += u - x.segment<3>(layout_.slots()[static_cast<std::size_t>(slot.next_slot)].column);
    }
    if (slot.previous_slot >= 0) {
      jumps +=
          u - x.segment<3>(layout_.slots()[static_cast<std::size_t>(slot.previous_slot)].column);
    }
    if (slot.has_previous_force) {
      jumps += u - PreviousForce(slot);
    }
    slope += inverse_square * weights.force_rate.cwiseProduct(jumps);
    if (slot.is_new) {
      slope += weights.new_contact_force.cwiseProduct(u);
    }
    gradient.segment<3>(slot.column) = slope;
  }
}

template <typename Emit>
void CentroidalNlp::VisitJacobian(const ConstVector* x, Emit&& emit) const {
  for (int k = 0; k < ocp_->knots; ++k) {
    const double step_s = ocp_->StepAt(k);
    const KnotLayout& knot = layout_.knots()[static_cast<std::size_t>(k)];
    const int row = NlpLayout::DynamicsRow(k);
    const int next = layout_.knots()[static_cast<std::size_t>(k + 1)].state_column;
    for (int a = 0; a < NlpLayout::kStateSize; ++a) {
      emit(row + a, next + a, 1.0);
      if (k > 0) {
        emit(row + a, knot.state_column + a, -1.0);
      }
    }
    if (k > 0) {
      EmitDiagonal(row + kPosition, knot.state_column + kVelocity, -step_s, emit);
    }
    const Eigen::Vector3d p_WC = x ? StateOrInitial(*x, k, kPosition) : Eigen::Vector3d::Zero();
    Eigen::Vector3d sum_all = Eigen::Vector3d::Zero();
    Eigen::Vector3d sum_contact = Eigen::Vector3d::Zero();
    for (int s = knot.first_slot; s < knot.end_slot; ++s) {
      const ForceSlot& slot = layout_.slots()[static_cast<std::size_t>(s)];
      const Eigen::Matrix3d& R_WF = PhaseOf(slot.contact, slot.phase).R_WF;
      Eigen::Vector3d arm_W = Eigen::Vector3d::Zero();
      if (x) {
        const Eigen::Vector3d u = x->segment<3>(slot.column);
        sum_contact = slot.vertex == 0 ? u : Eigen::Vector3d(sum_contact + u);
        sum_all += u;
        arm_W = VertexPosition(*x, slot) - p_WC;
      }
      EmitDiagonal(row + kVelocity, slot.column, -step_s, emit);
      EmitSkew(row + kAngular, slot.column, -step_s * arm_W, emit);
      // d (R d) x u = -[u]x R dd, summed over the vertices of the contact.
      if (slot.location >= 0 && slot.vertex + 1 == NumVertices(slot)) {
        const int column = layout_.locations()[static_cast<std::size_t>(slot.location)].column;
        EmitDense(row + kAngular, column, Skew(step_s * sum_contact) * R_WF, emit);
      }
      for (int r = 0; r < static_cast<int>(ocp_->friction_A.rows()); ++r) {
        const Eigen::RowVector3d face_W = ocp_->friction_A.row(r) * R_WF.transpose();
        for (int a = 0; a < 3; ++a) {
          emit(slot.friction_row + r, slot.column + a, face_W(a));
        }
      }
    }
    if (k > 0 && knot.end_slot > knot.first_slot) {
      EmitSkew(row + kAngular, knot.state_column + kPosition, -step_s * sum_all, emit);
    }
  }
}

template <typename Emit>
void CentroidalNlp::VisitHessian(const ConstVector* x, double cost_factor,
                                 const ConstVector* multipliers, Emit&& emit) const {
  const MpcWeights& weights = ocp_->weights;
  for (int k = 1; k <= ocp_->knots; ++k) {
    const int column = layout_.knots()[static_cast<std::size_t>(k)].state_column;
    const bool has_legs = weights.leg_length > 0.0;
    if (has_legs) EmitLower(column + kPosition, cost_factor * PositionHessian(x, k), emit);
    for (int a = 0; a < 3; ++a) {
      if (!has_legs) {
        emit(column + kPosition + a, column + kPosition + a, cost_factor * weights.com(a));
      }
      emit(column + kAngular + a, column + kAngular + a, cost_factor * weights.angular_momentum(a));
    }
  }
  for (int i = 0; i < static_cast<int>(layout_.locations().size()); ++i) {
    const FreeLocation& location = layout_.locations()[static_cast<std::size_t>(i)];
    const Eigen::Matrix3d& R_WF = PhaseOf(location.contact, location.phase).R_WF;
    EmitLower(location.column, cost_factor * R_WF.transpose() * PlaceHessian(x, i) * R_WF, emit);
  }
  for (int s = 0; s < static_cast<int>(layout_.slots().size()); ++s) {
    VisitForceHessian(x, s, cost_factor, emit);
    // lambda . ((R d - p) x u) = u . [lambda]x (R d - p) has d2/du dp = -[lambda]x and
    // d2/dd du = -R' [lambda]x; the row carries it times -T_k.
    const ForceSlot& slot = layout_.slots()[static_cast<std::size_t>(s)];
    Eigen::Vector3d lambda = Eigen::Vector3d::Zero();
    if (multipliers) {
      lambda = ocp_->StepAt(slot.knot) *
               multipliers->segment<3>(NlpLayout::DynamicsRow(slot.knot) + kAngular);
    }
    if (slot.knot > 0) {
      EmitSkew(slot.column,
               layout_.knots()[static_cast<std::size_t>(slot.knot)].state_column + kPosition,
               lambda, emit);
    }
    if (slot.location >= 0) {
      const Eigen::Matrix3d& R_WF = PhaseOf(slot.contact, slot.phase).R_WF;
      if (HasLegCost(slot)) {
        EmitDense(layout_.locations()[static_cast<std::size_t>(slot.location)].column,
                  layout_.knots()[static_cast<std::size_t>(slot.knot)].state_column + kPosition,
                  -cost_factor * R_WF.transpose() * LegCurvature(x, slot), emit);
      }
      EmitDense(layout_.locations()[static_cast<std::size_t>(slot.location)].column, slot.column,
                R_WF.transpose() * Skew(lambda), emit);
    }
  }
}

template <typename Emit>
void CentroidalNlp::VisitForceHessian(const ConstVector* x, int slot_index, double cost_factor,
                                      Emit&& emit) const {
  const ForceSlot& slot = layout_.slots()[static_cast<std::size_t>(slot_index)];
  const MpcWeights& weights = ocp_->weights;
  const OcpContact& contact = ContactOf(slot);
  const double equal_share = 1.0 / NumVertices(slot);
  // Of half the squared asymmetries in u_i and u_j: 1 (if i = j) - s_i - s_j + sum_l s_l^2.
  const auto coupling = [&](int i, int j) {
    return equal_share *
           (RelativeShare(contact, i) + RelativeShare(contact, j) - MeanSquareShare(contact));
  };
  const double inverse_square = 1.0 / (ocp_->step_s * ocp_->step_s);
  const int num_rates = (slot.next_slot >= 0 ? 1 : 0) + (slot.previous_slot >= 0 ? 1 : 0) +
                        (slot.has_previous_force ? 1 : 0);
  const double load = cost_factor * LoadCurvature(x, slot);
  for (int a = 0; a < 3; ++a) {
    const double rate = weights.force_rate(a) * inverse_square;
    const double symmetry = weights.force_symmetry(a);
    const double above = a == 2 ? load : 0.0;  // Dense within a foot, as the symmetry is.
    emit(slot.column + a, slot.column + a,
         cost_factor * (symmetry * (1.0 - coupling(slot.vertex, slot.vertex)) + num_rates * rate +
                        (slot.is_new ? weights.new_contact_force(a) : 0.0)) +
             above);
    for (int j = 0; j < slot.vertex; ++j) {  // The vertices of a contact are neighbours.
      emit(slot.column + a, slot.column + a - 3 * (slot.vertex - j),
           -cost_factor * symmetry * coupling(j, slot.vertex) + above);
    }
    if (slot.previous_slot >= 0) {
      const int before = layout_.slots()[static_cast<std::size_t>(slot.previous_slot)].column;
      emit(slot.column + a, before + a, -cost_factor * rate);
    }
  }
}

void CentroidalNlp::JacobianStructure(int* rows, int* columns) const {
  VisitJacobian(nullptr, [&](int row, int column, double) {
    *rows++ = row;
    *columns++ = column;
  });
}

void CentroidalNlp::JacobianValues(ConstVector x, double* values) const {
  VisitJacobian(&x, [&](int, int, double value) { *values++ = value; });
}

void CentroidalNlp::HessianStructure(int* rows, int* columns) const {
  VisitHessian(nullptr, 1.0, nullptr, [&](int row, int column, double) {
    *rows++ = row;
    *columns++ = column;
  });
}

void CentroidalNlp::HessianValues(ConstVector x, double cost_factor, ConstVector multipliers,
                                  double* values) const {
  VisitHessian(&x, cost_factor, &multipliers, [&](int, int, double value) { *values++ = value; });
}

void CentroidalNlp::CountEntries() {
  num_jacobian_entries_ = 0;
  VisitJacobian(nullptr, [this](int, int, double) { ++num_jacobian_entries_; });
  num_hessian_entries_ = 0;
  VisitHessian(nullptr, 1.0, nullptr, [this](int, int, double) { ++num_hessian_entries_; });
}

}  // namespace sidestep::mpc
