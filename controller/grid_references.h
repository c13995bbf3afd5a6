// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// grid_references: what the MPC should follow, of a schedule, at the knots of a solve.

#include "controller/mpc/problem_builder.h"
#include "controller/planner/contact_schedule.h"
#include "controller/types/mpc_params.h"

namespace sidestep {

/// Fills `references` for the knots of `grid`: the nominal CoM of `schedule`, and the momentum that
/// is `momentum` now (momentum_reference.h). Takes memory the first time, none after.
void SampleReferences(const ContactSchedule& schedule, const mpc::KnotGrid& grid,
                      const Eigen::Vector3d& momentum, const MpcParams& params, double tick_s,
                      mpc::GridReferences* references);

}  // namespace sidestep
