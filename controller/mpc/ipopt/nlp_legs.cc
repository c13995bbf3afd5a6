// SPDX-License-Identifier: BSD-3-Clause
// What standing legs lack in length: w/2 e^2 with e = max(0, (|r|^2 - L^2) / 2L), see LegReach.
#include <algorithm>

#include "controller/mpc/ipopt/centroidal_nlp.h"

namespace sidestep::mpc {
namespace {

double Excess(const Eigen::Vector3d& r, double length_m) {
  return std::max(0.0, 0.5 * (r.squaredNorm() / length_m - length_m));
}

}  // namespace

bool CentroidalNlp::HasLegCost(const ForceSlot& slot) const {
  return slot.vertex == 0 && slot.knot > 0 && ContactOf(slot).leg.length_m > 0.0 &&
         ocp_->weights.leg_length > 0.0;
}

Eigen::Vector3d CentroidalNlp::AnkleToHip(ConstVector x, const ForceSlot& slot) const {
  const ContactPhase& phase = PhaseOf(slot.contact, slot.phase);
  Eigen::Vector3d p_WF = phase.fixed ? phase.p_WF : phase.nominal_p_WF;
  if (slot.location >= 0) {
    const int column = layout_.locations()[static_cast<std::size_t>(slot.location)].column;
    p_WF += phase.R_WF * x.segment<3>(column);
  }
  return StateOrInitial(x, slot.knot, kPosition) + phase.R_WF * ContactOf(slot).leg.offset_m - p_WF;
}

double CentroidalNlp::LegCost(ConstVector x) const {
  double sum = 0.0;
  for (const ForceSlot& slot : layout_.slots()) {
    if (!HasLegCost(slot)) continue;
    const double excess = Excess(AnkleToHip(x, slot), ContactOf(slot).leg.length_m);
    sum += excess * excess;
  }
  return 0.5 * ocp_->weights.leg_length * sum;
}

void CentroidalNlp::AddLegGradient(ConstVector x, Vector gradient) const {
  for (const ForceSlot& slot : layout_.slots()) {
    if (!HasLegCost(slot)) continue;
    const double length_m = ContactOf(slot).leg.length_m;
    const Eigen::Vector3d r = AnkleToHip(x, slot);
    const Eigen::Vector3d slope = ocp_->weights.leg_length * Excess(r, length_m) / length_m * r;
    const int state = layout_.knots()[static_cast<std::size_t>(slot.knot)].state_column + kPosition;
    gradient.segment<3>(state) += slope;
    if (slot.location < 0) continue;
    const int place = layout_.locations()[static_cast<std::size_t>(slot.location)].column;
    gradient.segment<3>(place) -= PhaseOf(slot.contact, slot.phase).R_WF.transpose() * slope;
  }
}

Eigen::Matrix3d CentroidalNlp::LegCurvature(const ConstVector* x, const ForceSlot& slot) const {
  if (x == nullptr) return Eigen::Matrix3d::Zero();
  const double length_m = ContactOf(slot).leg.length_m;
  const Eigen::Vector3d r = AnkleToHip(*x, slot);
  const double excess = Excess(r, length_m);
  if (excess == 0.0) return Eigen::Matrix3d::Zero();
  return ocp_->weights.leg_length / length_m *
         (r * r.transpose() / length_m + excess * Eigen::Matrix3d::Identity());
}

Eigen::Matrix3d CentroidalNlp::PositionHessian(const ConstVector* x, int k) const {
  Eigen::Matrix3d hessian = ocp_->weights.com.asDiagonal();
  const KnotLayout& knot = layout_.knots()[static_cast<std::size_t>(k)];
  for (int s = knot.first_slot; s < knot.end_slot; ++s) {
    const ForceSlot& slot = layout_.slots()[static_cast<std::size_t>(s)];
    if (HasLegCost(slot)) hessian += LegCurvature(x, slot);
  }
  return hessian;
}

Eigen::Matrix3d CentroidalNlp::PlaceHessian(const ConstVector* x, int location) const {
  const int num_knots = layout_.locations()[static_cast<std::size_t>(location)].num_knots;
  Eigen::Matrix3d hessian = (num_knots * ocp_->weights.contact_position).asDiagonal();
  for (const ForceSlot& slot : layout_.slots()) {
    if (slot.location == location && HasLegCost(slot)) hessian += LegCurvature(x, slot);
  }
  return hessian;
}

}  // namespace sidestep::mpc
