// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// side_names: what a name says of left and right, by its words: left_knee, LHipYaw, FL_HAA, arm_r.

#include <string>

namespace sidestep::importer {

/// 1 for left, -1 for right, 0 for neither or both.
int SideInName(const std::string& name);

}  // namespace sidestep::importer
