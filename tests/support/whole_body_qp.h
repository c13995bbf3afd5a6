// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// whole_body_qp: random QPs with the sizes, sparsity and ranks of the whole-body controller's.

#include "tests/support/random_dense_qp.h"

namespace sidestep::wbc {

/// min |J x - v|^2 + small |x|^2 over 29 velocities, 15 exact rows, 2 x 23 limits.
DenseQpProblem MakeVelocityQp(SeededNumbers& numbers);

/// 9 accelerations and a point foot's force; 3 rows of dynamics, 3 of contact, 3 of exact task.
DenseQpProblem MakeHopperQp(SeededNumbers& numbers);

/// 29 accelerations, 8 corner forces, 6 slacks; 36 equalities of rank 24; friction pyramids,
/// torque and acceleration limits; two corners in the air with 0 <= f_z <= 0.
DenseQpProblem MakeTorqueQp(SeededNumbers& numbers);

}  // namespace sidestep::wbc
