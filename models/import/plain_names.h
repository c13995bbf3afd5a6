// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// plain_names: names that robot.urdf, robot.yaml and what a run writes can bear.

#include "models/import/problems.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// Gives links and joints whose names are no plain words (see plain_word.h) the nearest ones that
/// are and that nothing else is called: "toe ball " becomes toe_ball. Notes what was called anew.
void MakeNamesPlain(SourceRobot* robot, Notes* notes);

}  // namespace sidestep::importer
