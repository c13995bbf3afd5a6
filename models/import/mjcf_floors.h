// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_floors: contact pairs of a robot whose floor is in another file.

#include "models/import/problems.h"
#include "models/import/xml_tree.h"

namespace sidestep::importer {

/// A robot's file often has pairs of its feet with the floor of the scene that includes it; and
/// height fields were left out. Puts planes into the world for the geoms that pairs name and that
/// it lacks, so that the robot's shapes of those pairs collide; takes out pairs of which it has
/// neither geom.
void StandInForFloors(XmlElement* worldbody, XmlElement* contact, Notes* notes);

}  // namespace sidestep::importer
