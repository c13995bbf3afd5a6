// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// write_mjcf: a tree of bodies as MJCF text.

#include <string>

#include "models/urdf_to_mjcf/body_tree.h"
#include "models/urdf_to_mjcf/urdf_to_mjcf.h"

namespace sidestep {

/// Writes a robot called `name`. Every number reads back as the same double. Names in `conversion`
/// that the tree lacks are left for MuJoCo's compiler to refuse.
UrdfMjcf WriteMjcf(const std::string& name, const Body& base, const UrdfConversion& conversion);

}  // namespace sidestep
