// SPDX-License-Identifier: BSD-3-Clause
#include "controller/grid_references.h"

#include "controller/planner/momentum_reference.h"

namespace sidestep {

void SampleReferences(const ContactSchedule& schedule, const mpc::KnotGrid& grid,
                      const Eigen::Vector3d& momentum, const MpcParams& params, double tick_s,
                      mpc::GridReferences* references) {
  references->p_WC.resize(3, params.knots + 1);
  references->angular_momentum.resize(3, params.knots + 1);
  for (int k = 0; k <= params.knots; ++k) {
    references->p_WC.col(k) = NominalComAt(schedule, grid.TickOf(k), tick_s).p_WC;
    references->angular_momentum.col(k) =
        MomentumReference(momentum, params.attitude_rate_radps, grid.StepsTo(k) * params.step_s);
  }
}

}  // namespace sidestep
