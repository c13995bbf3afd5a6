// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gravity: the one figure of the importer, the centroidal plant, the controller and the verdict;
// MuJoCo's default.

namespace sidestep {

/// As both plants have it unless a model says otherwise.
inline constexpr double kGravity_mps2 = 9.81;

}  // namespace sidestep
