// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// side_names: what a name says by its words, of left and right: left_knee, LHipYaw, FL_HAA, arm_r;
// and of arms and legs.

#include <string>

namespace sidestep::importer {

/// 1 for left, -1 for right, 0 for neither or both.
int SideInName(const std::string& name);

/// 1 for a part of a leg (hip, knee, ankle, foot), -1 for one of an arm (shoulder, elbow, wrist,
/// hand), 0 for neither or both.
int LegInName(const std::string& name);

}  // namespace sidestep::importer
