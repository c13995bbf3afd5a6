// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// clean_up: makes a maker's robot one that can be simulated, and says what was done.

#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// What it does:
///   root without mass        becomes a frame of the first link with mass fixed to it
///   mimic joints             move no more by themselves: fixed
///   moving link, no mass     fixed if nothing with mass hangs on it, else given some grams
///   inertia that no body has of a fixed link of less than 0.5 % of the mass: it becomes a point
///                            mass of its parent's; else its smaller principal moments are raised
///                            or, where it has none, a ball's are taken
/// Every change is a note, and a comment of the link or joint.
void CleanUp(SourceRobot* robot, Problems* problems, Notes* notes);

}  // namespace sidestep::importer
