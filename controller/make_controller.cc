// SPDX-License-Identifier: BSD-3-Clause
#include "controller/make_controller.h"

#include "controller/centroidal_controller.h"
#include "controller/locomotion_controller.h"
#include "controller/passive_controller.h"
#include "models/robot_description/sagittal_plane.h"

namespace sidestep {

std::unique_ptr<Controller> MakeController(const ControllerSetup& setup, StageTimer* timer) {
  if (setup.control.mode == ControlMode::kPassive) {
    return std::make_unique<PassiveController>(setup);
  }
  if (setup.is_centroidal) return std::make_unique<CentroidalController>(setup, timer);
  ControllerSetup seen = setup;
  seen.robot = InItsPlane(setup.robot);
  return std::make_unique<LocomotionController>(seen, timer);
}

}  // namespace sidestep
