// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// make_controller: the controllers that ship, and the only switch between them.

#include <functional>
#include <memory>

#include "controller/controller.h"

namespace sidestep {

/// How a run gets its controller. The timer outlives it.
using ControllerFactory =
    std::function<std::unique_ptr<Controller>(const ControllerSetup&, StageTimer*)>;

/// The controller that the setup asks for: PassiveController for control.mode `passive`,
/// CentroidalController on the centroidal plant, LocomotionController otherwise.
/// @throws ConfigError if the robot's MJCF does not compile.
std::unique_ptr<Controller> MakeController(const ControllerSetup& setup, StageTimer* timer);

}  // namespace sidestep
