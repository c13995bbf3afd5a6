// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// toy_robot: a biped of 20 kg with box feet that bear on a point, for tests that need a robot to
// draw and to describe.

#include <filesystem>

#include "models/robot_description/robot_description.h"

namespace sidestep::testing {

/// The toy: MJCF `toy.xml` and `robot.yaml` written to `dir`, which is created, with its
/// description: feet `left` and `right`.
RobotDescription WriteToyRobot(const std::filesystem::path& dir);

}  // namespace sidestep::testing
