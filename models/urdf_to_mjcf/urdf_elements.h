// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// urdf_elements: links and joints of a URDF, each looked at alone.

#include "models/urdf_to_mjcf/urdf_document.h"

namespace sidestep {

/// Of all links together. Public humanoids have a hundred; MuJoCo compiles ten thousand in minutes.
inline constexpr int kMaxUrdfShapes = 4000;

/// Makes of the document what urdfdom takes: removes what only simulators, drivers or drawing
/// tools read, mends what is harmless and gives notice of it, and notes every problem: names that
/// are missing, no plain words or there twice, numbers that are none or not finite, what is
/// required and missing, shapes without a size.
void CheckElements(UrdfDocument* document);

/// Colours: names the nameless, lets go of those that are defined nowhere or badly. They are only
/// looked at, so that none is a problem. Part of CheckElements().
void MendMaterials(UrdfDocument* document);

}  // namespace sidestep
