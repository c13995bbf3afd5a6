// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// gravity: the one figure that both plants, the controller and the verdict share.

namespace sidestep {

/// As both plants have it unless a model says otherwise.
inline constexpr double kGravity_mps2 = 9.81;

}  // namespace sidestep
