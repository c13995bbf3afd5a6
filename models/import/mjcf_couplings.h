// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// mjcf_couplings: what ties a robot's joints to each other: equalities and tendons.

#include <vector>

#include "models/import/mjcf_rewrite.h"
#include "models/import/source_robot.h"

namespace sidestep::importer {

/// Fills `parts`' mimics and couplings. An equality of joints makes the first a mimic. Loops
/// between bodies, tendons that pull and actuators of tendons are couplings: harmless where no
/// joint of theirs moves here. A tendon that only limits, and what ties a body to the world, is
/// left out with a note. A loop that names no bodies is a problem.
void FindCouplings(const XmlTree& tree, MjcfParts* parts, Problems* problems, Notes* notes);

/// Throws ConfigError with a line for each of `couplings` that one of the joints in `moving` is of.
void RefuseCouplings(const std::vector<SourceCoupling>& couplings, const std::vector<int>& moving);

}  // namespace sidestep::importer
