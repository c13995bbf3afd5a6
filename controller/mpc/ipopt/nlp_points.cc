// SPDX-License-Identifier: BSD-3-Clause
#include "controller/mpc/ipopt/nlp_points.h"

#include "controller/mpc/problem/solution_shape.h"

namespace sidestep::mpc {

void PackPoint(const CentroidalOcp& ocp, const NlpLayout& layout, const MpcSolution& point,
               Eigen::VectorXd* x) {
  x->resize(layout.num_variables());
  for (int k = 1; k <= ocp.knots; ++k) {
    const int column = layout.knots()[static_cast<std::size_t>(k)].state_column;
    x->segment<3>(column) = point.p_WC.col(k);
    x->segment<3>(column + 3) = point.linear_momentum.col(k) / ocp.mass_kg;
    x->segment<3>(column + 6) = point.angular_momentum.col(k) / ocp.mass_kg;
  }
  for (const ForceSlot& slot : layout.slots()) {
    const ContactSolution& part = point.contacts[static_cast<std::size_t>(slot.contact)];
    x->segment<3>(slot.column) =
        part.force_N[static_cast<std::size_t>(slot.knot)].col(slot.vertex) / ocp.mass_kg;
  }
  for (const FreeLocation& location : layout.locations()) {
    const auto i = static_cast<std::size_t>(location.contact);
    const auto q = static_cast<std::size_t>(location.phase);
    const ContactPhase& phase = ocp.contacts[i].phases[q];
    x->segment<3>(location.column).noalias() =
        phase.R_WF.transpose() * (point.contacts[i].phase_p_WF[q] - phase.nominal_p_WF);
  }
}

void UnpackPoint(const CentroidalOcp& ocp, const NlpLayout& layout,
                 const Eigen::Ref<const Eigen::VectorXd>& x, MpcSolution* point) {
  ResetToShape(ocp, point);
  point->p_WC.col(0) = ocp.initial_p_WC;
  point->linear_momentum.col(0) = ocp.initial_linear_momentum;
  point->angular_momentum.col(0) = ocp.initial_angular_momentum;
  for (int k = 1; k <= ocp.knots; ++k) {
    const int column = layout.knots()[static_cast<std::size_t>(k)].state_column;
    point->p_WC.col(k) = x.segment<3>(column);
    point->linear_momentum.col(k) = ocp.mass_kg * x.segment<3>(column + 3);
    point->angular_momentum.col(k) = ocp.mass_kg * x.segment<3>(column + 6);
  }
  for (const ForceSlot& slot : layout.slots()) {
    ContactSolution& part = point->contacts[static_cast<std::size_t>(slot.contact)];
    part.force_N[static_cast<std::size_t>(slot.knot)].col(slot.vertex) =
        ocp.mass_kg * x.segment<3>(slot.column);
  }
  for (const FreeLocation& location : layout.locations()) {
    const auto i = static_cast<std::size_t>(location.contact);
    const auto q = static_cast<std::size_t>(location.phase);
    const ContactPhase& phase = ocp.contacts[i].phases[q];
    point->contacts[i].phase_p_WF[q].noalias() =
        phase.nominal_p_WF + phase.R_WF * x.segment<3>(location.column);
  }
}

}  // namespace sidestep::mpc
