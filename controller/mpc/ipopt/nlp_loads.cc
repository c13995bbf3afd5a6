// SPDX-License-Identifier: BSD-3-Clause
// What feet bear above their limit: w/2 e^2 with e = max(0, sum_j u_jz - limit / m), once a foot
// and knot. Linear in the forces wherever it counts, so that its curvature is w in each pair of
// them.
#include <algorithm>

#include "controller/mpc/ipopt/centroidal_nlp.h"

namespace sidestep::mpc {

double CentroidalNlp::ExcessLoad(ConstVector x, const ForceSlot& slot) const {
  double load = 0.0;
  for (int j = 0; j < NumVertices(slot); ++j) {  // The vertices of a contact are neighbours.
    load += x(slot.column + 3 * (j - slot.vertex) + 2);
  }
  return std::max(0.0, load - ocp_->foot_load_limit_N / ocp_->mass_kg);
}

double CentroidalNlp::LoadCost(ConstVector x) const {
  if (ocp_->weights.foot_load == 0.0) return 0.0;
  double sum = 0.0;
  for (const ForceSlot& slot : layout_.slots()) {
    if (slot.vertex != 0) continue;
    const double excess = ExcessLoad(x, slot);
    sum += excess * excess;
  }
  return 0.5 * ocp_->weights.foot_load * sum;
}

void CentroidalNlp::AddLoadGradient(ConstVector x, Vector gradient) const {
  if (ocp_->weights.foot_load == 0.0) return;
  for (const ForceSlot& slot : layout_.slots()) {
    gradient(slot.column + 2) += ocp_->weights.foot_load * ExcessLoad(x, slot);
  }
}

double CentroidalNlp::LoadCurvature(const ConstVector* x, const ForceSlot& slot) const {
  if (x == nullptr || ocp_->weights.foot_load == 0.0) return 0.0;
  return ExcessLoad(*x, slot) > 0.0 ? ocp_->weights.foot_load : 0.0;
}

}  // namespace sidestep::mpc
