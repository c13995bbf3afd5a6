// SPDX-License-Identifier: BSD-3-Clause
#include "controller/passive_controller.h"

namespace sidestep {

PassiveController::PassiveController(const ControllerSetup& setup)
    : is_centroidal_(setup.is_centroidal) {}

const ControlTick& PassiveController::Update(const SensorFrame& frame) {
  tick_.tick = frame.tick;
  // No foot of a centroidal command means no force.
  if (!is_centroidal_) tick_.command.torque_Nm.setZero(frame.joint_position.size());
  return tick_;
}

std::unique_ptr<Controller> PassiveController::Clone(StageTimer* /*timer*/) const {
  return std::make_unique<PassiveController>(*this);
}

}  // namespace sidestep
