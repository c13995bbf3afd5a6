// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// urdf_graph: whether a URDF's links and joints make one tree that those who recurse over it bear.

#include "models/urdf_to_mjcf/urdf_document.h"

namespace sidestep {

inline constexpr std::size_t kMaxUrdfLinks = 2000;
/// Joints from the root to a tip. The MJCF's bodies nest as deep.
inline constexpr int kMaxUrdfDepth = 80;

/// Notes every joint that names an unknown link, joins a link to itself or gives a link a second
/// parent, loops, links beside the root that hang on nothing, and what is too large. Looks at names
/// only, which CheckElements() must have seen.
void CheckGraph(UrdfDocument* document);

}  // namespace sidestep
