// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// com_spline: a quintic segment between two states of position, velocity and acceleration.

#include <Eigen/Core>

#include "controller/types/contact_plan.h"

namespace sidestep {

/// The quintic that joins `from` to `to` over `duration_s` (> 0), at `time_s` after `from`; exact
/// in position, velocity and acceleration at both ends. Outside the duration it holds the end's
/// position with zero velocity and acceleration.
ComReference QuinticAt(const ComReference& from, const ComReference& to, double duration_s,
                       double time_s);

}  // namespace sidestep
