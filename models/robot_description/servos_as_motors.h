// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// servos_as_motors: an MJCF whose joints are held by MuJoCo's servos, with motors in their stead.
//
// Here the servos are ours, with the gains of robot.yaml: what they ask for is a torque.

#include <filesystem>
#include <string>

namespace sidestep {

/// `text` with a <motor> in the place of every actuator that IsJointServo(), limited as that was
/// by its forcerange, through the gear. Unchanged, to the byte, where there is none or the file
/// does not compile, which others tell.
/// @param text  Of `file`, within CheckMjcfBounds().
std::string WithServosAsMotors(const std::string& text, const std::filesystem::path& file);

}  // namespace sidestep
