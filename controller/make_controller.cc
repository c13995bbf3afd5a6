// SPDX-License-Identifier: BSD-3-Clause
#include "controller/make_controller.h"

#include "controller/centroidal_controller.h"
#include "controller/locomotion_controller.h"
#include "controller/passive_controller.h"

namespace sidestep {

std::unique_ptr<Controller> MakeController(const ControllerSetup& setup, StageTimer* timer) {
  if (setup.control.mode == ControlMode::kPassive) {
    return std::make_unique<PassiveController>(setup);
  }
  if (setup.is_centroidal) return std::make_unique<CentroidalController>(setup, timer);
  return std::make_unique<LocomotionController>(setup, timer);
}

}  // namespace sidestep
