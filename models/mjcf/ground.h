// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// ground: what robots and worlds must call by the same name.

namespace sidestep {

/// The geom that a world's robot stands on.
inline constexpr char kGroundGeom[] = "floor";

}  // namespace sidestep
