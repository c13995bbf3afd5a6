// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// split_bodies: cuts bodies in two where a force/torque sensor sits inside them.

#include <vector>

#include "models/urdf_to_mjcf/body_tree.h"
#include "models/urdf_to_mjcf/urdf_to_mjcf.h"

namespace sidestep {

/// Moves the distal part of every sensor that has one into a body `<sensor>_distal`, welded to what
/// remains and with the same frame, and the sensor's frame with it. Mass, first and second moment
/// of the two together are those of the body before. Throws ContractViolation if a name is unknown,
/// a rest is no physical body or a sensor on the base has no distal part.
void SplitBodies(const std::vector<UrdfForceTorque>& sensors, Body* base);

}  // namespace sidestep
